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

/// One row of the only table of keys: it decides what a key does, and lists it for the user. Rows without a key are
/// listed only: the views do them.
struct KeyRow {
  int key = 0;  ///< Qt::Key; 0 for none
  Command command{};
  double by = 0, wide = 0;  ///< of Step in seconds, wide with shift; of StepMoment a direction
  const char* keys = "";    ///< as the user knows it; empty on rows that share the line above
  const char* meaning = "";
};

std::span<const KeyRow> keyTable();
/// Row of a key; null for a key without a command here.
const KeyRow* rowFor(const QKeyEvent& event);

}  // namespace insonate::review
