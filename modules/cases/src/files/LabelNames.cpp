#include "LabelNames.h"

#include <insonate/cases/VesselName.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

namespace insonate {
namespace {

// SNOMED CT codes of parts of structures in labelTable().
constexpr std::array<std::pair<std::string_view, Label>, 6> kPartCodes{{{"12123001", kVein},
                                                                        {"32062004", kArtery},
                                                                        {"39607008", kAirway},
                                                                        {"15825003", kArtery},
                                                                        {"91134007", kMuscle},
                                                                        {"113255004", kAirway}}};

// The first match determines the label, so that "jugular lymph node" is a lymph node and "vagus nerve" is not an
// artery.
constexpr std::array<std::pair<std::string_view, Label>, 42> kWords{{{"lymph", kLymphNode},
                                                                     {"nerv", kNerve},
                                                                     {"vagus", kNerve},
                                                                     {"plexus", kNerve},
                                                                     {"vein", kVein},
                                                                     {"vena", kVein},
                                                                     {"jugular", kVein},
                                                                     {"artery", kArtery},
                                                                     {"aorta", kArtery},
                                                                     {"carotid", kArtery},
                                                                     {"arteria", kArtery},
                                                                     {"sternocleidomastoid", kSternocleidomastoid},
                                                                     {"thyroid cart", kCartilage},
                                                                     {"cricoid", kCartilage},
                                                                     {"cartilage", kCartilage},
                                                                     {"thyroid", kThyroid},
                                                                     {"esophag", kOesophagus},
                                                                     {"oesophag", kOesophagus},
                                                                     {"trachea", kAirway},
                                                                     {"lung", kAirway},
                                                                     {"airway", kAirway},
                                                                     {"skin", kSkin},
                                                                     {"fat", kFat},
                                                                     {"adipose", kFat},
                                                                     {"muscle", kMuscle},
                                                                     {"gland", kGland},
                                                                     {"bone", kBone},
                                                                     {"vertebra", kBone},
                                                                     {"clavic", kBone},
                                                                     {"skull", kBone},
                                                                     {"mandible", kBone},
                                                                     {"rib", kBone},
                                                                     {"sternum", kBone},
                                                                     {"humerus", kBone},
                                                                     {"scapula", kBone},
                                                                     {"femur", kBone},
                                                                     {"sacrum", kBone},
                                                                     {"autochthon", kMuscle},
                                                                     {"gluteus", kMuscle},
                                                                     {"iliopsoas", kMuscle},
                                                                     {"scalen", kMuscle},
                                                                     {"trapezius", kMuscle}}};

}  // namespace

std::optional<Label> labelFromSnomed(std::string_view code) {
  if (code.empty()) return std::nullopt;
  for (const LabelInfo& info : labelTable())
    if (info.snomedCode == code) return info.label;
  for (const auto& [part, label] : kPartCodes)
    if (part == code) return label;
  return std::nullopt;
}

std::optional<Label> labelFromAnyName(std::string_view name) {
  std::string lower(name);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (const auto exact = labelFromName(lower)) return exact;
  const auto matching =
      std::ranges::find_if(kWords, [&](const auto& known) { return lower.find(known.first) != std::string::npos; });
  const bool isBesideVessels =
      matching != kWords.end() && (matching->second == kLymphNode || matching->second == kNerve);
  // "A. vertebralis" is no vertebra.
  if (const VesselName vessel = parsedVesselName(name); vessel.vessel && vessel.label && !isBesideVessels)
    return vessel.label;
  return matching == kWords.end() ? std::nullopt : std::optional(matching->second);
}

}  // namespace insonate
