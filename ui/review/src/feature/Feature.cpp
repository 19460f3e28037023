#include "Feature.h"

#include "../ReviewSession.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ui/Workspace.h>

#include <utility>

namespace insonate::review {

Feature::Feature(const ReviewModel& model) : model_(model) {}

void Feature::addForAttempt(ui::Command command) {
  command.isAvailable = [&session = model_.session] { return session.attempt() != nullptr; };
  model_.workspace.commands().add(std::move(command));
}

void Feature::passKeysOf(QWidget& canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Commands, *this);
}

bool Feature::eventFilter(QObject*, QEvent* event) {
  return model_.workspace.commands().handleKeyEvent(*event);
}

}  // namespace insonate::review
