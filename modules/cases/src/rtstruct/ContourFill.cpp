#include "ContourFill.h"

#include "../files/LabelGrid.h"
#include "../import/StackPlan.h"
#include "ShapeDistance.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>

namespace insonate {
namespace {

/// Distance within which points lie in one plane: coordinates are decimals of a few digits.
constexpr double kFlat_mm = 0.1, kSamePlane_mm = 0.05;
/// A plane nearer to a slice than this part of the slices' distance lies in the slice.
constexpr double kInSlice = 0.1;

struct Interval {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
  void add(double value) { low = std::min(low, value), high = std::max(high, value); }
  double middle() const { return (low + high) / 2; }
};

Interval depthsOf(const ContourCorners& contour, Vec3 normal) {
  Interval depths;
  for (const Vec3 corner : contour) depths.add(dot(corner, normal));
  return depths;
}

bool isFlat(const ContourCorners& contour, Vec3 normal) {
  const Interval depths = depthsOf(contour, normal);
  return depths.high - depths.low <= kFlat_mm;
}

/// Twice the area of a contour, along its normal (Newell's method).
Vec3 areaOf(const ContourCorners& contour) {
  Vec3 area;
  for (std::size_t n = 0; n < contour.size(); ++n)
    area = area + cross(contour[n] - contour[0], contour[(n + 1) % contour.size()] - contour[0]);
  return area;
}

/// Depths of different planes, ascending.
std::vector<double> withoutRepeats(std::vector<double> depths_mm) {
  std::ranges::sort(depths_mm);
  depths_mm.erase(std::unique(depths_mm.begin(), depths_mm.end(),
                              [](double a, double b) { return std::abs(a - b) <= kSamePlane_mm; }),
                  depths_mm.end());
  return depths_mm;
}

/// Median distance of neighboring planes; 0 for a single plane.
double usualStep(const std::vector<double>& depths_mm) {
  std::vector<double> steps;
  for (std::size_t n = 1; n < depths_mm.size(); ++n) steps.push_back(depths_mm[n] - depths_mm[n - 1]);
  if (steps.empty()) return 0;
  std::ranges::nth_element(steps, steps.begin() + std::ptrdiff_t(steps.size() / 2));
  return steps[steps.size() / 2];
}

struct ContourPlane {
  double k = 0;                                 ///< depth as a slice number
  std::vector<const ContourCorners*> contours;  ///< corners as voxel indices
};

/// Contours as voxel indices, sorted into planes. A contour that a file contains twice would erase itself.
std::vector<ContourPlane> planesOfContours(std::vector<ContourCorners>& indexed, double spacing_mm) {
  const auto depth = [](const ContourCorners& c) { return depthsOf(c, {0, 0, 1}).middle(); };
  std::ranges::sort(indexed, {}, depth);
  std::vector<ContourPlane> planes;
  for (const ContourCorners& contour : indexed) {
    if (planes.empty() || (depth(contour) - planes.back().k) * spacing_mm > kSamePlane_mm)
      planes.push_back({depth(contour), {}});
    planes.back().contours.push_back(&contour);
  }
  const auto before = [](const ContourCorners* a, const ContourCorners* b) {
    return std::ranges::lexicographical_compare(
        *a, *b, [](Vec3 p, Vec3 q) { return std::tuple(p.x, p.y, p.z) < std::tuple(q.x, q.y, q.z); });
  };
  for (ContourPlane& plane : planes) {
    std::ranges::sort(plane.contours, before);
    plane.contours.erase(std::unique(plane.contours.begin(), plane.contours.end(),
                                     [](const ContourCorners* a, const ContourCorners* b) { return *a == *b; }),
                         plane.contours.end());
  }
  return planes;
}

/// Marks the first pixel behind each place at which a row of the box crosses an edge; a second mark cancels the first.
/// An edge that is passed in both directions, as in a contour that leads to a hole and back, thus has no effect.
void markCrossings(Vec3 from, Vec3 to, const VoxelBox& box, SliceMask& marks) {
  if (std::tuple(from.y, from.x) > std::tuple(to.y, to.x)) std::swap(from, to);
  const double first = std::max(std::ceil(from.y), double(box.first[1]));
  const double end = std::min(std::ceil(to.y), double(box.end[1]));
  for (int j = static_cast<int>(first); j < end; ++j) {
    const double x = std::ceil(from.x + (j - from.y) * (to.x - from.x) / (to.y - from.y));
    if (x >= box.end[0]) continue;
    const int column = static_cast<int>(std::max(x, double(box.first[0]))) - box.first[0];
    marks.inside[std::size_t(j - box.first[1]) * marks.columns + column] ^= 1;
  }
}

SliceMask maskOf(const ContourPlane& plane, const VoxelBox& box) {
  SliceMask mask{box.length(0), box.length(1), {}};
  mask.inside.resize(std::size_t(mask.columns) * mask.rows);
  for (const ContourCorners* contour : plane.contours)
    for (std::size_t n = 0; n < contour->size(); ++n)
      markCrossings((*contour)[n], (*contour)[(n + 1) % contour->size()], box, mask);
  for (int j = 0; j < mask.rows; ++j) {
    const auto row = mask.inside.begin() + std::ptrdiff_t(j) * mask.columns;
    std::partial_sum(row, row + mask.columns, row, std::bit_xor<>());
  }
  return mask;
}

/// The shapes of slices, computed from the contours of the planes around them.
class PlaneShapes {
 public:
  PlaneShapes(const std::vector<ContourPlane>& planes, const VoxelBox& box, const VolumeGeometry& grid,
              const ContourSpacing& spacing)
      : planes_(planes), box_(box), grid_(grid), spacing_(spacing) {}

