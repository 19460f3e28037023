#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/segmentation/VesselTracking.h>

namespace insonate::bench {

/// A vessel of the truth: its center line, its voxels, and those voxels of its label that belong to other vessels or
/// thin branches.
struct TrueVessel {
  CentreLine line;
  Selection voxels, others;
};

/// Returns the `most` largest vessels of a label whose center lines have at least the given length, the largest first.
/// Each voxel belongs to the nearest line, if the path between them stays in the label.
Result<std::vector<TrueVessel>> trueVessels(const LabelMap& labels, std::uint8_t label, std::size_t most,
                                            double shortest_mm, const Progress& progress);

/// Tracks the vessel from clicks on its center line and scores the lumen between the first and the last click; a vessel
/// that cannot be tracked scores 0. Covered voxels of other vessels, where the vessels meet, count neither as right nor
/// as wrong. `row` names the vessel and receives the scores.
Result<SegmentationScoreRow> scoreClicks(const CtVolume& ct, const TrueVessel& truth, int clicks,
                                         const VesselTracking& how, SegmentationScoreRow row, const Progress& progress);

/// Returns `shape` without the voxels that `others` cover.
Selection without(Selection shape, const Selection& others);

/// The part of a shape between the planes perpendicular to the vessel at its ends.
Selection betweenEnds(const Selection& shape, const CentreLine& line);

}  // namespace insonate::bench
