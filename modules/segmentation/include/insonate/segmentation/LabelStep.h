#pragma once

#include <insonate/core/Progress.h>
#include <insonate/segmentation/CutOff.h>
#include <insonate/segmentation/FastMarching.h>
#include <insonate/segmentation/GrowFromSeeds.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/LevelSet.h>
#include <insonate/segmentation/Logical.h>
#include <insonate/segmentation/Margin.h>
#include <insonate/segmentation/Polygon.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/SectionOutline.h>
#include <insonate/segmentation/TubeTracking.h>
#include <insonate/segmentation/VesselTracking.h>

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

/// Parameters of the labeling tools. Recipes use the same names. Points are in patient space, mm.
namespace step {

/// Tool that writes the labels that autoLabel() finds; if `take` is not empty, only the labels in `take`.
struct Auto {
  std::vector<std::uint8_t> take{};
};
/// Tool that selects voxels by CT value (threshold()).
struct Threshold {
  HuRange range_HU{};
};
/// Tool that paints with a brush along points (strokeVoxels()). If `only_HU` is set, it paints only voxels with these
/// CT values.
struct Paint {
  std::vector<Vec3> points_mm{};
  double radius_mm = 4;
  std::optional<int> sliceAxis{};
  std::optional<HuRange> only_HU{};
};
/// Tool that selects the inside of a polygon on a slice (polygonVoxels()).
struct Draw {
  std::vector<Vec3> points_mm{};
  int sliceAxis = 2;
};
/// Tool that selects the voxels that lie inside a polygon in a 3D view (scissorsVoxels()).
struct Scissors {
  std::vector<Vec3> points_mm{};
  ScissorsView view{};
};
/// Tool that keeps the largest islands (connected components) of the label.
struct KeepLargest {
  int islands = 1;
};
/// Tool that removes islands (connected components) of the label that are smaller than a volume.
struct RemoveSmall {
  double min_mm3 = 100;
};
/// Tool that keeps one island (connected component) of the label.
struct KeepIsland {
  std::vector<Vec3> points_mm{};  ///< exactly one point, inside the island to keep
};
/// Tool that gives each island (connected component) of the label another label.
struct SplitIslands {
  std::vector<std::uint8_t> into{};  ///< labels for the islands, the largest island first
};
/// Tool that smooths the label with a median filter (medianSmoothed()).
struct Median {
  double radius_mm = 1;
};
/// Tool that removes thin parts of the label (opened()).
struct Opening {
  double radius_mm = 1;
};
/// Tool that fills gaps of the label (closed()).
struct Closing {
  double radius_mm = 1;
};
/// Tool that smooths the label with a Gaussian (gaussianSmoothed()).
struct Gaussian {
  double sigma_mm = 1;
};
/// Tool that smooths several labels together (jointlySmoothed()).
struct SmoothTogether {
  double sigma_mm = 1;
  std::vector<std::uint8_t> labels{};
};
/// Tool that grows or shrinks the label by a distance.
struct Margin {
  double margin_mm = 2;  ///< distance by which the shape grows; negative to shrink
};
/// Tool that replaces the label by a shell along its surface (makeShell()).
struct Hollow {
  double thickness_mm = 2;
  Wall wall = Wall::kInside;
};
/// Tool that combines the label with another label (combined()).
struct Logical {
  LogicalOperation operation = LogicalOperation::kAdd;
  std::uint8_t with = 0;
  /// voxels within this distance of the label `with` also count as `with`; above 0 except for kAdd, since labels do not
  /// overlap
  double reach_mm = 0;
};
/// Tool that interpolates the label between slices (fillBetweenSlices()).
struct FillBetween {
  int sliceAxis = 2;
};
/// Tool that grows a region of connected voxels whose CT values are in a range (connected()).
struct Connected {
  std::vector<Vec3> points_mm{};
  HuRange range_HU{};
};
/// Tool that grows a region of connected voxels whose CT values are in a range; the range is measured in the region
/// (confidenceConnected()).
struct ConfidenceConnected {
  std::vector<Vec3> points_mm{};
  Confidence confidence{};
};
/// Tool that grows the labels `seeds` into voxels of the labels `over` (grownFromSeeds()).
struct GrowSeeds {
  std::vector<std::uint8_t> seeds{}, over{};
  SeedCompetition competition{};
};
/// Tool that grows the labels `seeds` into voxels of the labels `over` by a watershed (watershed()).
struct Watershed {
  std::vector<std::uint8_t> seeds{}, over{};
  double smoothing_mm = 1;
};
/// Tool that spreads a front from points (fastMarching()).
struct March {
  std::vector<Vec3> points_mm{};
  MarchingFront front{};
};
/// Tool that moves the surface of the label to edges of the CT (levelSet()).
struct Contour {
  GeodesicLevelSet levelSet{};
};
/// Tool that tracks a vessel that is filled with contrast agent; the points lie on the vessel (trackVessel()).
struct Vessel {
  std::vector<Vec3> points_mm{};
  VesselTracking tracking{};
};
/// Tool that tracks a vessel without contrast agent, or a muscle; the points lie on the structure (trackTube()).
struct Tube {
  std::vector<Vec3> points_mm{};
  TubeTracking tracking{};
};
/// Tool that changes a vessel to an outline in one cross-section (reshapedVessel()).
struct Outline {
  SectionOutline outline{};
};
/// Tool that removes the part of the label behind a stroke (partCutOff()).
struct CutOff {
  CutStroke stroke{};
};

}  // namespace step

