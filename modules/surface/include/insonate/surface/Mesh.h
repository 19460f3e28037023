#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace insonate {

/// Triangles in patient space. Owns its data and is independent of the label map's grid.
struct Mesh {
  std::vector<float> points_mm;  ///< coordinates x, y, z of each point, patient LPS
  std::vector<float> normals;    ///< normal vector at each point (x, y, z), unit length, pointing out of the structure
  std::vector<std::uint32_t> triangles;  ///< three point indices per triangle, counter-clockwise as seen from outside

  std::size_t pointCount() const { return points_mm.size() / 3; }
  std::size_t triangleCount() const { return triangles.size() / 3; }
};

double area_mm2(const Mesh& mesh);
/// Returns the volume inside a closed mesh; cavities count as outside.
double volume_mm3(const Mesh& mesh);

}  // namespace insonate
