// The part of the window that closes it, and the keys that it passes on to the workspace.
#include <insonate/ui/MainWindow.h>

#include <QCoreApplication>
#include <QKeyEvent>
#include <QMenu>

namespace insonate::ui {

void MainWindow::closeAtOnce() {
  sure_ = true;
  close();
}

bool MainWindow::passKey(QKeyEvent& event) {
  // Space freezes wherever the keyboard focus is. Keys that the workspace does not use return to the window.
  Workspace* workspace = currentWorkspace();
  if (passing_ || !workspace || workspace->isAncestorOf(focusWidget()) || focusWidget() == workspace) return false;
  passing_ = true;
  QCoreApplication::sendEvent(workspace, &event);
  passing_ = false;
  return event.isAccepted();
}

void MainWindow::fillView() {
  view_->clear();
  view_->setToolTipsVisible(true);
  view_->addActions(currentWorkspace()->actions());
  if (view_->isEmpty()) view_->addAction(tr("Nothing to choose here"))->setEnabled(false);
}

}  // namespace insonate::ui
