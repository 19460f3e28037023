#pragma once

#include <QString>

namespace insonate::prepare {

/// Elapsed time from an author's action until its result is on the screen.
struct LabellingTime {
  QString name;  ///< name of the action and, if parts of the views are timed separately, of the part
  double median_ms = 0, longest_ms = 0;
  /// Longest time during the action in which the window's thread did not process events: elapsed, and in the thread's
  /// own processor time, which other programs on the computer do not affect.
  double pause_ms = 0, work_ms = 0;
};

}  // namespace insonate::prepare
