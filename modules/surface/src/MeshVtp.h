#pragma once

#include <insonate/surface/Mesh.h>

#include <filesystem>

namespace insonate {

/// Writes VTK's own format (VTP, compressed) with normals; a field SPACE holds "LPS", which 3D Slicer reads. False
/// where the file cannot be written.
bool writeVtp(const Mesh& mesh, const std::filesystem::path& file);

}  // namespace insonate
