#pragma once

#include <insonate/cases/CaseView.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Properties that make a vein easy or hard to puncture, measured in its cross-section at a target, as seen by a probe
/// over the target. The cross-section is perpendicular to the vessel or, if its voxels have no main direction, in the
/// image plane of the start pose.
struct VeinMeasures {
  std::string target;
  double depth_mm = 0;                 ///< depth of the vein's front wall below the skin
  double area_mm2 = 0;                 ///< area of the vein's lumen
  double width_mm = 0, height_mm = 0;  ///< axes of an ellipse with the same second moments as the vein's lumen
  /// Share of the artery's width that lies behind the vein; no value: no artery.
  std::optional<double> overlap_percent;
  std::optional<double>
      covered_percent;  ///< share of the vein's width in front of which an artery lies; no artery: none
  /// angle at the vein between the beam and the direction to the artery; 0: the artery lies straight behind the vein
  std::optional<double> angle_deg;
  std::optional<double> artery_mm;  ///< distance from the vein's wall to the artery's wall
  /// distance from the vein's wall to the wall of a second artery within the probe's reach
  std::optional<double> second_mm;
  std::optional<double> lung_mm;  ///< distance along the beam from the vein's back wall to air
};

/// Contribution of one property to the difficulty.
struct DifficultyShare {
  std::string what;    ///< name of the property, e.g. "height of the vein"
  std::string value;   ///< value of the property, with its unit
  double points = 0;   ///< contribution to the difficulty: 0 for easy, 1 for hard, above 1 for harder
  std::string reason;  ///< reason for the contribution, as part of a sentence: "the vein is only 4 mm high"
};

/// Difficulty estimated from the labels; modules/cases/README.md states the formula and its basis.
struct DifficultyEstimate {
  static constexpr int kVersion = 2;  ///< version of the formula for the difficulty
  std::string_view grade;             ///< the difficulty in words: "easy", "moderate" or "hard"
  double points = 0;                  ///< total difficulty: sum of the points of all shares
  VeinMeasures measures;
  std::vector<DifficultyShare> shares;  ///< contributions of the single properties, the largest first
  std::string sentence;                 ///< sentence with the grade and the reasons for the grade
};

/// Estimates the difficulty of puncturing the first target of the case. Fails, with the reason, if there is no target,
/// if the target is not in its vessel, or if there is no skin in front of the target.
Result<DifficultyEstimate> estimateDifficulty(const CaseView& patient);

/// Measures the vessel's cross-section at a target. Fails with the errors of estimateDifficulty().
Result<VeinMeasures> measureVein(const CaseView& patient, const Target& target);

/// Returns the grade that the author has set; else the estimated grade; empty if there is neither.
std::string gradeOf(const CaseView& patient);

}  // namespace insonate
