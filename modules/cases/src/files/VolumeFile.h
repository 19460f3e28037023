#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// The header of an image file without conversion: any component type, any affine grid.
struct VolumeHeader {
  std::array<int, 3> size{1, 1, 1};
  Transform patientFromIndex;  ///< maps a voxel index to patient LPS, mm; columns need not be perpendicular
  int components = 1;
  bool eightBit = false;
  bool oriented = true;                         ///< true if the file states patient directions
  std::map<std::string, std::string> metadata;  ///< key/value pairs of an NRRD header
  std::string extension;                        ///< contents of a NIfTI file's header extensions, one after the other
};

/// Tells from the file name whether a file is NRRD, NIfTI or MetaImage.
bool isVolumeFile(const std::filesystem::path& file);

/// Reads the header of an NRRD, NIfTI or MetaImage file and converts its frame to LPS. Fails with a sentence on
/// unreadable or 4-D files.
Result<VolumeHeader> readVolumeHeader(const std::filesystem::path& file);

/// Receives consecutive values, of which the first has the index `first`: component fastest, then i, j, k. A block
/// contains all components of its voxels.
using ValueSink = std::function<void(std::size_t first, std::span<const float> values)>;

/// Reads the values of a file and passes them to `sink` block by block: values of all voxels at once would need more
/// memory than the case. Blocks of zeros may be left out. Fails with a sentence, before `sink` is called, on what
/// readVolumeHeader() fails on, on truncated files, and on voxel sizes outside a scanner's range; also fails on damaged
/// files after `sink` was called.
Result<void> readVolumeBlocks(const std::filesystem::path& file, const ValueSink& sink);

/// A volume whose voxels arrive block by block. Memory is used only for voxels that have arrived, since the header of a
/// damaged file may promise more than the file contains.
template <class T>
class ArrivingVolume {
 public:
  explicit ArrivingVolume(const VolumeGeometry& geometry) { volume_.geometry = geometry; }

  /// Returns the voxels from `first` on, of which `count` can be written.
  T* at(std::size_t first, std::size_t count) {
    if (volume_.voxels.empty()) volume_.voxels.reserve(volume_.geometry.voxelCount());
    volume_.voxels.resize(std::max(volume_.voxels.size(), first + count));
    return volume_.voxels.data() + first;
  }
  Volume<T> take() {
    volume_.voxels.resize(volume_.geometry.voxelCount());
    return std::move(volume_);
  }

 private:
  Volume<T> volume_;
};

/// Returns the distances of neighboring voxels along i, j, k.
Vec3 spacingOf(const VolumeHeader& header);

/// Returns the grid of a file whose axes are perpendicular; fails otherwise.
Result<VolumeGeometry> orthogonalGeometry(const VolumeHeader& header);

}  // namespace insonate
