#include <insonate/ultrasound/GrayMaps.h>

#include <array>

namespace insonate {
namespace {

// Scanners number or letter their maps and publish no curves; these cover the range of such lists: a straight line, S
// curves of two strengths, lifted and lowered middle grays, and a reversed S.
constexpr std::array kCurves{
    GrayMapCurve{GrayMap::Linear, "linear", "gray in proportion to the level in dB", 1, 0, 0},
    // Passes through (0.34, 0.235), (0.5, 0.4) and (1, 1).
    GrayMapCurve{GrayMap::Soft, "soft", "a slight S curve: dark grays a little darker, bright grays distinguishable",
                 0.387F, 1.039F, -0.426F},
    GrayMapCurve{GrayMap::Contrast, "contrast", "a steep S curve: dark lumens, bright walls", 0.15F, 2.2F, -1.35F},
    GrayMapCurve{GrayMap::Bright, "bright", "middle grays brighter, dark grays unchanged", 0.6F, 1.7F, -1.3F},
    GrayMapCurve{GrayMap::Dark, "dark", "middle grays darker", 0.2F, 0.8F, 0},
    GrayMapCurve{GrayMap::Flat, "flat", "a reversed S curve: detail in dark and bright grays, little between", 1.6F,
                 -1.6F, 1},
};

}  // namespace

std::span<const GrayMapCurve> grayMaps() {
  return kCurves;
}

const GrayMapCurve& curveOf(GrayMap map) {
  return kCurves[static_cast<std::size_t>(map)];
}

}  // namespace insonate