using LabelTool =
    std::variant<step::Auto, step::Threshold, step::Paint, step::Draw, step::Scissors, step::KeepLargest,
                 step::RemoveSmall, step::KeepIsland, step::SplitIslands, step::Median, step::Opening, step::Closing,
                 step::Gaussian, step::SmoothTogether, step::Margin, step::Hollow, step::Logical, step::FillBetween,
                 step::Connected, step::ConfidenceConnected, step::GrowSeeds, step::Watershed, step::March,
                 step::Contour, step::Vessel, step::Tube, step::Outline, step::CutOff>;

/// One labeling step: a tool with its parameters, the label that the tool writes, and limits of its effect. To erase,
/// paint with the label that the voxels are to get, or with kSurroundings as `label` and `rest`.
struct LabelStep {
  /// Value of `rest`: removed voxels get the label of their surroundings. A part of connected voxels gets the most
  /// frequent label of its neighbors through faces, as far as the CT value of each voxel agrees: background or airway
  /// below -300 HU; fat from -300 to -31 HU; muscle, soft tissue, sternocleidomastoid, thyroid, oesophagus, salivary
  /// gland or lymph node above. Without such a neighbor, fat is fat, and the rest is soft tissue.
  static constexpr std::uint8_t kSurroundings = 255;

  LabelTool tool;
  std::uint8_t label = 0;  ///< label that the tool writes; not used by tools that write several labels
  std::uint8_t rest;       ///< label of voxels that the step removes from `label`; soft tissue by default
  std::vector<std::uint8_t> locked{};
  std::optional<std::vector<std::uint8_t>> over{};  ///< if set, only voxels of these labels are overwritten
  std::optional<HuRange> editable_HU{};
  /// Opposite corners of the region in which the tool works, patient space; empty: the tool chooses the region.
  std::optional<std::array<Vec3, 2>> box_mm{};
  std::string of{};  ///< GuideStep::name of the guide's step for which this step was made; tools ignore it

  LabelStep();
};

/// Returns the name of a step's tool in a recipe: "threshold", "paint", ...
std::string_view nameOf(const LabelTool& tool);

/// Computes the labels that the step would write; the limits `locked`, `over` and `editable_HU` are not applied. Runs
/// on the caller's thread. Fails with a sentence of the tool, and when cancelled.
Result<Proposal> propose(const LabelStep& step, const CtVolume& ct, const LabelMap& labels,
                         const Progress& progress = {});

/// Computes a preview of perform(): the whole resulting shape of the label or, when erasing, only the removed part. A
/// threshold step reuses the memory of `into`, so that the preview can follow a slider. Fails with the errors of
/// propose(); the proposal's contents are then undefined.
Result<void> preview(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, Proposal& into,
                     const Progress& progress = {});

/// Returns the step's limits as EditRules, for callers that write the step's proposal themselves.
EditRules rulesOf(const LabelStep& step);

/// Computes the step's proposal and writes it as one undo step. The limits of the step replace `edit.rules`.
Result<LabelChange> perform(const LabelStep& step, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
