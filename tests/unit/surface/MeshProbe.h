#pragma once

#include <insonate/core/Vec3.h>
#include <insonate/image/Volume.h>
#include <insonate/surface/ExtractSurface.h>
#include <insonate/surface/Mesh.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

namespace insonate::test {

inline Vec3 point(const std::vector<float>& xyz, std::size_t number) {
  return {xyz[3 * number], xyz[3 * number + 1], xyz[3 * number + 2]};
}

/// Uses of each directed edge.
inline std::map<std::pair<std::uint32_t, std::uint32_t>, int> edgesOf(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    for (int c = 0; c < 3; ++c) ++uses[{mesh.triangles[t + c], mesh.triangles[t + (c + 1) % 3]}];
  return uses;
}

/// Every edge is used by two triangles, once in each direction: no holes, no flaps, one side everywhere.
inline bool isClosed(const Mesh& mesh) {
  const auto uses = edgesOf(mesh);
  return !uses.empty() && std::ranges::all_of(uses, [&](const auto& entry) {
    const auto back = uses.find({entry.first.second, entry.first.first});
    return entry.second == 1 && back != uses.end() && back->second == 1;
  });
}

/// Points - edges + triangles: 2 for each part without handles.
inline int eulerCharacteristic(const Mesh& mesh) {
  const std::set<std::uint32_t> points(mesh.triangles.begin(), mesh.triangles.end());
  return int(points.size()) - int(edgesOf(mesh).size() / 2) + int(mesh.triangleCount());
}

/// Centre of the enclosed volume.
inline Vec3 centroid(const Mesh& mesh) {
  const Vec3 from = point(mesh.points_mm, 0);
  Vec3 sum;
  double volumes = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    const Vec3 a = point(mesh.points_mm, mesh.triangles[t]) - from;
    const Vec3 b = point(mesh.points_mm, mesh.triangles[t + 1]) - from;
    const Vec3 c = point(mesh.points_mm, mesh.triangles[t + 2]) - from;
    const double volume = dot(a, cross(b, c));
    sum = sum + (a + b + c) * (volume / 4);
    volumes += volume;
  }
  return from + sum / volumes;
}

/// Lowest cosine between the normals and the directions away from `center`.
inline double worstOutward(const Mesh& mesh, Vec3 center) {
  double worst = 1;
  for (std::size_t p = 0; p < mesh.pointCount(); ++p) {
    const Vec3 normal = point(mesh.normals, p);
    EXPECT_NEAR(norm(normal), 1, 1e-5);
    worst = std::min(worst, dot(normal, normalized(point(mesh.points_mm, p) - center)));
  }
  return worst;
}

/// A grid of 1 mm voxels whose first voxel has its center at the origin.
inline LabelMap emptyMap(int i, int j, int k) {
  VolumeGeometry grid;
  grid.size = {i, j, k};
  return LabelMap(grid);
}

/// Labels voxels whose centers lie in the ball.
inline void addBall(LabelMap& labels, std::uint8_t label, Vec3 center_mm, double radius_mm) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const auto& size = labels.geometry.size;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        if (norm(patientFromIndex * Vec3{double(i), double(j), double(k)} - center_mm) < radius_mm)
          labels.at(i, j, k) = label;
}

/// Labels the voxels from `first` to `last`, both included.
inline void addBox(LabelMap& labels, std::uint8_t label, std::array<int, 3> first, std::array<int, 3> last) {
  for (int k = first[2]; k <= last[2]; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) labels.at(i, j, k) = label;
}

inline double ballVolume_mm3(double radius_mm) {
  return 4.0 / 3 * std::numbers::pi * std::pow(radius_mm, 3);
}
inline double ballArea_mm2(double radius_mm) {
  return 4 * std::numbers::pi * radius_mm * radius_mm;
}

/// The mesh, or a failed test and an empty mesh.
inline Mesh surfaceOf(const LabelMap& labels, std::uint8_t label, const SurfaceOptions& options = {}) {
  auto mesh = extractSurface(labels, label, options);
  if (mesh) return std::move(*mesh);
  ADD_FAILURE() << mesh.error().message;
  return {};
}

}  // namespace insonate::test
