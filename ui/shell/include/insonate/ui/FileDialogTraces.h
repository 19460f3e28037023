#pragma once

class QApplication;

namespace insonate::ui {

/// Qt stores the folders that its file dialogs have shown, and folders of hospitals are named after patients. Removes
/// these folders from Qt's settings whenever one of the application's file dialogs has closed. Call it once.
void removeFileDialogTraces(QApplication& application);

}  // namespace insonate::ui
