#pragma once

#include <insonate/segmentation/LabelStep.h>

#include <array>
#include <string_view>
#include <vector>

namespace insonate::segmentation {

// Lists the fields of each tool in a recipe, once for reading, writing and listing: io(key, value, ...). After a number
// come its minimum and maximum, after a list of points its minimum count, after an enumeration its words.

/// Maxima of distances and of HU gradients in recipes.
inline constexpr double kMaxMm = 100, kMaxHuPerMm = 2000;
using Words = std::vector<std::string_view>;

template <class Io>
void fields(Io& io, step::Auto& s) {
  io("take", s.take);
}
template <class Io>
void fields(Io& io, step::Threshold& s) {
  io("range_HU", s.range_HU);
}
template <class Io>
void fields(Io& io, step::Paint& s) {
  io("points_mm", s.points_mm, 1);
  io("radius_mm", s.radius_mm, 0.1, kMaxMm);
  io("slice_axis", s.sliceAxis, 0, 2);
  io("only_HU", s.only_HU);
}
template <class Io>
void fields(Io& io, step::Draw& s) {
  io("points_mm", s.points_mm, 3);
  io("slice_axis", s.sliceAxis, 0, 2);
}
template <class Io>
void fields(Io& io, step::Scissors& s) {
  io("points_mm", s.points_mm, 3);
  io("along", s.view.along);
  io("eye_mm", s.view.eye_mm);
  io("outside", s.view.outside);
  io("depth_mm", s.view.depth_mm, 0, 2000);
  io("surface_mm", s.view.surface_mm);
}
template <class Io>
void fields(Io& io, step::KeepLargest& s) {
  io("islands", s.islands, 1, 1000);
}
template <class Io>
void fields(Io& io, step::RemoveSmall& s) {
  io("least_mm3", s.min_mm3, 0, 1e7);
}
template <class Io>
void fields(Io& io, step::KeepIsland& s) {
  io("points_mm", s.points_mm, 1);
}
template <class Io>
void fields(Io& io, step::SplitIslands& s) {
  io("into", s.into);
}
template <class Io>
void fields(Io& io, step::Median& s) {
  io("radius_mm", s.radius_mm, 0.1, kMaxMm);
}
template <class Io>
void fields(Io& io, step::Opening& s) {
  io("radius_mm", s.radius_mm, 0.1, kMaxMm);
}
template <class Io>
void fields(Io& io, step::Closing& s) {
  io("radius_mm", s.radius_mm, 0.1, kMaxMm);
}
template <class Io>
void fields(Io& io, step::Gaussian& s) {
  io("sigma_mm", s.sigma_mm, 0.1, kMaxMm);
}
template <class Io>
void fields(Io& io, step::SmoothTogether& s) {
  io("sigma_mm", s.sigma_mm, 0.1, kMaxMm);
  io("labels", s.labels);
}
template <class Io>
void fields(Io& io, step::Margin& s) {
  io("margin_mm", s.margin_mm, -kMaxMm, kMaxMm);
}
template <class Io>
void fields(Io& io, step::Hollow& s) {
  io("thickness_mm", s.thickness_mm, 0.1, kMaxMm);
  io("wall", s.wall, Words{"inside", "middle", "outside"});
}
template <class Io>
void fields(Io& io, step::Logical& s) {
  io("operation", s.operation, Words{"add", "subtract", "intersect"});
  io("with", s.with);
  io("reach_mm", s.reach_mm, 0, kMaxMm);
}
template <class Io>
void fields(Io& io, step::FillBetween& s) {
  io("slice_axis", s.sliceAxis, 0, 2);
}
template <class Io>
void fields(Io& io, step::Connected& s) {
  io("points_mm", s.points_mm, 1);
  io("range_HU", s.range_HU);
}
template <class Io>
void fields(Io& io, step::ConfidenceConnected& s) {
  io("points_mm", s.points_mm, 1);
  io("deviations", s.confidence.deviations, 0.5, 10);
  io("rounds", s.confidence.rounds, 0, 20);
  io("seed_mm", s.confidence.seed_mm, 0.1, 20);
}
template <class Io>
void fields(Io& io, step::GrowSeeds& s) {
  io("seeds", s.seeds);
  io("into", s.over);
  io("smoothing_mm", s.competition.smoothing_mm, 0, 10);
  io("per_mm_HU", s.competition.lengthCost_HUpmm, 0, kMaxHuPerMm);
}
template <class Io>
void fields(Io& io, step::Watershed& s) {
  io("seeds", s.seeds);
  io("into", s.over);
  io("smoothing_mm", s.smoothing_mm, 0, 10);
}
template <class Io>
void fields(Io& io, step::March& s) {
  io("points_mm", s.points_mm, 1);
  io("reach_mm", s.front.reach_mm, 0.1, 1000);
  io("edge_HUpmm", s.front.edge_HUpmm, 1, kMaxHuPerMm);
  io("smoothing_mm", s.front.smoothing_mm, 0, 10);
}
template <class Io>
void fields(Io& io, step::Contour& s) {
  io("edge_HUpmm", s.levelSet.edge_HUpmm, 1, kMaxHuPerMm);
  io("smoothing_mm", s.levelSet.smoothing_mm, 0, 10);
  io("propagation", s.levelSet.propagation, -10, 10);
  io("curvature", s.levelSet.curvature, 0, 10);
  io("advection", s.levelSet.advection, 0, 10);
  io("rounds", s.levelSet.rounds, 1, 5000);
}
template <class Io>
void fields(Io& io, step::Vessel& s) {
  io("points_mm", s.points_mm, 2);
  io("largest_mm", s.tracking.largest_mm, 2, 30);
  io("smoothing_mm", s.tracking.smoothing_mm, 0, 3);
}

template <class Io>
void fields(Io& io, step::Tube& s) {
  io("points_mm", s.points_mm, 2);
  io("largest_mm", s.tracking.largest_mm, 2, 30);
  io("darker_HU", s.tracking.darker_HU, 1, 500);
  io("brighter_HU", s.tracking.brighter_HU, 1, 500);
  io("stiffness", s.tracking.stiffness, 0, 10);
}

template <class Io>
void fields(Io& io, step::Outline& s) {
  io("line_mm", s.outline.line_mm, 2);
  io("section", s.outline.section, 0, 1000);
  io("points_mm", s.outline.corners_mm, VesselOutline::kRays);
  io("reach_mm", s.outline.reach_mm, 0.1, kMaxMm);
}
template <class Io>
void fields(Io& io, step::CutOff& s) {
  io("points_mm", s.stroke.points_mm, 2);
  io("along", s.stroke.along);
}

/// Word for LabelStep::kSurroundings.
inline constexpr const char* kSurroundingsWord = "surroundings";

/// Names of the tools, in the order of LabelTool.
inline constexpr std::array<std::string_view, std::variant_size_v<LabelTool>> kToolNames{"auto",
                                                                                         "threshold",
                                                                                         "paint",
                                                                                         "draw",
                                                                                         "scissors",
                                                                                         "largest_islands",
                                                                                         "remove_small_islands",
                                                                                         "island",
                                                                                         "split_islands",
                                                                                         "median",
                                                                                         "opening",
                                                                                         "closing",
                                                                                         "gaussian",
                                                                                         "smooth_together",
                                                                                         "margin",
                                                                                         "hollow",
                                                                                         "logical",
                                                                                         "fill_between_slices",
                                                                                         "connected",
                                                                                         "confidence_connected",
                                                                                         "grow_from_seeds",
                                                                                         "watershed",
                                                                                         "fast_marching",
                                                                                         "level_set",
                                                                                         "vessel",
                                                                                         "tube",
                                                                                         "outline",
                                                                                         "cut_off"};

}  // namespace insonate::segmentation
