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

/// Structures whose surface a needle can feel. Skin stands for the whole body.
inline constexpr std::array<Label, 6> kNeedleWalls{kSkin, kVein, kArtery, kAirway, kBone, kCartilage};
inline constexpr int kNeedleWallCount = static_cast<int>(kNeedleWalls.size());

/// Tissue at a point.
struct TissueSample {
  std::array<float, kNeedleWallCount> distance_mm{};  ///< to each of kNeedleWalls, negative inside
  std::uint8_t label = kBackground;
};

/// Signed distances and labels of tissue at rest on a grid in patient space. Made once by a slow thread, then only
/// read: any number of threads may sample it. Distances are kept to 0.01 mm and up to 300 mm.
class TissueGrid {
 public:
  using Sampler = std::function<TissueSample(Vec3 patient_mm)>;

  /// Evaluates `sampler` at every point. Fails on an invalid grid, or one of more than 40 million points.
  static Result<std::shared_ptr<const TissueGrid>> make(const VolumeGeometry& geometry, const Sampler& sampler);
  /// The labels' own grid; surfaces lie between the voxels, rounded over about one of them. Seconds for 10 million.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, const Progress& progress = {});
  /// Makes a grid of the tissue within `reach_mm` of a point along each of the map's axes. Distances are exact as long
  /// as they are below the distance to the edge. Fails if the map does not reach there, and when cancelled.
  static Result<std::shared_ptr<const TissueGrid>> fromLabels(const LabelMap& labels, Vec3 centre_mm, double reach_mm,
                                                              const Progress& progress = {});

  const VolumeGeometry& geometry() const { return geometry_; }

  /// Distances interpolated, label of the nearest point; beyond the grid what lies at its edge. Neither waits nor
  /// allocates.
  TissueSample at(Vec3 patient_mm) const noexcept;
  /// Unit vector of growing distance to one wall (an index of kNeedleWalls); 0 without one.
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
