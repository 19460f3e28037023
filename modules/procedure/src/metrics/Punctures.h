#pragma once

#include <optional>

namespace insonate::metrics {

/// Decides for one structure and one pass which crossings of its wall are new punctures. The d1 logic follows the
/// thesis: d1 is the depth below the hole in the skin at which the needle entered the structure. If the wall is crossed
/// again at this depth, the needle leaves by its entry hole; if beyond, it has gone through the posterior wall. Two
/// changes make this robust. The direction of travel decides, since the walls of a fully compressed vessel are
/// punctured at the same depth. A tip that trembles in a hole makes no new puncture: for a new one it must first
/// withdraw by kTolerance_mm.
class Punctures {
 public:
  static constexpr double kTolerance_mm = 1;

  /// Begins a new pass through the skin: d1 is reset, the counts stay.
  void beginPass();
  /// The wall was crossed from outside while advancing. Returns whether this is a new puncture.
  bool enter(double depth_mm);
  /// The wall was crossed from inside while advancing.
  void leave(double depth_mm);
  /// The wall was crossed while withdrawing; `inside`: the tip is now inside.
  void withdraw(bool inside);
  /// Passes the depth of the tip below the hole in the skin; call whenever it is known.
  void follow(double depth_mm);

  int count() const { return count_; }
  int through() const { return through_; }
  bool inside() const { return inside_; }
  bool beyond() const { return back_mm_ && !inside_; }

 private:
  std::optional<double> front_mm_;  ///< d1; empty once the tip has withdrawn from the hole
  std::optional<double> back_mm_;   ///< depth of the posterior wall's puncture; empty likewise
  bool inside_ = false;
  int count_ = 0, through_ = 0;
};

}  // namespace insonate::metrics
