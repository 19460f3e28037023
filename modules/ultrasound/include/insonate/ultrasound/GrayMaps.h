#pragma once

#include <insonate/ultrasound/ImagingSettings.h>

#include <span>
#include <string_view>

namespace insonate {

/// A gray map: the curve y = t (a + t (b + t c)), which maps an echo level to a gray value. t is the position of the
/// level in the dynamic range, y the gray value, each from 0 (black) to 1 (white). a + b + c = 1, so that 1 maps to 1;
/// y increases with t.
struct GrayMapCurve {
  GrayMap map;
  std::string_view name;   ///< name of the gray map in settings files
  std::string_view about;  ///< description of the effect on an image, for a tooltip or a list
  float a, b, c;
};

/// Returns the curves of all gray maps, in the order of the enum GrayMap.
std::span<const GrayMapCurve> grayMaps();
const GrayMapCurve& curveOf(GrayMap map);

}  // namespace insonate
