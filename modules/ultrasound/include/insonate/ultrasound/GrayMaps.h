#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <span>
#include <string_view>

namespace insonate {

/// A gray map: the gray of a level as a share of white, y = t (a + t (b + t c)), with t the level's position in the
/// dynamic range, 0 (black) to 1 (white). Black stays black, white stays white (a + b + c = 1), and y always increases
/// with t.
struct GrayMapCurve {
  GrayMap map;
  std::string_view name;   ///< name in settings files
  std::string_view about;  ///< effect on an image, for a tooltip or a list
  float a, b, c;
};

/// All gray maps, in the order of GrayMap.
std::span<const GrayMapCurve> grayMaps();
const GrayMapCurve& curveOf(GrayMap map);

}  // namespace insonate
