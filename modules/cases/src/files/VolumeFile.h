#pragma once

#include <insonate/core/Result.h>
#include <insonate/core/Transform.h>
#include <insonate/image/Volume.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace insonate {

/// An image file as it is: any component type, any affine grid.
struct RawVolume {
  std::array<int, 3> size{1, 1, 1};
  Transform patientFromIndex;  ///< LPS mm; columns need not be at right angles
  int components = 1;
  bool eightBit = false;
  bool oriented = true;                         ///< false when the file says nothing about patient directions
  std::map<std::string, std::string> metadata;  ///< key/value pairs of an NRRD header
  std::vector<float> values;  ///< component fastest, then i, j, k; empty when only the header was read
};

/// Tells from the file name whether it is NRRD, NIfTI or MetaImage.
bool isVolumeFile(const std::filesystem::path& file);

enum class ReadPart { kHeader, kAll };

/// Every format's frame is turned to LPS. Fails with a sentence on unreadable or 4-D files and,
/// where voxels are read, on truncated ones and voxels of a size that no scanner has, before decoding them.
Result<RawVolume> readVolumeFile(const std::filesystem::path& file, ReadPart part = ReadPart::kAll);

/// Distance of neighboring voxels along i, j, k.
Vec3 spacingOf(const RawVolume& raw);

/// The grid of a file whose axes are at right angles; fails otherwise.
Result<VolumeGeometry> orthogonalGeometry(const RawVolume& raw);

}  // namespace insonate
