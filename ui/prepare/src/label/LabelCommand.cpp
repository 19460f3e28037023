#include "LabelCommand.h"

#include "LabelSession.h"

#include <utility>

namespace insonate::prepare {

void LabelCommand::undo() {
  // The stack forgets it, too.
  setObsolete(!session_.undo());
}

void LabelCommand::redo() {
  if (!std::exchange(isDone_, false)) session_.redo();
}

}  // namespace insonate::prepare
