#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <array>
#include <filesystem>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace insonate {

/// An image file without conversion: any component type, any affine grid.
struct RawVolume {
  std::array<int, 3> size{1, 1, 1};
  Transform patientFromIndex;  ///< maps a voxel index to patient LPS, mm; columns need not be perpendicular
  int components = 1;
  bool eightBit = false;
  bool oriented = true;                         ///< true if the file states patient directions
  std::map<std::string, std::string> metadata;  ///< key/value pairs of an NRRD header
  std::string extension;                        ///< contents of a NIfTI file's header extensions, one after the other
  /// Values of the voxels: component fastest, then i, j, k; empty if only the header was read.
  std::vector<float> values;
};

/// Tells from the file name whether a file is NRRD, NIfTI or MetaImage.
bool isVolumeFile(const std::filesystem::path& file);

enum class ReadPart { kHeader, kAll };

/// Reads an NRRD, NIfTI or MetaImage file and converts its frame to LPS. Fails with a sentence on unreadable or 4-D
/// files. If voxels are read, also fails, before decoding them, on truncated files and on voxel sizes outside a
/// scanner's range.
Result<RawVolume> readVolumeFile(const std::filesystem::path& file, ReadPart part = ReadPart::kAll);

/// Receives the values of consecutive voxels, of which the first has the index `first`.
using ValueSink = std::function<void(std::size_t first, std::span<const float> values)>;

/// Reads a file as readVolumeFile() does, but passes the values to `sink` block by block, and returns only the header.
/// Blocks of zeros may be left out. NIfTI files need no memory for all values. Fails on several values per voxel.
Result<RawVolume> readVolumeBlocks(const std::filesystem::path& file, const ValueSink& sink);

/// Returns the distances of neighboring voxels along i, j, k.
Vec3 spacingOf(const RawVolume& raw);

/// Returns the grid of a file whose axes are perpendicular; fails otherwise.
Result<VolumeGeometry> orthogonalGeometry(const RawVolume& raw);

}  // namespace insonate
