#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/SourceImage.h>

#include <array>

namespace insonate {
namespace {

constexpr std::array kPlanes{ScanPlane::Transverse, ScanPlane::Longitudinal, ScanPlane::Oblique};

}  // namespace

std::string_view nameOf(ScanPlane plane) {
  switch (plane) {
    case ScanPlane::Transverse:
      return "transverse";
    case ScanPlane::Longitudinal:
      return "longitudinal";
    case ScanPlane::Oblique:
      break;
  }
  return "oblique";
}

std::optional<ScanPlane> scanPlaneNamed(std::string_view name) {
  for (const ScanPlane plane : kPlanes)
    if (nameOf(plane) == name) return plane;
  return std::nullopt;
}

double shownPixelsPer_mm(ProbeShape probe) {
  return probe == ProbeShape::Linear ? kFeaturePixelsPer_mm : kFeaturePixelsPer_mm / 2;
}

}  // namespace insonate
