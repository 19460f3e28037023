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

/// One row of the only table of keys: it decides what a key does, and lists it for the user.
struct KeyRow {
  int key = 0;           ///< Qt::Key
  bool control = false;  ///< with the control key
  Command command;
  HandAxis axis{};            ///< of a move
  double step = 0, wide = 0;  ///< mm or degrees; wide with shift
  int place = 0;              ///< of a recall, a window preset or TissueShown::toggle(), from 0
  const char* keys;           ///< as the user knows it; empty on rows that share the line above
  const char* meaning;
  bool alt = false;     ///< with the alt key
  NeedleAxis needle{};  ///< of a move of the needle
};

std::span<const KeyRow> keyTable();

/// Row of a key; null for a key without a command here.
const KeyRow* rowFor(const QKeyEvent& event);

/// Actions of the mouse, for the same list.
struct MouseRow {
  const char* gesture;
  const char* meaning;
};
std::span<const MouseRow> mouseTable();

inline constexpr double kWheelPress_mm = 0.5, kWheelDepth_mm = 5, kWheelNeedle_mm = 1;
inline constexpr double kDrag_degPerPx = 0.25;

}  // namespace insonate::train
