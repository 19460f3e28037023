#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/surface/Mesh.h>

#include <cstddef>
#include <vector>

namespace insonate {

inline Vec3 pointOf(const std::vector<float>& xyz, std::size_t point) {
  return {xyz[3 * point], xyz[3 * point + 1], xyz[3 * point + 2]};
}

/// Moves points back toward their place in `mesh`, in each connected part by itself, until the part encloses at least
/// `volumeKept` of its volume in `mesh`. Otherwise a smoothed grain would vanish.
void keepSmallParts(const Mesh& mesh, std::vector<float>& moved_mm, double volumeKept);

/// Moves all points along their normals, by the same way, so that the mesh encloses `target_mm3`; by `limit_mm` at
/// most. Corners that flying edges cut off and round structures that smoothing made smaller get their volume back.
void restoreVolume(Mesh& mesh, double target_mm3, double limit_mm);

/// Unit normals at the points, the mean over their triangles by area.
std::vector<float> pointNormals(const Mesh& mesh);

}  // namespace insonate
