#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Workspace.h>

namespace insonate::ui {

Workspace::Workspace(QWidget* parent) : QWidget(parent), commands_(new Commands(this)) {}

TaskBar& Workspace::tasks() {
  if (!tasks_) tasks_ = new TaskBar(this);
  return *tasks_;
}

}  // namespace insonate::ui
