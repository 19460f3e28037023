#include "Checks.h"
#include "CrossSections.h"
#include "VesselSizes.h"

#include <insonate/cases/Difficulty.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace insonate::check {
namespace {

/// Twice the normal upper limit of 18 ml in women and 25 ml in men (R. Gutekunst et al., Dtsch. med. Wschr. 113, 1988).
/// A goiter may be larger, so that this is only a warning.
constexpr double kThyroid_ml = 45;

enum class SizeFault { kNone, kSmall, kLarge, kImpossible };

SizeFault faultOf(const VesselSizes& sizes, const CrossSection& section) {
  if (section.area_mm2 <= 0) return SizeFault::kNone;  // other checks find courses without a label
  if (section.diameter_mm() > sizes.impossible_mm || section.width_mm > impossibleWidth_mm(sizes.label))
    return SizeFault::kImpossible;
  if (section.diameter_mm() > sizes.largest_mm) return SizeFault::kLarge;
  return section.isWhole && section.diameter_mm() < sizes.smallest_mm ? SizeFault::kSmall : SizeFault::kNone;
}

std::string shortNumber(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", value);
  return text.data();
}

std::string sizeText(const CrossSection& section) {
  return std::to_string(std::lround(section.width_mm)) + " x " + std::to_string(std::lround(section.height_mm)) +
         " mm (" + std::to_string(std::lround(section.area_mm2)) + " mm2, the area of a circle of " +
         shortNumber(section.diameter_mm()) + " mm)";
}

std::string usualSizes(const VesselSizes& sizes) {
  const std::string from = sizes.smallest_mm > 0 ? shortNumber(sizes.smallest_mm) + " to " : "up to ";
  return "The usual diameter is " + from + shortNumber(sizes.largest_mm) + " mm (" + std::string(sizes.source) + ")";
}

Finding sizeFinding(SizeFault fault, const VesselSizes& sizes, const std::string& where, const CrossSection& section) {
  const std::string label = labelName(sizes.label), text = where + " " + sizeText(section) + ". " + usualSizes(sizes);
  switch (fault) {
    case SizeFault::kImpossible:
      return {FindingSeverity::kError, "vessel_too_large",
              text + ", and none is larger than " + shortNumber(sizes.impossible_mm) + " mm or wider than " +
                  shortNumber(impossibleWidth_mm(sizes.label)) + " mm. Other tissue is labeled as " + label +
                  ", or two vessels are one. Correct the label.",
              section.place_mm, sizes.label};
    case SizeFault::kLarge:
      return {FindingSeverity::kWarning, "vessel_large",
              text + ". Check that no other tissue is labeled as " + label + ".", section.place_mm, sizes.label};
    default:
      return {FindingSeverity::kWarning, "vessel_small",
              text + ". Check that the whole lumen is labeled as " + label + ".", section.place_mm, sizes.label};
  }
}

/// A branch or a bend may spoil a single section: the middle one, by area, of three sections in a row.
const CrossSection& middleOf(const std::vector<CrossSection>& sections, std::size_t n) {
  std::array<const CrossSection*, 3> three{&sections[n - 1], &sections[n], &sections[n + 1]};
  std::ranges::sort(three, {}, [](const CrossSection* section) { return section->area_mm2; });
  return *three[1];
}

std::string fromTarget(const CaseView& patient, const NamedVessel& vessel, Vec3 place_mm) {
  std::optional<double> nearest_mm;
  for (const Target& target : patient.manifest.targets)
    if (liesIn(vessel, target)) {
      const double distance_mm = norm(place_mm - target.position_mm);
      if (!nearest_mm || distance_mm < *nearest_mm) nearest_mm = distance_mm;
    }
  return nearest_mm ? ", " + std::to_string(std::lround(*nearest_mm)) + " mm from the target," : "";
}

/// Adds a finding for the largest and for the smallest place of a vessel, if they are unusual. Returns the worst fault.
SizeFault checkCourse(const CaseView& patient, const NamedVessel& vessel, Findings& findings) {
  const VesselSizes& sizes = sizesOf(vessel.name, vessel.label);
  const std::vector<CrossSection> sections = crossSectionsOf(patient, vessel, sizes.largest_mm);
  constexpr std::size_t kEnd = 3;  // sections at either end, where a label tapers
  const CrossSection *largest = nullptr, *smallest = nullptr;
  SizeFault worst = SizeFault::kNone;
  for (std::size_t n = 1; n + 1 < sections.size(); ++n) {
    const CrossSection& section = middleOf(sections, n);
    const SizeFault fault = faultOf(sizes, section);
    const bool isAtEnd = n < kEnd || n + kEnd >= sections.size();
    if (fault == SizeFault::kSmall && !isAtEnd && (!smallest || section.area_mm2 < smallest->area_mm2))
      smallest = &section;
    if (fault < SizeFault::kLarge || fault < worst) continue;
    if (fault > worst || section.area_mm2 > largest->area_mm2) largest = &section;
    worst = fault;
  }
  const auto add = [&](SizeFault fault, const CrossSection& section) {
    const std::string where = "At " + placeText(section.place_mm) + fromTarget(patient, vessel, section.place_mm) +
                              " the " + vessel.name + " measures";
    findings.push_back(sizeFinding(fault, sizes, where, section));
  };
  if (largest) add(worst, *largest);
  if (smallest) add(SizeFault::kSmall, *smallest);
  return largest ? worst : smallest ? SizeFault::kSmall : SizeFault::kNone;
}

/// Returns the named vessel in which a target lies; null if there is none.
const NamedVessel* vesselOf(const CaseView& patient, const Target& target) {
  const auto& vessels = patient.manifest.vessels;
  const auto found = std::ranges::find_if(vessels, [&](const NamedVessel& vessel) { return liesIn(vessel, target); });
  return found == vessels.end() ? nullptr : &*found;
}

/// Checks a vessel at a target, in the plane of the image at the start pose. Adds no finding unless the fault is worse
/// than the one `known`.
void checkAtTarget(const CaseView& patient, const Target& target, const std::string& name, SizeFault known,
                   Findings& findings) {
  const auto measured = measureVein(patient, target);
  if (!measured) return;  // other checks say why
  const CrossSection section{target.position_mm, measured->area_mm2, measured->width_mm, measured->height_mm};
  const VesselSizes& sizes = sizesOf(name, target.label);
  if (const SizeFault fault = faultOf(sizes, section); fault > known)
    findings.push_back(sizeFinding(
        fault, sizes, "At the target \"" + target.name + "\" the " + labelName(target.label) + " measures", section));
}

}  // namespace

bool liesIn(const NamedVessel& vessel, const Target& target) {
  constexpr double kFlat_mm = 4;  // beyond the wall of a round vessel, but still in the lumen of a flat one
  return vessel.label == target.label && distanceToWall_mm(vessel, target.position_mm) <= kFlat_mm;
}

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
  std::map<const NamedVessel*, SizeFault> known;
  for (const NamedVessel& vessel : patient.manifest.vessels)
    if (vessel.label == kVein || vessel.label == kArtery) known[&vessel] = checkCourse(patient, vessel, findings);
  for (const Target& target : patient.manifest.targets) {
    if (target.label != kVein && target.label != kArtery) continue;
    const NamedVessel* vessel = vesselOf(patient, target);
    checkAtTarget(patient, target, vessel ? vessel->name : target.name, known[vessel], findings);
  }
}

}  // namespace insonate::check
