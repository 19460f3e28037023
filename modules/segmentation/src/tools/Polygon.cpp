#include <insonate/segmentation/Polygon.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace insonate {
namespace {

/// Points of the patient as homogeneous points of an image, (x, y, w): in front of the eye if w is above 0. A row of
/// voxels is a line of the image, and its crossings with the edges of the polygon are exact.
class Outline {
 public:
  Outline(std::span<const Vec3> corners_mm, const ScissorsView& view) : along_(view.along), eye_mm_(view.eye_mm) {
    const Vec3 aside = std::abs(along_.x) < 0.9 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    right_ = normalized(cross(along_, aside));
    down_ = cross(along_, right_);
    for (const Vec3& corner_mm : corners_mm) corners_.push_back(seen(corner_mm));
  }

  bool allInFront() const {
    return std::ranges::all_of(corners_, [](Vec3 corner) { return corner.z > 0; });
  }

  Vec3 seen(Vec3 patient_mm) const {
    const Vec3 off = eye_mm_ ? patient_mm - *eye_mm_ : patient_mm;
    return {dot(right_, off), dot(down_, off), eye_mm_ ? dot(along_, off) : 1};
  }

  /// Even-odd rule, for a point in front of the eye.
  bool holds(Vec3 point) const {
    const double x = point.x / point.z, y = point.y / point.z;
    bool inside = false;
    for (std::size_t n = 0; n < corners_.size(); ++n) {
      const Vec3 a = flat(n), b = flat((n + 1) % corners_.size());
      if ((a.y > y) != (b.y > y) && x < a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y)) inside = !inside;
    }
    return inside;
  }

  /// Sets those voxels of `row` that are inside the polygon; voxel i is displayed at from + step * i.
  void fill(Vec3 from, Vec3 step, std::span<std::uint8_t> row, std::vector<double>& crossings) const {
    const double last = static_cast<double>(row.size()) - 1;
    const Vec3 line = cross(from, step);
    if (norm(line) <= 1e-9 * (1 + norm(from))) {  // the view is along the row
      const Vec3 middle = from + step * (last / 2);
      if (middle.z > 0 && holds(middle)) std::ranges::fill(row, std::uint8_t{1});
      return;
    }
    crossings.clear();
    for (std::size_t n = 0; n < corners_.size(); ++n) {
      const Vec3 a = corners_[n], b = corners_[(n + 1) % corners_.size()];
      if ((dot(line, a) >= 0) == (dot(line, b) >= 0)) continue;
      const Vec3 edge = cross(a, b);
      const double slope = dot(edge, step);
      if (slope == 0) continue;
      const double at = -dot(edge, from) / slope;
      if (from.z + step.z * at > 0) crossings.push_back(at);
    }
    std::ranges::sort(crossings);
    // A row that begins behind the eye enters the image from far outside; a row that ends behind it leaves the image
    // far outside.
    bool inside = step.z < 0 && crossings.size() % 2 == 1;
    std::size_t next = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const auto at = static_cast<double>(i);
      for (; next < crossings.size() && crossings[next] <= at; ++next) inside = !inside;
      row[i] = inside && from.z + step.z * at > 0;
    }
  }

 private:
  Vec3 flat(std::size_t n) const { return corners_[n] / corners_[n].z; }

  Vec3 along_, right_, down_;
  std::optional<Vec3> eye_mm_;
  std::vector<Vec3> corners_;
};

}  // namespace

Result<Selection> scissorsVoxels(const VolumeGeometry& geometry, const VoxelBox& box, std::span<const Vec3> corners_mm,
                                 const ScissorsView& view) {
  if (corners_mm.size() < 3) return fail("An outline needs at least three corners; draw a larger outline.");
  const Outline outline(corners_mm, view);
  if (!outline.allInFront())
    return fail("A corner of the outline lies behind the camera. Draw the outline on visible parts.");
  Selection chosen(geometry, box);
  if (box.empty()) return chosen;
  const Vec3 surface_mm = view.surface_mm.value_or(corners_mm.front());
  const Transform patientFromIndex = geometry.patientFromIndex();
  tbb::parallel_for(box.first[2], box.end[2], [&](int k) {
    std::vector<double> crossings;
    for (int j = box.first[1]; j < box.end[1]; ++j) {
      const Vec3 from = outline.seen(patientFromIndex * Vec3{double(box.first[0]), double(j), double(k)});
      const Vec3 next = outline.seen(patientFromIndex * Vec3{double(box.first[0] + 1), double(j), double(k)});
      const std::span row(&chosen.mask.at(0, j - box.first[1], k - box.first[2]), std::size_t(box.length(0)));
      outline.fill(from, next - from, row, crossings);
      if (view.outside)
        for (std::uint8_t& voxel : row) voxel ^= 1;
      if (view.depth_mm <= 0) continue;
      for (std::size_t i = 0; i < row.size(); ++i) {
        const Vec3 voxel_mm = patientFromIndex * Vec3{box.first[0] + double(i), double(j), double(k)};
        const double depth_mm = dot(view.along, voxel_mm - surface_mm);
        if ((view.eye_mm ? depth_mm : std::abs(depth_mm)) > view.depth_mm) row[i] = 0;
      }
    }
  });
  return chosen;
}

Result<Selection> polygonVoxels(const VolumeGeometry& geometry, int sliceAxis, std::span<const Vec3> corners_mm) {
  if (corners_mm.size() < 3) return fail("An outline needs at least three corners; draw a larger outline.");
  const Vec3 index = geometry.indexFromPatient() * corners_mm.front();
  const double slice = std::floor(index[sliceAxis] + 0.5);
  if (!(slice >= 0 && slice < geometry.size[sliceAxis]))
    return fail("The outline lies outside the CT. Draw the outline on a slice.");
  VoxelBox box = boxOf(geometry);
  box.first[sliceAxis] = static_cast<int>(slice);
  box.end[sliceAxis] = box.first[sliceAxis] + 1;
  double reach_mm = 0;
  for (const Vec3& corner_mm : corners_mm) reach_mm = std::max(reach_mm, norm(corner_mm - corners_mm.front()));
  box = intersected(box, boxAround(geometry, corners_mm.first(1), reach_mm + geometry.spacing_mm[sliceAxis]));
  return scissorsVoxels(geometry, box, corners_mm, {.along = geometry.direction.column[sliceAxis]});
}

}  // namespace insonate
