#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace insonate {

/// Structure numbers of a label map. The numbers never change. The even numbers 0 to 14 are those of Table I of the
/// thesis on which Insonate is based (README.md, "Further reading"); the odd numbers were added later.
enum Label : std::uint8_t {
  kBackground = 0,
  kSkin = 1,
  kArtery = 2,
  kFat = 3,
  kAirway = 4,  ///< air inside the patient: airway and lung
  kNerve = 5,
  kVein = 6,
  kLymphNode = 7,
  kThyroid = 8,
  kOesophagus = 9,
  kSternocleidomastoid = 10,
  kMuscle = 11,
  kBone = 12,
  kCartilage = 13,
  kSoftTissue = 14,  ///< tissue without a more specific label
  kGland = 15,       ///< salivary gland
};

inline constexpr int kLabelCount = 16;

/// Returns the label with this number; soft tissue for an unknown number.
constexpr Label knownLabel(std::uint8_t value) {
  return value < kLabelCount ? static_cast<Label>(value) : kSoftTissue;
}

/// Identity of a label for other programs: its SNOMED CT code, and its color, which mostly is 3D Slicer's.
struct LabelInfo {
  Label label;
  std::string_view name;
  std::array<std::uint8_t, 3> color;
  std::string_view snomedCode;
  std::string_view snomedMeaning;
};

const std::array<LabelInfo, kLabelCount>& labelTable();
/// Returns the label's name, e.g. "vein"; "label 47" for an unknown number.
std::string labelName(std::uint8_t label);
std::optional<Label> labelFromName(std::string_view name);

}  // namespace insonate
