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

/// Structures whose surface a needle can feel. Skin is the surface of the whole body.
inline constexpr std::array<Label, 6> kNeedleWalls{kSkin, kVein, kArtery, kAirway, kBone, kCartilage};
inline constexpr int kNeedleWallCount = static_cast<int>(kNeedleWalls.size());

/// Tissue at a point.
struct TissueSample {
  std::array<float, kNeedleWallCount> distance_mm{};  ///< distance to each of kNeedleWalls, negative inside
  std::uint8_t label = kBackground;
};

/// Signed distances and labels of tissue at rest on a grid in patient space. It is constant: any number of threads may
/// sample it. Distances are stored in steps of 0.01 mm, up to 300 mm.
class TissueGrid {
 public:
  using Sampler = std::function<TissueSample(Vec3 patient_mm)>;

  /// Evaluates `sampler` at every grid point. Fails on an invalid grid, or on more than 40 million points.
  static Result<std::shared_ptr<const TissueGrid>> make(const VolumeGeometry& geometry, const Sampler& sampler);
  /// Makes a grid with the points of the label map; surfaces lie between the voxels and are smoothed over about one
  /// voxel. Takes seconds for 10 million voxels.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, const Progress& progress = {});
  /// Makes a grid of the tissue within `reach_mm` of a point along each of the map's axes. A distance is exact if it is
  /// smaller than the distance to the grid's edge. Fails if the map does not reach the point, or if cancelled.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, Vec3 centre_mm, double reach_mm,
                                                              const Progress& progress = {});

  const VolumeGeometry& geometry() const { return geometry_; }

  /// Samples the grid: distances are interpolated, the label is that of the nearest point. Beyond the grid, the values
  /// at its edge are returned. Neither waits nor allocates.
  TissueSample at(Vec3 patient_mm) const noexcept;
  /// Unit vector in which the distance to one wall (an index of kNeedleWalls) grows; 0 if there is no such wall.
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
