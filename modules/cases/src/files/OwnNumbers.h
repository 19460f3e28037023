#pragma once

#include <insonate/tissue/OwnLabels.h>

#include <bitset>
#include <cstdint>

namespace insonate {

/// Assigns label numbers to structures of another program that this program does not know.
class OwnNumbers {
 public:
  void keep(std::uint8_t label) { taken_.set(label); }
  /// Reserves and returns a label number: `wanted` if it is free, else the first free number. Returns kSoftTissue if
  /// all numbers are taken.
  std::uint8_t take(long wanted) {
    if (wanted < kLabelCount || wanted > kLastOwnLabel || taken_.test(static_cast<std::size_t>(wanted)))
      for (wanted = kLabelCount; wanted <= kLastOwnLabel && taken_.test(static_cast<std::size_t>(wanted));) ++wanted;
    if (wanted > kLastOwnLabel) return kSoftTissue;
    taken_.set(static_cast<std::size_t>(wanted));
    return static_cast<std::uint8_t>(wanted);
  }

 private:
  std::bitset<256> taken_;
};

/// Returns a note to the author about an unknown structure.
inline std::string unknownStructure(const std::string& what, std::uint8_t label) {
  return what + " is a structure that Insonate does not know. It is read as " +
         (isOwnLabel(label)
              ? labelName(label) + ", with the tissue soft tissue. Set its name and tissue in the table of structures."
              : "soft tissue, since all numbers of labels are in use.");
}

}  // namespace insonate
