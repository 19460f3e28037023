#pragma once

#include "../model/HandsControl.h"
#include "../model/ProbeControl.h"

#include <QString>
#include <span>

class QKeyEvent;

namespace insonate::train {

/// Commands of this workspace that have a key.
enum class Command {
  Move,
  Freeze,
  Home,
  Recall,
  Undo,
  Redo,
  EarlierPicture,
  LaterPicture,
  SavePicture,
  MeasureDistance,
  MeasureEllipse,
  MeasureAngle,
  StopMeasuring,
  ClearMeasures,
  NextEffect,
  WholePicture,
  CtBeside,
  ShowTissue,
  AllSlices,
  SliceWindow,
  TakeNeedle,
  MoveNeedle,
  Attempt,
  Draw,
  NewNeedle,
  CutAtNeedle,
  ShowCourse,
};

/// One row of the key table, which defines the keys' commands and is also listed for the user.
struct KeyRow {
  int key = 0;           ///< Qt::Key
  bool control = false;  ///< Ctrl must be held
  Command command;
  HandAxis axis{};            ///< direction, for commands that move the probe
  double step = 0, wide = 0;  ///< distance in mm or degrees; `wide` with Shift
  int place = 0;              ///< index from 0, for recalling positions, window presets and TissueShown::toggle()
  const char* keys;           ///< keys as listed for the user; empty for rows that share the line above
  const char* meaning;
  bool alt = false;     ///< Alt must be held
  NeedleAxis needle{};  ///< direction, for commands that move the needle
};

std::span<const KeyRow> keyTable();

/// Returns the row of a key; null if the key has no command here.
const KeyRow* rowFor(const QKeyEvent& event);

/// A mouse action, for the same list.
struct MouseRow {
  const char* gesture;
  const char* meaning;
};
std::span<const MouseRow> mouseTable();

inline constexpr double kWheelPress_mm = 0.5, kWheelDepth_mm = 5, kWheelNeedle_mm = 1;
inline constexpr double kDrag_degPerPx = 0.25;

}  // namespace insonate::train
