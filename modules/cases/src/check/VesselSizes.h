#pragma once

#include <insonate/cases/VesselName.h>
#include <insonate/tissue/Labels.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace insonate::check {

/// Sizes of a vessel in adults. A size is the diameter of the circle that has the area of the cross-section, since
/// veins are flat.
struct VesselSizes {
  KnownVessel vessel;
  std::uint8_t label;              ///< kVein or kArtery
  double smallest_mm, largest_mm;  ///< sizes outside of this range are unusual
  double impossible_mm;            ///< no such vessel is larger
  std::string_view source;         ///< study, or "our choice"
};

/// Returns the sizes of all vessels that have a range of their own.
std::span<const VesselSizes> vesselSizes();

/// Returns the sizes of the vessel with this name. If it has no range of its own, returns limits for any vein or artery
/// near the skin, whose smallest size is 0.
const VesselSizes& sizesOf(std::string_view name, std::uint8_t label);

/// No vein or artery near the skin is wider than this, also if it is flat. The limits are our choice.
double impossibleWidth_mm(std::uint8_t label);

}  // namespace insonate::check
