#include "SlicerSegmentation.h"
#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>

#include <bitset>
#include <cmath>

namespace insonate {
namespace fs = std::filesystem;
namespace {

Result<VolumeGeometry> gridOf(const RawVolume& raw, const fs::path& file) {
  auto geometry = orthogonalGeometry(raw);
  if (!geometry) return fail(file.string() + ": " + geometry.error().message);
  return geometry;
}

Result<Volume<std::int32_t>> wholeNumbers(const RawVolume& raw, const fs::path& file) {
  auto geometry = gridOf(raw, file);
  if (!geometry) return tl::unexpected(geometry.error());
  if (raw.components != 1)
    return fail(file.string() + " has " + std::to_string(raw.components) +
                " values per voxel, e.g. color; a label map has one whole number.");
  Volume<std::int32_t> labels(*geometry);
  constexpr float kExact = 1 << 24;  // float represents whole numbers exactly up to this
  for (std::size_t v = 0; v < labels.voxels.size(); ++v) {
    const float value = raw.values[v];
    if (!(std::abs(value) <= kExact) || value != std::floor(value))
      return fail(file.string() + " holds the value " + std::to_string(value) +
                  "; a label map holds whole numbers. Is the file a CT?");
    labels.voxels[v] = static_cast<std::int32_t>(value);
  }
  return labels;
}

}  // namespace

Result<Volume<std::int32_t>> readLabelValues(const fs::path& file) {
  auto raw = readVolumeFile(file);
  if (!raw) return tl::unexpected(raw.error());
  return wholeNumbers(*raw, file);
}

Result<LabelReadResult> readLabelMap(const fs::path& file) {
  auto raw = readVolumeFile(file);
  if (!raw) return tl::unexpected(raw.error());
  if (isSlicerSegmentation(raw->metadata)) {
    auto geometry = gridOf(*raw, file);
    if (!geometry) return tl::unexpected(geometry.error());
    return fromSlicerSegmentation(*raw, *geometry);
  }
  auto values = wholeNumbers(*raw, file);
  if (!values) return tl::unexpected(values.error());
  LabelReadResult result{LabelMap(values->geometry), {}};
  std::bitset<256> occurs;
  for (std::size_t v = 0; v < values->voxels.size(); ++v) {
    const std::int32_t value = values->voxels[v];
    if (value < 0 || value > 255)
      return fail(file.string() + " holds the label " + std::to_string(value) +
                  "; labels are 0 to 255. Name the numbers of another program with --names FILE, or renumber the "
                  "structures as in the list of labels.");
    result.labels.voxels[v] = static_cast<std::uint8_t>(value);
    occurs.set(static_cast<std::size_t>(value));
  }
  for (std::size_t value = 1; value < occurs.size(); ++value)
    if (occurs[value])
      result.structures.push_back({static_cast<std::int32_t>(value), {}, static_cast<std::uint8_t>(value)});
  result.isUnnamed = !result.structures.empty();
  return result;
}

}  // namespace insonate
