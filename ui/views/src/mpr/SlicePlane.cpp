#include <insonate/views/SlicePlane.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace insonate::views {

SliceAxes sliceAxes(SliceKind kind, const Transform& patientFromProbe) {
  switch (kind) {
    case SliceKind::Coronal:
      return {{1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
    case SliceKind::Sagittal:
      return {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    case SliceKind::Oblique: {
      const auto& axis = patientFromProbe.linear.column;
      return {axis[0], -axis[2], axis[1]};
    }
    case SliceKind::Axial:
      break;
  }
  return {};
}

Vec3 SlicePlane::patientFromDisplay(DisplayPoint at) const {
  return center_mm + axes.right * ((at.x - 0.5 * width_px) * mm_per_px) +
         axes.up * ((0.5 * height_px - at.y) * mm_per_px);
}

DisplayPoint SlicePlane::displayFromPatient(Vec3 point_mm) const {
  const Vec3 off_mm = point_mm - center_mm;
  return {0.5 * width_px + dot(off_mm, axes.right) / mm_per_px, 0.5 * height_px - dot(off_mm, axes.up) / mm_per_px};
}

std::string orientationLetters(Vec3 direction) {
  struct Part {
    double size;
    char letter;
  };
  std::array<Part, 3> parts{{{std::abs(direction.x), direction.x > 0 ? 'L' : 'R'},
                             {std::abs(direction.y), direction.y > 0 ? 'P' : 'A'},
                             {std::abs(direction.z), direction.z > 0 ? 'H' : 'F'}}};
  std::ranges::stable_sort(parts, [](const Part& a, const Part& b) { return a.size > b.size; });
  std::string letters;
  // A component below sin(15 degrees) counts as an inaccuracy of the hand.
  for (const Part& part : parts)
    if (part.size > 0.26 * norm(direction)) letters += part.letter;
  return letters;
}

std::string patientSide(Vec3 direction) {
  const Vec3 size{std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)};
  if (size.z > size.x && size.z > size.y) return direction.z > 0 ? "Head" : "Foot";
  if (size.y > size.x) return direction.y > 0 ? "P" : "A";
  return direction.x > 0 ? "L" : "R";
}

double sliceStep_mm(const VolumeGeometry& grid, Vec3 normal) {
  int best = 0;
  for (int axis = 1; axis < 3; ++axis)
    if (std::abs(dot(grid.direction.column[axis], normal)) > std::abs(dot(grid.direction.column[best], normal)))
      best = axis;
  // An oblique plane has no slices of the grid; a step of the smallest voxel size omits nothing.
  const bool aligned = std::abs(dot(grid.direction.column[best], normal)) > 0.999;
  return aligned ? grid.spacing_mm[best] : std::min({grid.spacing_mm.x, grid.spacing_mm.y, grid.spacing_mm.z});
}

}  // namespace insonate::views
