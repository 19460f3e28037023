#pragma once

#include <insonate/core/Progress.h>
#include <insonate/segmentation/FastMarching.h>
#include <insonate/segmentation/GrowFromSeeds.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/segmentation/LevelSet.h>
#include <insonate/segmentation/Logical.h>
#include <insonate/segmentation/Margin.h>
#include <insonate/segmentation/Polygon.h>
#include <insonate/segmentation/RegionGrowing.h>
#include <insonate/segmentation/TubeTracking.h>
#include <insonate/segmentation/VesselTracking.h>

#include <array>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

namespace insonate {

/// Parameters of all tools, as a window sets them and a recipe names them. Points are in the patient, mm.
namespace step {

struct Auto {  ///< labels by Hounsfield units and connectivity (AutoLabel.h), limited to the labels in `take`
  std::vector<std::uint8_t> take{};
};
struct Threshold {
  HuRange range_HU{};
};
struct Paint {
  std::vector<Vec3> points_mm{};
  double radius_mm = 4;
  std::optional<int> sliceAxis{};
  std::optional<HuRange> only_HU{};
};
struct Draw {
  std::vector<Vec3> points_mm{};
  int sliceAxis = 2;
};
struct Scissors {
  std::vector<Vec3> points_mm{};
  ScissorsView view{};
};
struct KeepLargest {
  int islands = 1;
};
struct RemoveSmall {
  double least_mm3 = 100;
};
struct KeepIsland {
  std::vector<Vec3> points_mm{};  ///< exactly one point, inside the island to keep
};
struct SplitIslands {
  std::vector<std::uint8_t> into{};  ///< labels for the islands, the largest island first
};
struct Median {
  double radius_mm = 1;
};
struct Opening {
  double radius_mm = 1;
};
struct Closing {
  double radius_mm = 1;
};
struct Gaussian {
  double sigma_mm = 1;
};
struct SmoothTogether {
  double sigma_mm = 1;
  std::vector<std::uint8_t> labels{};
};
struct Margin {
  double margin_mm = 2;  ///< distance by which the shape grows; negative to shrink
};
struct Hollow {
  double thickness_mm = 2;
  Wall wall = Wall::kInside;
};
struct Logical {
  LogicalOperation operation = LogicalOperation::kAdd;
  std::uint8_t with = 0;
  double reach_mm = 0;  ///< voxels within this distance of the label `with` count as `with`, too; must be above 0
                        ///< except for kAdd, since labels do not overlap
};
struct FillBetween {
  int sliceAxis = 2;
};
struct Connected {
  std::vector<Vec3> points_mm{};
  HuRange range_HU{};
};
struct ConfidenceConnected {
  std::vector<Vec3> points_mm{};
  Confidence confidence{};
};
struct GrowSeeds {
  std::vector<std::uint8_t> seeds{}, over{};
  SeedCompetition competition{};
};
struct Watershed {
  std::vector<std::uint8_t> seeds{}, over{};
  double smoothing_mm = 1;
};
struct March {
  std::vector<Vec3> points_mm{};
  MarchingFront front{};
};
struct Contour {
  GeodesicLevelSet levelSet{};
};
struct Vessel {
  std::vector<Vec3> points_mm{};
  VesselTracking tracking{};
};
struct Tube {
  std::vector<Vec3> points_mm{};
  TubeTracking tracking{};
};

}  // namespace step

using LabelTool = std::variant<step::Auto, step::Threshold, step::Paint, step::Draw, step::Scissors, step::KeepLargest,
                               step::RemoveSmall, step::KeepIsland, step::SplitIslands, step::Median, step::Opening,
                               step::Closing, step::Gaussian, step::SmoothTogether, step::Margin, step::Hollow,
                               step::Logical, step::FillBetween, step::Connected, step::ConfidenceConnected,
                               step::GrowSeeds, step::Watershed, step::March, step::Contour, step::Vessel, step::Tube>;

/// One step of labeling: a tool, its label, and rules for other voxels. To erase, paint with the label that the voxels
/// shall get.
struct LabelStep {
  LabelTool tool;
  std::uint8_t label = 0;  ///< label that the tool writes; not used by tools that write several labels
  std::uint8_t rest;       ///< label that voxels get if the step removes them from `label`; soft tissue by default
  std::vector<std::uint8_t> locked{};
  std::optional<std::vector<std::uint8_t>> over{};  ///< if set, only voxels of these labels are overwritten
  std::optional<HuRange> editable_HU{};
  /// Opposite corners of the region in which the tool works; if empty, the tool chooses the region.
  std::optional<std::array<Vec3, 2>> box_mm{};
  std::string of{};  ///< name of the guide's step for which this step was made; tools ignore it

  LabelStep();
};

/// Returns the name of a step's tool in a recipe: "threshold", "paint", ...
std::string_view nameOf(const LabelTool& tool);

/// Computes the labels that the step would write, without applying its rules. Runs on the caller's thread. Fails with
/// the tool's sentence and when cancelled.
Result<Proposal> propose(const LabelStep& step, const CtVolume& ct, const LabelMap& labels,
                         const Progress& progress = {});

/// Computes a preview of perform() for a window: the label's whole shape; for erasing, only the part that is removed. A
/// threshold step reuses the memory of `into`, so that the preview can follow a slider. Fails with the errors of
/// propose(); the proposal's contents are then undefined.
Result<void> preview(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, Proposal& into,
                     const Progress& progress = {});

/// Returns the step's editing rules, for callers that write the step's proposal themselves.
EditRules rulesOf(const LabelStep& step);

/// Computes the step's proposal, writes it and stores it for undo. The step's rules replace those of `edit`.
Result<LabelChange> perform(const LabelStep& step, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
