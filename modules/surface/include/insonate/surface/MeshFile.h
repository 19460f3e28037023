#pragma once

#include <insonate/core/Result.h>
#include <insonate/surface/Mesh.h>

#include <filesystem>

namespace insonate {

/// Writes a mesh in the format that the extension of `file` selects: `.stl` (binary), `.ply` (binary, with normals),
/// `.obj` or `.vtp` (with normals). Coordinates are patient LPS in millimeters; the file contains "SPACE=LPS", which 3D
/// Slicer reads. On any failure an existing file is unchanged. Fails on another extension, a mesh without triangles,
/// point indices out of range, and if the file cannot be written.
Result<void> writeMesh(const std::filesystem::path& file, const Mesh& mesh);

}  // namespace insonate