  /// Slices must be asked for in ascending order; `interpolated` counts slices between planes. The mask is empty in
  /// slices without a shape.
  SliceMask ofSlice(int k, int& interpolated) {
    const double depth = k - kOffTheBorder;
    const auto above = std::ranges::lower_bound(planes_, depth, {}, &ContourPlane::k);
    const auto upper = std::size_t(above - planes_.begin());
    const bool isBetween = upper > 0 && upper < planes_.size();
    const bool isNearerBelow =
        isBetween ? depth - planes_[upper - 1].k < planes_[upper].k - depth : upper == planes_.size();
    const std::size_t nearest = isNearerBelow ? upper - 1 : upper;
    const double away = std::abs(planes_[nearest].k - depth);
    if (away > kInSlice && isBetween && isSmallGap(planes_[upper].k - planes_[upper - 1].k)) {
      ++interpolated;
      return between(upper - 1, k);
    }
    return away <= std::max(kInSlice, spacing_.reach_mm / grid_.spacing_mm.z) ? maskOf(planes_[nearest], box_)
                                                                              : SliceMask{};
  }

 private:
  bool isSmallGap(double slices) const {
    constexpr double kMostSlices = 4, kRounding = 0.01, kUsual = 1.5;
    const double gap_mm = slices * grid_.spacing_mm.z;
    return gap_mm <= kLargestFilledGap_mm + kRounding &&
           (slices <= kMostSlices + kRounding || gap_mm <= kUsual * spacing_.step_mm);
  }

  /// Interpolates the signed distance to the borders of the shapes in two neighboring planes.
  SliceMask between(std::size_t below, double k) {
    distances_.erase(distances_.begin(), distances_.lower_bound(below));
    const std::vector<float>&low = distancesOf(below), &high = distancesOf(below + 1);
    const auto t = static_cast<float>((k - planes_[below].k) / (planes_[below + 1].k - planes_[below].k));
    SliceMask mask{box_.length(0), box_.length(1), std::vector<std::uint8_t>(low.size())};
    for (std::size_t p = 0; p < low.size(); ++p) mask.inside[p] = (1 - t) * low[p] + t * high[p] > 0;
    return mask;
  }

  const std::vector<float>& distancesOf(std::size_t plane) {
    const auto [found, isNew] = distances_.try_emplace(plane);
    if (isNew) found->second = shapeDistances(maskOf(planes_[plane], box_), grid_.spacing_mm.x, grid_.spacing_mm.y);
    return found->second;
  }

