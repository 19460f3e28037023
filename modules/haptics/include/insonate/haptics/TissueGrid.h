#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/image/Volume.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace insonate {

/// Structures whose surface resists a needle's tip. kSkin is the surface of the whole body.
inline constexpr std::array<Label, 6> kNeedleWalls{kSkin, kVein, kArtery, kAirway, kBone, kCartilage};
inline constexpr int kNeedleWallCount = static_cast<int>(kNeedleWalls.size());

/// Tissue at a point.
struct TissueSample {
  /// distance to the surface of each of kNeedleWalls, negative inside the structure
  std::array<float, kNeedleWallCount> distance_mm{};
  std::uint8_t label = kBackground;
};

/// Grid of undeformed tissue in patient space. Each grid point stores the label and the signed distances to
/// kNeedleWalls, in steps of 0.01 mm up to 300 mm. The grid is constant; any number of threads may sample it.
class TissueGrid {
 public:
  using Sampler = std::function<TissueSample(Vec3 patient_mm)>;

  /// Evaluates `sampler` at every grid point. Fails on an invalid grid, or on more than 40 million points.
  static Result<std::shared_ptr<const TissueGrid>> make(const VolumeGeometry& geometry, const Sampler& sampler);
  /// Makes a grid whose points are the voxel centers of the label map. Surfaces of structures lie between voxels and
  /// are smoothed over about one voxel. Takes seconds for 10 million voxels.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, const Progress& progress = {});
  /// Makes a grid of a box of the label map. The box reaches from `center_mm` by `reach_mm` to either side along each
  /// axis of the map. The distance of a grid point to a surface is exact if it is smaller than the distance of the grid
  /// point to the edge of the box. Fails if the box lies outside the map, or if cancelled.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, Vec3 center_mm, double reach_mm,
                                                              const Progress& progress = {});

  const VolumeGeometry& geometry() const { return geometry_; }

  /// Returns the tissue at a point: interpolated distances, and the label of the nearest grid point. For a point beyond
  /// the grid, returns the values at the edge of the grid. Neither waits nor allocates.
  TissueSample at(Vec3 patient_mm) const noexcept;
  /// Returns the outward normal of a wall (`wall`: index of kNeedleWalls) at the point `patient_mm`: the unit gradient
  /// of the signed distance to the wall, which is positive outside the structure. Returns the zero vector if the grid
  /// has no such wall.
  Vec3 outward(Vec3 patient_mm, int wall) const noexcept;

 private:
  struct Point {
    std::array<std::int16_t, kNeedleWallCount> distance{};
    std::uint8_t label = kBackground;
  };

  explicit TissueGrid(const VolumeGeometry& geometry);
  void set(std::size_t offset, const TissueSample& sample);

  VolumeGeometry geometry_;
  Transform indexFromPatient_;
  std::vector<Point> points_;
};

}  // namespace insonate
