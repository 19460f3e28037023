#include "../files/LabelGrid.h"
#include "SegReader.h"

#include <insonate/image/VoxelBox.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace insonate {
namespace {

using Frame = DicomSegments::Frame;

/// Frames at one place; later frames take precedence.
struct Plane {
  double z_mm = 0;
  std::vector<const Frame*> frames;
};

std::vector<Plane> planesOf(const DicomSegments& segments, Vec3 normal) {
  std::vector<const Frame*> sorted;
  for (const Frame& frame : segments.frames) sorted.push_back(&frame);
  const auto z = [&](const Frame* frame) { return dot(frame->position_mm, normal); };
  std::ranges::stable_sort(sorted, {}, z);
  std::vector<Plane> planes;
  const double samePlace_mm = 0.01 * segments.step_mm;
  for (const Frame* frame : sorted) {
    if (planes.empty() || z(frame) - planes.back().z_mm > samePlace_mm) planes.push_back({z(frame), {}});
    planes.back().frames.push_back(frame);
  }
  // Within the tolerance, planes are sorted by position, not by segment.
  for (Plane& plane : planes)
    std::ranges::sort(plane.frames, {}, [&](const Frame* f) { return f - segments.frames.data(); });
  return planes;
}

class Placer {
 public:
  explicit Placer(const DicomSegments& segments)
      : s_(segments), normal_(cross(s_.direction[0], s_.direction[1])), planes_(planesOf(s_, normal_)) {}

  /// Place in `structures` of the last segment that contains a place; 0 for none. `overlaps` counts places in several
  /// structures.
  std::uint8_t partAt(Vec3 p_mm, std::size_t& overlaps) const {
    const Plane* plane = planeAt(dot(p_mm, normal_) - kOffTheBorder * s_.step_mm);
    std::uint8_t part = 0;
    if (!plane) return part;
    for (const Frame* frame : plane->frames) {
      const Vec3 from = p_mm - frame->position_mm;
      const long i = std::lround(dot(from, s_.direction[0]) / s_.spacing_mm[0] - kOffTheBorder);
      const long j = std::lround(dot(from, s_.direction[1]) / s_.spacing_mm[1] - kOffTheBorder);
      if (i < 0 || j < 0 || i >= s_.columns || j >= s_.rows) continue;
      const std::uint8_t found = s_.partAt(*frame, static_cast<std::size_t>(j * s_.columns + i));
      if (found == 0) continue;
      overlaps += part != 0 && labelOf(part) != labelOf(found);
      part = found;
    }
    return part;
  }

  std::uint8_t labelOf(std::uint8_t part) const { return part == 0 ? 0 : s_.structures[part - 1].label; }

  std::size_t lostPixels(const VolumeGeometry& grid) const {
    const Transform indexFromPatient = grid.indexFromPatient();
    std::size_t lost = 0;
    for (const Frame& frame : s_.frames)
      for (int j = 0; j < s_.rows; ++j)
        for (int i = 0; i < s_.columns; ++i) {
          if (s_.partAt(frame, static_cast<std::size_t>(j) * s_.columns + i) == 0) continue;
          const auto [x, y, z] = nearestVoxel(indexFromPatient * placeOf(frame, i, j));
          lost += !grid.contains(x, y, z);
        }
    return lost;
  }

  bool fallsOn(const VolumeGeometry& grid) const {
    const std::array steps{s_.direction[0] * s_.spacing_mm[0], s_.direction[1] * s_.spacing_mm[1],
                           normal_ * s_.step_mm};
    return std::ranges::all_of(s_.frames, [&](const Frame& f) { return fallsOnVoxels(grid, f.position_mm, steps); });
  }

 private:
  const Plane* planeAt(double z_mm) const {
    const auto above = std::ranges::lower_bound(planes_, z_mm, {}, &Plane::z_mm);
    const Plane* nearest = above == planes_.end() ? &planes_.back() : &*above;
    if (above != planes_.begin() && z_mm - std::prev(above)->z_mm < std::abs(nearest->z_mm - z_mm))
      nearest = &*std::prev(above);
    // Positions and spacing are decimals of a few digits: the tolerance prevents gaps between slices.
    const double reach_mm = 0.5 * s_.step_mm * (1 + 1e-3);
    return std::abs(nearest->z_mm - z_mm) <= reach_mm ? nearest : nullptr;
  }
  Vec3 placeOf(const Frame& frame, int i, int j) const {
    return frame.position_mm + i * s_.spacing_mm[0] * s_.direction[0] + j * s_.spacing_mm[1] * s_.direction[1];
  }

  const DicomSegments& s_;
  Vec3 normal_;
  std::vector<Plane> planes_;
};

}  // namespace

Result<LabelReadResult> placeSegments(const DicomSegments& segments, const VolumeGeometry& grid,
                                      const Progress& progress) {
  LabelReadResult result{LabelMap(grid), segments.notes, segments.colors, segments.own, segments.foreign};
  result.structures = segments.structures;
  result.parts = Volume<std::uint16_t>(grid);
  const Placer placer(segments);
  const Transform patientFromIndex = grid.patientFromIndex();
  std::atomic<std::size_t> overlaps = 0;
  for (int k = 0; k < grid.size[2]; ++k) {
    if (!report(progress, "Placing labels", double(k) / grid.size[2])) return fail(std::string(kCancelled));
    tbb::parallel_for(0, grid.size[1], [&](int j) {
      std::size_t found = 0;
      for (int i = 0; i < grid.size[0]; ++i) {
        const std::uint8_t part = placer.partAt(patientFromIndex * Vec3{double(i), double(j), double(k)}, found);
        result.parts.at(i, j, k) = part;
        result.labels.at(i, j, k) = placer.labelOf(part);
      }
      overlaps += found;
    });
  }
  if (std::ranges::none_of(result.labels.voxels, [](std::uint8_t v) { return v != 0; }))
    return fail(
        "the segmentation lies completely outside the CT, so it was drawn on another CT. Choose the segmentation of "
        "this CT.");
  if (overlaps > 0)
    result.notes.push_back(std::to_string(overlaps) +
                           " voxels belong to several segments; each gets the label of the last one.");
  const std::size_t lost = placer.lostPixels(grid);
  if (lost > 0 || !placer.fallsOn(grid)) noteOtherGrid(placer.fallsOn(grid), lost, result.notes);
  return result;
}

}  // namespace insonate
