#pragma once

#include <span>

class QKeyEvent;

namespace insonate::review {

/// Commands of this workspace that have a key.
enum class Command {
  Play,
  Step,
  StepMoment,
  Begin,
  End,
  Slower,
  Faster,
  ShowReplay,
  ShowResult,
  ShowLook,
  ShowJudging,
  List
};

/// One row of the key table, which defines the keys' commands and is also listed for the user. Rows without a key are
/// only listed; the views handle their keys.
struct KeyRow {
  int key = 0;  ///< Qt::Key; 0: no key
  Command command{};
  double by = 0, wide = 0;  ///< for Step: seconds, `wide` with Shift; for StepMoment: direction
  const char* keys = "";    ///< keys as listed for the user; empty for rows that share the line above
  const char* meaning = "";
};

std::span<const KeyRow> keyTable();
/// Returns the row of a key; null if the key has no command here.
const KeyRow* rowFor(const QKeyEvent& event);

}  // namespace insonate::review
