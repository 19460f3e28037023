#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/surface/ExtractSurface.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// A structure's surface that was written.
struct SurfaceFile {
  std::uint8_t label;
  std::string name, fileName;
  std::size_t triangles;
  double area_mm2, volume_mm3;
};

/// Refuses, before any work, a folder that surfaces could not be written to (see checkFolderTarget) or that is not
/// empty.
Result<void> checkSurfaceTarget(const std::filesystem::path& folder);

/// Writes the surface of every structure to a file of its own, named after it ("airway-and-lung.stl"), into a folder
/// that is created, or exists and is empty. `format` is an extension of writeMesh without its dot. Nothing is left
/// behind on failure. Fails where nothing is labeled, as extractSurface and writeMesh do, and when cancelled.
Result<std::vector<SurfaceFile>> writeSurfaces(const LabelMap& labels, const std::filesystem::path& folder,
                                               const std::string& format, const SurfaceOptions& options = {},
                                               const Progress& progress = {});

}  // namespace insonate
