#include <insonate/ui/Sound.h>
#include <insonate/ui/TaskBar.h>
#include <insonate/ui/Workspace.h>

namespace insonate::ui {

Workspace::Workspace(QWidget* parent) : QWidget(parent), commands_(new Commands(this)) {}

TaskBar& Workspace::tasks() {
  if (!tasks_) tasks_ = new TaskBar(this);
  return *tasks_;
}

Sound& Workspace::sound() {
  if (!sound_) sound_ = new Sound(this);
  return *sound_;
}

}  // namespace insonate::ui
