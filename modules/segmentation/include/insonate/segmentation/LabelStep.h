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

/// Tools with their parameters: what a window sets and a recipe names. Points are in the patient, mm.
namespace step {

struct Auto {  ///< what Hounsfield units and connectivity tell (AutoLabel.h), of these labels only
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
  std::vector<Vec3> points_mm{};  ///< one
};
struct SplitIslands {
  std::vector<std::uint8_t> into{};  ///< largest first
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
  double margin_mm = 2;  ///< negative makes smaller
};
struct Hollow {
  double thickness_mm = 2;
  Wall wall = Wall::kInside;
};
struct Logical {
  LogicalOperation operation = LogicalOperation::kAdd;
  std::uint8_t with = 0;
  double reach_mm = 0;  ///< what lies so near the other label counts as that label; above 0 but for kAdd, since no
                        ///< voxel has two labels
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
  Competition competition{};
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

/// One step of labeling: a tool, its label, and rules for other voxels. Erasing is painting with the label that should
/// be there instead.
struct LabelStep {
  LabelTool tool;
  std::uint8_t label = 0;  ///< not used by tools that write several labels
  std::uint8_t rest;       ///< what voxels become that the label loses; soft tissue by default
  std::vector<std::uint8_t> locked{};
  std::optional<std::vector<std::uint8_t>> over{};  ///< where given, only voxels of these labels are overwritten
  std::optional<HuRange> editable_HU{};
  std::optional<std::array<Vec3, 2>> box_mm{};  ///< two corners of the region, else what the tool needs
  std::string of{};                             ///< the step of a guide that it was made for; tools do not ask

  LabelStep();
};

/// "threshold", "paint", ...: the name of a step's tool in a recipe.
std::string_view nameOf(const LabelTool& tool);

/// Computes the labels that the step would write, without regard to its rules. Runs on the caller's thread. Fails with
/// the tool's sentence and when cancelled.
Result<Proposal> propose(const LabelStep& step, const CtVolume& ct, const LabelMap& labels,
                         const Progress& progress = {});

/// Computes a preview of perform() for a window. It shows the label's whole shape; for erasing, only the part that is
/// removed. A threshold reuses the proposal's memory, so that it can follow a slider. If it fails, as propose() does,
/// the proposal's contents are undefined.
Result<void> preview(const LabelStep& step, const CtVolume& ct, const LabelMap& labels, Proposal& into,
                     const Progress& progress = {});

/// Rules of the step, for code that writes its proposal.
EditRules rulesOf(const LabelStep& step);

/// Proposes, writes and stores the step. The step's own rules apply instead of the edit's.
Result<LabelChange> perform(const LabelStep& step, LabelEdit& edit, const Progress& progress = {});

}  // namespace insonate
