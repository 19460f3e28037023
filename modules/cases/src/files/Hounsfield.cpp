#include "Hounsfield.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {

Result<CtVolume> toHounsfield(const RawVolume& raw, const VolumeGeometry& geometry, std::vector<std::string>& notes) {
  if (raw.components != 1)
    return fail("The CT has " + std::to_string(raw.components) +
                " values per voxel, e.g. color; a CT has one. Export the original series instead.");
  constexpr float kMaxHu = std::numeric_limits<std::int16_t>::max();
  CtVolume ct(geometry);
  std::size_t notNumbers = 0, padding = 0, tooDense = 0;
  for (std::size_t v = 0; v < ct.voxels.size(); ++v) {
    float hu = raw.values[v];
    notNumbers += std::isnan(hu);
    padding += hu < kAirHu;
    tooDense += hu > kMaxHu;
    hu = std::isnan(hu) ? kAirHu : std::clamp(hu, float(kAirHu), kMaxHu);
    ct.voxels[v] = static_cast<std::int16_t>(std::lround(hu));
  }
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) notes.push_back(std::to_string(count) + " voxels of the CT " + what);
  };
  note(notNumbers, "were not a number and became -1024 HU (air).");
  note(padding, "were below -1024 HU (padding) and became -1024 HU (air).");
  note(tooDense, "were above 32767 HU and became 32767 HU.");
  return ct;
}

}  // namespace insonate