  const std::vector<ContourPlane>& planes_;
  const VoxelBox& box_;
  const VolumeGeometry& grid_;
  ContourSpacing spacing_;
  std::map<std::size_t, std::vector<float>> distances_;
};

int clampedIndex(double index, int size) {
  return static_cast<int>(std::clamp(index, 0.0, double(size)));
}

/// Block of the grid around contours, with one voxel more on each side.
VoxelBox boxOfContours(const std::vector<ContourCorners>& indexed, const VolumeGeometry& grid, double reach) {
  std::array<Interval, 3> bounds;
  for (const ContourCorners& contour : indexed)
    for (const Vec3 corner : contour)
      for (int a = 0; a < 3; ++a) bounds[std::size_t(a)].add(corner[a]);
  VoxelBox box;
  for (std::size_t a = 0; a < 3; ++a) {
    const double margin = a == 2 ? reach : 1;
    box.first[a] = clampedIndex(std::floor(bounds[a].low - margin), grid.size[a]);
    box.end[a] = clampedIndex(std::ceil(bounds[a].high + margin) + 1, grid.size[a]);
  }
  return box;
}

}  // namespace

bool areParallelToSlices(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid) {
  return std::ranges::all_of(contours, [&](const ContourCorners& c) { return isFlat(c, grid.direction.column[2]); });
}

std::optional<VolumeGeometry> gridOfPlanes(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid) {
  Vec3 largest;
  for (const ContourCorners& contour : contours)
    if (const Vec3 area = areaOf(contour); norm(area) > norm(largest)) largest = area;
  if (!(norm(largest) > 0)) return std::nullopt;
  const Vec3 normal = normalized(largest);
  std::vector<double> depths;
  for (const ContourCorners& contour : contours) {
    if (!isFlat(contour, normal)) return std::nullopt;
    depths.push_back(depthsOf(contour, normal).middle());
  }
  depths = withoutRepeats(std::move(depths));
  const auto inPlane = [&](int axis) {
    return grid.direction.column[std::size_t(axis)] - dot(grid.direction.column[std::size_t(axis)], normal) * normal;
  };
  const Vec3 along = normalized(norm(inPlane(0)) > 0.5 ? inPlane(0) : inPlane(1)), down = cross(normal, along);
  Interval columns, rows;
  for (const ContourCorners& contour : contours)
    for (const Vec3 corner : contour) columns.add(dot(corner, along)), rows.add(dot(corner, down));
  const Vec3 s = grid.spacing_mm;
  const double step_mm = depths.size() > 1 ? usualStep(depths) : std::max({s.x, s.y, s.z});
  constexpr double kMostVoxels = 2e8;
  for (const double fineness : {0.5, 1.0}) {
    const double pixel_mm = fineness * std::min({s.x, s.y, s.z});
    const double across = std::ceil((columns.high - columns.low) / pixel_mm) + 3;
    const double upright = std::ceil((rows.high - rows.low) / pixel_mm) + 3;
    const double slices = std::round((depths.back() - depths.front()) / step_mm) + 1;
    if (across * upright * slices > kMostVoxels) continue;
    VolumeGeometry planes;
    planes.size = {static_cast<int>(across), static_cast<int>(upright), static_cast<int>(slices)};
    planes.spacing_mm = {pixel_mm, pixel_mm, step_mm};
    planes.direction = {{along, down, normal}};
    planes.origin_mm = (columns.low - pixel_mm) * along + (rows.low - pixel_mm) * down + depths.front() * normal;
    return planes;
  }
  return std::nullopt;
}

ContourSpacing spacingOfPlanes(const std::vector<DrawnStructure>& structures, const VolumeGeometry& grid) {
  const Vec3 normal = grid.direction.column[2];
  std::vector<double> depths_mm;
  for (const DrawnStructure& structure : structures)
    for (const ContourCorners& contour : structure.contours)
      if (isFlat(contour, normal)) depths_mm.push_back(dot(normal, contour.front() - grid.origin_mm));
  depths_mm = withoutRepeats(std::move(depths_mm));
  const double slice_mm = grid.spacing_mm.z, step_mm = usualStep(depths_mm);
  const auto inSlices = std::ranges::count_if(depths_mm, [&](double depth_mm) {
    const double k = depth_mm / slice_mm;
    return std::abs(k - std::round(k)) < kInSlice;
  });
  constexpr double kMost = 0.9;
  const bool drawnHere = double(inSlices) >= kMost * double(depths_mm.size());
  return {0.5 * (drawnHere ? slice_mm : std::max(slice_mm, step_mm)), step_mm};
}

FilledStructure fillContours(const std::vector<ContourCorners>& contours, const VolumeGeometry& grid,
                             const ContourSpacing& spacing) {
  const Transform indexFromPatient = grid.indexFromPatient();
  std::vector<ContourCorners> indexed = contours;
  for (ContourCorners& contour : indexed)
    for (Vec3& corner : contour) corner = indexFromPatient * corner;
  const double slice_mm = grid.spacing_mm.z, reach = spacing.reach_mm / slice_mm;
  FilledStructure filled{boxOfContours(indexed, grid, reach), {}, 0, 0};
  if (filled.box.empty()) {
    filled.contoursOutside = contours.size();
    return filled;
  }
  const std::vector<ContourPlane> planes = planesOfContours(indexed, slice_mm);
  for (const ContourPlane& plane : planes)
    if (plane.k < -reach || plane.k > grid.size[2] - 1 + reach) filled.contoursOutside += plane.contours.size();
  PlaneShapes shapes(planes, filled.box, grid, spacing);
  const std::size_t area = std::size_t(filled.box.length(0)) * filled.box.length(1);
  filled.inside.resize(area * filled.box.length(2));
  for (int k = filled.box.first[2]; k < filled.box.end[2]; ++k) {
    const SliceMask mask = shapes.ofSlice(k, filled.interpolatedSlices);
    std::ranges::copy(mask.inside, filled.inside.begin() + std::ptrdiff_t(area * std::size_t(k - filled.box.first[2])));
  }
  return filled;
}

}  // namespace insonate
