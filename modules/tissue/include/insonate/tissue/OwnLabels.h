#pragma once

#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace insonate {

/// A structure that the label table does not contain and that the author of the case has defined: its name and its
/// tissue.
struct OwnLabel {
  std::string name;  ///< name in the form of tidyLabelName(); empty if the author has not named the structure yet
  /// Label whose acoustic, mechanical and needle properties the structure has; never background.
  Label tissue = kSoftTissue;
  bool operator==(const OwnLabel&) const = default;
};

/// The labels that the author has defined, by number, kLabelCount to kLastOwnLabel.
using OwnLabels = std::map<std::uint8_t, OwnLabel>;

inline constexpr std::uint8_t kLastOwnLabel = 254;

constexpr bool isOwnLabel(std::uint8_t label) {
  return label >= kLabelCount && label <= kLastOwnLabel;
}

/// Returns the name in a form that every file format can store: one line of UTF-8, at most 64 bytes, without double
/// quotes or backslashes.
std::string tidyLabelName(std::string_view name);

/// Returns the name of a label: the name that the author gave it, or, without one, its name in the label table.
std::string labelName(const OwnLabels& own, std::uint8_t label);
/// Returns the label of the tissue (OwnLabel::tissue) if the author has defined `label`; else `label` itself.
std::uint8_t tissueOf(const OwnLabels& own, std::uint8_t label);

}  // namespace insonate
