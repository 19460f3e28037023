#pragma once

#include <span>

class QKeyEvent;

namespace insonate::prepare {

/// Commands of this workspace that have a key.
enum class Command {
  LabelsFainter,
  LabelsStronger,
  ToggleLabels,
  PreviousStructure,
  NextStructure,
  ToggleStructure,
  CheckPage,
  Start,
  Tool,  ///< of the row's key
  LastTool,
  ApplyTool,
  LeaveTool,
  LargerBrush,
  SmallerBrush,
  LockStructure,
  NextState
};

/// One row of the only table of keys: it decides what a key does, and lists it for the user. Rows without a key are
/// listed only: the views or the window's actions do them.
struct KeyRow {
  int key = 0;  ///< Qt::Key; 0 for none
  Command command{};
  const char* keys = "";  ///< as the user knows it; empty on rows that share the line above
  const char* meaning = "";
};

std::span<const KeyRow> keyTable();
/// Row of a key; null for a key without a command here.
const KeyRow* rowFor(const QKeyEvent& event);

}  // namespace insonate::prepare
