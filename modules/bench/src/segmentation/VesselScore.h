#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/VesselTracking.h>

namespace insonate::bench {

/// A vessel in the reference labels: its center line, its voxels, and the voxels of the same label that belong to other
/// vessels or thin branches.
struct TrueVessel {
  CenterLine line;
  Selection voxels, others;
};

/// Returns the `most` largest vessels of a label with center lines of at least `shortest_mm`, the largest first. A
/// voxel belongs to the nearest center line, if the path to the line stays in the label.
Result<std::vector<TrueVessel>> trueVessels(const LabelMap& labels, std::uint8_t label, std::size_t most,
                                            double shortest_mm, const Progress& progress);

/// Tracks a vessel from clicks on its center line and scores the lumen between the first and the last click; a vessel
/// that cannot be tracked scores 0. Voxels of other vessels do not count. `row` names the vessel and is returned with
/// the scores.
Result<SegmentationScoreRow> scoreClicks(const CtVolume& ct, const TrueVessel& truth, int clicks,
                                         const VesselTracking& how, SegmentationScoreRow row, const Progress& progress);

/// Returns `shape` without the voxels that `others` cover.
Selection without(Selection shape, const Selection& others);

/// Returns the part of `shape` between the planes perpendicular to the center line at its two ends.
Selection betweenEnds(const Selection& shape, const CenterLine& line);

}  // namespace insonate::bench
