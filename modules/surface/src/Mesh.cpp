#include "MeshParts.h"

#include <insonate/surface/Mesh.h>

namespace insonate {

double area_mm2(const Mesh& mesh) {
  double twice = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const Vec3 a = pointOf(mesh.points_mm, mesh.triangles[t]);
    twice += norm(
        cross(pointOf(mesh.points_mm, mesh.triangles[t + 1]) - a, pointOf(mesh.points_mm, mesh.triangles[t + 2]) - a));
  }
  return twice / 2;
}

double volume_mm3(const Mesh& mesh) {
  if (mesh.triangles.empty()) return 0;
  const Vec3 from = pointOf(mesh.points_mm, 0);  // a near origin reduces rounding errors
  double six = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    six += dot(pointOf(mesh.points_mm, mesh.triangles[t]) - from,
               cross(pointOf(mesh.points_mm, mesh.triangles[t + 1]) - from,
                     pointOf(mesh.points_mm, mesh.triangles[t + 2]) - from));
  return six / 6;
}

}  // namespace insonate
