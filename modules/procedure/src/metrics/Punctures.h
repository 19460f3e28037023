#pragma once

#include <optional>

namespace insonate::metrics {

/// One structure and the needle in one pass: which crossings of its wall are new punctures. After the thesis's d1
/// logic: d1 is the depth below the skin's hole at which the needle went in; crossed there again, it comes out by the
/// way it went in, beyond, it has gone through the back wall. Made robust: what decides is the direction of travel,
/// since a vessel pressed flat is punctured front and back at one depth; and a tip that trembles in a hole has not made
/// another, which takes kTolerance_mm of way back.
class Punctures {
 public:
  static constexpr double kTolerance_mm = 1;

  /// Begins a new pass through the skin: d1 is reset, the counts stay.
  void beginPass();
  /// The wall was crossed from outside, in the direction of travel. True for a new puncture.
  bool enter(double depth_mm);
  /// Adds an exit from inside, in the direction of travel.
  void leave(double depth_mm);
  /// Against the direction of travel; `inside`: where the tip is now.
  void withdraw(bool inside);
  /// Depth of the tip below the skin's hole, as often as it is known.
  void follow(double depth_mm);

  int count() const { return count_; }
  int through() const { return through_; }
  bool inside() const { return inside_; }
  bool beyond() const { return back_mm_ && !inside_; }

 private:
  std::optional<double> front_mm_;  ///< d1, until the tip is clear of the hole again
  std::optional<double> back_mm_;   ///< the same of the back wall
  bool inside_ = false;
  int count_ = 0, through_ = 0;
};

}  // namespace insonate::metrics
