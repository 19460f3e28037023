#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/VolumeGeometry.h>

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Writes a gzip-compressed 3-D NRRD in left-posterior-superior space. `type` is NRRD's name of the element type;
/// `fields` become "key:=value" lines in this order. Not atomic: write to a temporary path. ITK's writer is not used
/// because it does not report a full disk, and sorts and escapes custom fields.
Result<void> writeNrrd(const std::filesystem::path& file, const VolumeGeometry& geometry, const std::string& type,
                       std::span<const std::byte> voxels,
                       const std::vector<std::pair<std::string, std::string>>& fields = {},
                       const Progress& progress = {});

/// Returns the shortest decimal text from which the same double is read back, in any locale.
std::string exactDecimal(double value);

}  // namespace insonate
