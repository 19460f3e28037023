#pragma once

#include <optional>

namespace insonate::metrics {

/// Counts the punctures of one structure: decides which crossings of its wall by the needle's tip are new punctures.
/// The d1 logic follows the thesis: d1 is the depth below the puncture of the skin at which the needle entered the
/// structure. If the needle crosses the wall again at this depth, it leaves by its entry hole. If it crosses the wall
/// at a greater depth, it has gone through the posterior wall. Two changes make this robust. The direction of travel
/// decides, since the walls of a fully compressed vessel are punctured at the same depth. A trembling tip makes no new
/// puncture: for a new puncture, the tip must first withdraw by kTolerance_mm.
class Punctures {
 public:
  static constexpr double kTolerance_mm = 1;

  /// Begins a new pass (insertion through the skin): d1 is reset, the counts stay.
  void beginPass();
  /// Reports that the tip crossed the wall from outside while advancing. Returns whether this is a new puncture.
  bool enter(double depth_mm);
  /// Reports that the tip crossed the wall from inside while advancing.
  void leave(double depth_mm);
  /// Reports that the tip crossed the wall while withdrawing; `inside`: the tip is now inside the structure.
  void withdraw(bool inside);
  /// Reports the depth of the tip below the puncture of the skin; call it whenever the depth is known.
  void follow(double depth_mm);

  int count() const { return count_; }
  int through() const { return through_; }
  bool inside() const { return inside_; }
  bool beyond() const { return back_mm_ && !inside_; }

 private:
  /// d1, depth at which the structure was entered; empty once the tip has withdrawn from there
  std::optional<double> front_mm_;
  /// depth at which the posterior wall was punctured; empty once the tip has withdrawn from there
  std::optional<double> back_mm_;
  bool inside_ = false;
  int count_ = 0, through_ = 0;
};

}  // namespace insonate::metrics
