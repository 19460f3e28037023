#pragma once

#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace insonate {

/// A structure outside the label table: the author's name for it, and its tissue.
struct OwnLabel {
  std::string name;            ///< as tidyLabelName() leaves it; empty for one that has no name yet
  Label tissue = kSoftTissue;  ///< how it looks in ultrasound, gives way and feels; never background
  bool operator==(const OwnLabel&) const = default;
};

/// Own labels by number, kLabelCount to kLastOwnLabel.
using OwnLabels = std::map<std::uint8_t, OwnLabel>;

inline constexpr std::uint8_t kLastOwnLabel = 254;

constexpr bool isOwnLabel(std::uint8_t label) {
  return label >= kLabelCount && label <= kLastOwnLabel;
}

/// The name as every file can hold it: one line of UTF-8, 64 bytes at most, without what quotes or escapes.
std::string tidyLabelName(std::string_view name);

/// The author's name, else as labelName(label).
std::string labelName(const OwnLabels& own, std::uint8_t label);
/// The author's, of a label of his own; else the label itself.
std::uint8_t tissueOf(const OwnLabels& own, std::uint8_t label);

}  // namespace insonate
