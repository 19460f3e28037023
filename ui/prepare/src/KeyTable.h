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
  Tool,  ///< selects the tool of the row's key
  LastTool,
  ApplyTool,
  LeaveTool,
  LargerBrush,
  SmallerBrush,
  LockStructure,
  NextState
};

/// One row of the key table, which defines the keys' commands and is also listed for the user. Rows without a key are
/// only listed; the views or the window's actions handle their keys.
struct KeyRow {
  int key = 0;  ///< Qt::Key; 0: no key
  Command command{};
  const char* keys = "";  ///< keys as listed for the user; empty for rows that share the line above
  const char* meaning = "";
};

std::span<const KeyRow> keyTable();
/// Returns the row of a key; null if the key has no command here.
const KeyRow* rowFor(const QKeyEvent& event);

}  // namespace insonate::prepare
