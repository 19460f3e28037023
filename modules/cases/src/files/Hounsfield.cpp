#include "Hounsfield.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {

Result<HounsfieldCt> readHounsfield(const std::filesystem::path& file, const VolumeHeader& header,
                                    const VolumeGeometry& geometry, std::vector<std::string>& notes) {
  if (header.components != 1)
    return fail(file.string() + ": the CT has " + std::to_string(header.components) +
                " values per voxel, e.g. color; a CT has one. Export the original series instead.");
  constexpr float kMaxHu = std::numeric_limits<std::int16_t>::max();
  ArrivingVolume<std::int16_t> arriving(geometry);
  std::size_t notNumbers = 0, padding = 0, tooDense = 0;
  const auto read = readVolumeBlocks(file, [&](std::size_t first, std::span<const float> values) {
    std::int16_t* voxel = arriving.at(first, values.size());
    for (float hu : values) {
      notNumbers += std::isnan(hu);
      padding += hu < kAirHu;
      tooDense += hu > kMaxHu;
      hu = std::isnan(hu) ? kAirHu : std::clamp(hu, float(kAirHu), kMaxHu);
      *voxel++ = static_cast<std::int16_t>(std::lround(hu));
    }
  });
  if (!read) return tl::unexpected(read.error());
  const auto note = [&](std::size_t count, const std::string& what) {
    if (count > 0) notes.push_back(std::to_string(count) + " voxels of the CT " + what);
  };
  note(notNumbers, "were not a number and became -1024 HU (air).");
  note(padding, "were below -1024 HU (padding) and became -1024 HU (air).");
  note(tooDense, "were above 32767 HU and became 32767 HU.");
  return HounsfieldCt{arriving.take(), tooDense};
}

}  // namespace insonate
