#pragma once

#include <insonate/cases/PatientCase.h>

#include <optional>
#include <span>
#include <vector>

namespace insonate::wire {

/// End of a vessel: position, direction out of the vessel, radius.
struct TubeEnd {
  Vec3 at_mm, outward;
  double radius_mm = 0;
};
TubeEnd endOf(const NamedVessel& vessel, bool last);

struct HeartAnatomy {
  std::vector<NamedVessel> vessels;     ///< tubes that begin at ends of the case's vessels and lead to the heart
  std::vector<NamedVessel> beyond;      ///< the right atrium, and the vena cava on its other side
  std::optional<Vec3> veinsToHeart;     ///< junction of vena cava and right atrium
  std::optional<Vec3> arteriesToHeart;  ///< root of the aorta
};

/// Continues the named vessels of a case to the heart by mean lengths and diameters.
HeartAnatomy heartAnatomy(std::span<const NamedVessel> vessels);

}  // namespace insonate::wire
