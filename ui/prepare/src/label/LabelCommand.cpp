#include "LabelCommand.h"

#include "LabelSession.h"

#include <utility>

namespace insonate::prepare {

void LabelCommand::undo() {
  int undone = 0;
  while (undone < steps_ && session_.undo()) ++undone;
  if (undone == steps_) return;
  // All or nothing; the stack forgets it, too.
  for (; undone > 0; --undone) session_.redo();
  setObsolete(true);
}

void LabelCommand::redo() {
  if (std::exchange(isDone_, false)) return;
  for (int step = 0; step < steps_; ++step) session_.redo();
}

bool LabelCommand::mergeWith(const QUndoCommand* next) {
  const auto& other = static_cast<const LabelCommand&>(*next);
  if (of_.empty() || of_ != other.of_) return false;
  steps_ += other.steps_;
  return true;
}

}  // namespace insonate::prepare
