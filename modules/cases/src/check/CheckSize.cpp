#include "Checks.h"

#include <insonate/cases/Difficulty.h>
#include <insonate/tissue/Labels.h>

#include <cmath>

namespace insonate::check {
namespace {

/// Limits of a vessel's cross-section.
struct SizeLimits {
  double unusual_mm2, impossible_mm2, impossible_mm;
};

/// Internal jugular vein of 20 men, head down: 166 +- 67 mm2, which is the largest vein of the neck in any position
/// (Anaesth Intensive Care 2008; 36: 65-8): two and five standard deviations above the mean. Arteries of neck and arm
/// are 5 to 8 mm wide, the brachiocephalic trunk up to 14 mm; the aorta is no target and is not measured.
constexpr SizeLimits kVeinLimits{300, 500, 30}, kArteryLimits{150, 400, 25};

std::string sizeText(const VeinMeasures& m) {
  return std::to_string(std::lround(m.width_mm)) + " x " + std::to_string(std::lround(m.height_mm)) + " mm, " +
         std::to_string(std::lround(m.area_mm2)) + " mm2";
}

/// Twice the normal upper limit of 18 ml in women and 25 ml in men (R. Gutekunst et al., Dtsch. med. Wschr. 113, 1988).
/// A goiter may be larger, so that this is only a doubt.
constexpr double kThyroid_ml = 45;

}  // namespace

void checkThyroid(const CaseView& patient, const LabelStatistics& statistics, Findings& findings) {
  const Vec3& spacing_mm = patient.labels.geometry.spacing_mm;
  const double volume_ml = double(statistics.voxels[kThyroid]) * spacing_mm.x * spacing_mm.y * spacing_mm.z / 1000;
  if (volume_ml <= kThyroid_ml) return;
  findings.push_back({FindingSeverity::kWarning, "thyroid_large",
                      "The thyroid has a volume of " + std::to_string(std::lround(volume_ml)) +
                          " ml, about twice that of a large normal thyroid. Check that no muscle and no part of the "
                          "larynx is labeled as thyroid.",
                      std::nullopt, kThyroid});
}

void checkSizes(const CaseView& patient, Findings& findings) {
  for (const Target& target : patient.manifest.targets) {
    if (target.label != kVein && target.label != kArtery) continue;
    const auto measured = measureVein(patient, target);
    if (!measured) continue;  // other checks say why
    const SizeLimits& limits = target.label == kVein ? kVeinLimits : kArteryLimits;
    const bool isImpossible = measured->area_mm2 > limits.impossible_mm2 || measured->width_mm > limits.impossible_mm;
    if (!isImpossible && measured->area_mm2 <= limits.unusual_mm2) continue;
    const std::string name = labelName(target.label);
    findings.push_back(
        {isImpossible ? FindingSeverity::kError : FindingSeverity::kWarning,
         isImpossible ? "vessel_too_large" : "vessel_large",
         "At the target \"" + target.name + "\" the " + name + " measures " + sizeText(*measured) +
             (isImpossible ? ", larger than any " + name + " of this region. Other tissue is labeled as " + name +
                                 ", or two vessels are one. Correct the label."
                           : ", which is unusually large. Check that no other tissue is labeled as " + name + "."),
         target.position_mm, target.label});
  }
}

}  // namespace insonate::check
