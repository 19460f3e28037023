#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <span>
#include <string_view>

namespace insonate {

/// A gray map: the share of white that a level gets, y = t (a + t (b + t c)), t being the level's share of the dynamic
/// range from black to white. Black stays black, white stays white (a + b + c = 1), and y rises throughout.
struct GrayMapCurve {
  GrayMap map;
  std::string_view name;   ///< in settings files
  std::string_view about;  ///< what it does to an image, for a tooltip or a list
  float a, b, c;
};

/// All gray maps, in the order of GrayMap.
std::span<const GrayMapCurve> grayMaps();
const GrayMapCurve& curveOf(GrayMap map);

}  // namespace insonate
