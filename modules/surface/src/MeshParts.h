#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/surface/Mesh.h>

#include <cstddef>
#include <vector>

namespace insonate {

inline Vec3 pointOf(const std::vector<float>& xyz, std::size_t point) {
  return {xyz[3 * point], xyz[3 * point + 1], xyz[3 * point + 2]};
}

/// Moves the smoothed points `moved_mm` back toward their unsmoothed positions in `mesh`, separately in each connected
/// part, until the part encloses at least the fraction `volumeKept` of its volume in `mesh`. Without this correction,
/// smoothing would remove very small parts.
void keepSmallParts(const Mesh& mesh, std::vector<float>& moved_mm, double volumeKept);

/// Moves all points along their normals by the same distance, at most `limit_mm`, so that the mesh encloses
/// `target_mm3`. This restores the volume that contouring by flying edges loses at corners and smoothing loses on round
/// structures.
void restoreVolume(Mesh& mesh, double target_mm3, double limit_mm);

/// Returns unit normals at the points: means over the adjacent triangles, weighted by area.
std::vector<float> pointNormals(const Mesh& mesh);

}  // namespace insonate
