#pragma once

#include <insonate/core/Transform.h>

#include <optional>

namespace insonate::metrics {

/// Measures the path of the needle's tip under the skin until the vein is reached, over all passes.
class NeedleWork {
 public:
  /// motions of the tip below this distance count as trembling and are ignored
  static constexpr double kStep_mm = 0.5;
  /// Distance of withdrawal, and of the advance that follows, that makes a redirection.
  static constexpr double kRedirect_mm = 3;

  void beginPass(Vec3 hole_mm);
  void endPass(Vec3 tip_mm);
  /// Adds a position of the tip under the skin. `depth_mm`: depth below the puncture of the skin, along the needle.
  void follow(Vec3 tip_mm, double depth_mm, bool aspirating);
  /// Ends the measurement, since the tip has reached the vein; later motion is not counted.
  void endAtVein(Vec3 tip_mm);

  int redirections() const { return redirections_; }
  double path_mm() const { return path_mm_; }
  std::optional<double> inefficiency_percent() const;
  std::optional<double> deviation_mm() const;
  std::optional<double> aspirating_percent() const;

 private:
  void walk(Vec3 tip_mm);
  void advance(double depth_mm, bool aspirating);
  void redirect(double depth_mm);

  bool reached_ = false;
  Vec3 hole_mm_, last_mm_, end_mm_;
  double path_mm_ = 0;
  // Second moments of the tip's positions in this pass about the puncture of the skin. At the end of the pass, when its
  // straight line is known, the deviation from the line is computed from these.
  double squares_mm2_ = 0;
  Mat3 moments_{{Vec3{}, Vec3{}, Vec3{}}};
  int points_ = 0;

  double mark_mm_ = 0, advanced_mm_ = 0, aspirating_mm_ = 0;
  double deepest_mm_ = 0, back_mm_ = 0;
  bool wentBack_ = false;
  int redirections_ = 0;
};

}  // namespace insonate::metrics
