#include "LabelCommand.h"

#include <utility>

namespace insonate::prepare {

void LabelCommand::undo() {
  int undone = 0;
  while (undone < steps_ && undo_()) ++undone;
  if (undone == steps_) return;
  // All or nothing; the stack forgets it, too.
  for (; undone > 0; --undone) redo_();
  setObsolete(true);
}

void LabelCommand::redo() {
  if (std::exchange(isDone_, false)) return;
  for (int step = 0; step < steps_; ++step) redo_();
}

bool LabelCommand::mergeWith(const QUndoCommand* next) {
  const auto& other = static_cast<const LabelCommand&>(*next);
  if (of_.empty() || of_ != other.of_) return false;
  steps_ += other.steps_;
  return true;
}

}  // namespace insonate::prepare
