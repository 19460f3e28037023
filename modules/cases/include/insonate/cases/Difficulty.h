#pragma once

#include <insonate/cases/CaseView.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// Properties that make a vein easy or hard to puncture, measured in its cross-section at a target, as a probe over it
/// shows it.
struct VeinMeasures {
  std::string target;
  double depth_mm = 0;                    ///< from the skin to the front wall
  double area_mm2 = 0;                    ///< of the lumen
  double width_mm = 0, height_mm = 0;     ///< axes of the ellipse with the lumen's second moments
  std::optional<double> overlap_percent;  ///< share of the artery's width that lies behind the vein; none: no artery
  std::optional<double> angle_deg;        ///< of the artery off the beam through the vein; 0 is straight behind it
  std::optional<double> artery_mm;        ///< from wall to wall
  std::optional<double> second_mm;        ///< to a second artery within reach of a probe
  std::optional<double> lung_mm;          ///< from the back wall to air behind it, along the beam
};

/// Contribution of one property to the difficulty.
struct DifficultyShare {
  std::string what;    ///< e.g. "height of the vein"
  std::string value;   ///< with its unit
  double points = 0;   ///< 0 easy .. 1 hard
  std::string reason;  ///< as in a sentence: "the vein is only 4 mm high"
};

/// Difficulty estimated from the labels; modules/cases/README.md has the formula and its basis.
struct DifficultyEstimate {
  static constexpr int kVersion = 1;  ///< of the formula
  std::string_view grade;             ///< "easy", "moderate" or "hard"
  double points = 0;                  ///< sum of the shares
  VeinMeasures measures;
  std::vector<DifficultyShare> shares;  ///< the largest first
  std::string sentence;                 ///< the grade and why
};

/// Estimates the difficulty of the first target, the one of the procedure. Fails, with the reason, if there is none,
/// if it is not in its vessel, or if no skin lies in front of it.
Result<DifficultyEstimate> estimateDifficulty(const CaseView& patient);

/// The cross-section of the vessel at a target. Fails as above.
Result<VeinMeasures> measureVein(const CaseView& patient, const Target& target);

/// The author's grade, else the estimated one; empty where neither is known.
std::string gradeOf(const CaseView& patient);

}  // namespace insonate
