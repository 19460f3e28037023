#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/surface/ExtractSurface.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Facts about a surface file that was written.
struct SurfaceFile {
  std::uint8_t label;
  std::string name, fileName;
  std::size_t triangles;
  double area_mm2, volume_mm3;
};

/// Refuses, before any work, a folder to which surfaces cannot be written (see checkFolderTarget) or that is not empty.
Result<void> checkSurfaceTarget(const std::filesystem::path& folder);

/// Writes the surface of every structure to a file with the name of the structure ("airway-and-lung.stl") in a folder,
/// which is created or must be empty. `format` is one of the extensions of writeMesh(), without the dot. On failure all
/// written files are removed. Fails if nothing is labeled, with the errors of extractSurface() and writeMesh(), and
/// when cancelled.
Result<std::vector<SurfaceFile>> writeSurfaces(const LabelMap& labels, const std::filesystem::path& folder,
                                               const std::string& format, const SurfaceOptions& options = {},
                                               const Progress& progress = {});

}  // namespace insonate
