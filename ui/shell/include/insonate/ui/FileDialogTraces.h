#pragma once

class QApplication;

namespace insonate::ui {

/// Qt's file dialogs store in Qt's settings which folders they have shown. After this call, these folders are removed
/// from the settings whenever a file dialog of the application has closed. This protects patients, since hospitals
/// often name folders after patients. Call the function once.
void removeFileDialogTraces(QApplication& application);

}  // namespace insonate::ui
