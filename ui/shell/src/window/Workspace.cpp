#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Workspace.h>

namespace insonate::ui {

TaskBar& Workspace::tasks() {
  if (!tasks_) tasks_ = new TaskBar(this);
  return *tasks_;
}

}  // namespace insonate::ui
