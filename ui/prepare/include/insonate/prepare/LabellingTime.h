#pragma once

#include <QString>

namespace insonate::prepare {

/// Time from an author's action until its result is seen, on the clock.
struct LabellingTime {
  QString name;  ///< of what is done, and where a part of the views has a time of its own, of that
  double median_ms = 0, longest_ms = 0;
  /// The longest that the window's thread did not come to its events meanwhile; and in its own processor time, which
  /// the program is answerable for on a machine that others use.
  double pause_ms = 0, work_ms = 0;
};

}  // namespace insonate::prepare
