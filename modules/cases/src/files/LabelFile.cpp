#include "SlicerSegmentation.h"
#include "VolumeFile.h"

#include <insonate/cases/LabelFile.h>

#include <bitset>
#include <cmath>
#include <optional>

namespace insonate {
namespace fs = std::filesystem;
namespace {

constexpr float kExact = 1 << 24;  // float represents whole numbers exactly up to this

Result<VolumeGeometry> gridOf(const VolumeHeader& header, const fs::path& file) {
  auto geometry = orthogonalGeometry(header);
  if (!geometry) return fail(file.string() + ": " + geometry.error().message);
  return geometry;
}

/// Reads a label map of whole numbers from `least` to `most` as voxels of type T. `objection` says what is wrong with
/// another whole number.
template <class T, class Objection>
Result<Volume<T>> wholeNumbers(const fs::path& file, const VolumeHeader& header, float least, float most,
                               const Objection& objection) {
  const auto geometry = gridOf(header, file);
  if (!geometry) return tl::unexpected(geometry.error());
  if (header.components != 1)
    return fail(file.string() + " has " + std::to_string(header.components) +
                " values per voxel, e.g. color; a label map has one whole number.");
  ArrivingVolume<T> arriving(*geometry);
  std::optional<float> wrong;
  const auto read = readVolumeBlocks(file, [&](std::size_t first, std::span<const float> values) {
    T* voxel = arriving.at(first, values.size());
    for (const float value : values) {
      const bool isFit = value >= least && value <= most && value == std::floor(value);
      if (!isFit && !wrong) wrong = value;
      *voxel++ = isFit ? static_cast<T>(value) : T{0};
    }
  });
  if (!read) return tl::unexpected(read.error());
  if (!wrong) return arriving.take();
  const bool isWhole = std::abs(*wrong) <= kExact && *wrong == std::floor(*wrong);
  return fail(isWhole ? objection(*wrong)
                      : file.string() + " holds the value " + std::to_string(*wrong) +
                            "; a label map holds whole numbers. Is the file a CT?");
}

}  // namespace

Result<Volume<std::int32_t>> readLabelValues(const fs::path& file) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  return wholeNumbers<std::int32_t>(file, *header, -kExact, kExact, [](float) { return std::string(); });
}

Result<LabelReadResult> readLabelMap(const fs::path& file) {
  const auto header = readVolumeHeader(file);
  if (!header) return tl::unexpected(header.error());
  if (isSlicerSegmentation(header->metadata)) {
    const auto geometry = gridOf(*header, file);
    if (!geometry) return tl::unexpected(geometry.error());
    return readSlicerSegmentation(file, *header, *geometry);
  }
  auto labels = wholeNumbers<std::uint8_t>(file, *header, 0, 255, [&file](float value) {
    return file.string() + " holds the label " + std::to_string(std::lround(value)) +
           "; labels are 0 to 255. Name the numbers of another program with --names FILE, or renumber the structures "
           "as in the list of labels.";
  });
  if (!labels) return tl::unexpected(labels.error());
  LabelReadResult result{std::move(*labels), {}};
  std::bitset<256> occurs;
  for (const std::uint8_t value : result.labels.voxels) occurs.set(value);
  for (std::size_t value = 1; value < occurs.size(); ++value)
    if (occurs[value])
      result.structures.push_back({static_cast<std::int32_t>(value), {}, static_cast<std::uint8_t>(value)});
  result.isUnnamed = !result.structures.empty();
  return result;
}

}  // namespace insonate
