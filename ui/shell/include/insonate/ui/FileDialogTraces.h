#pragma once

class QApplication;

namespace insonate::ui {

/// Removes from Qt's settings, whenever a file dialog of the application has closed, the folders that Qt's file dialogs
/// have shown and Qt has stored. This protects patients, since hospitals often name folders after patients. Call the
/// function once.
void removeFileDialogTraces(QApplication& application);

}  // namespace insonate::ui
