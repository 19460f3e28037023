#pragma once

#include <insonate/bench/SegmentationBench.h>
#include <insonate/segmentation/CentreLine.h>
#include <insonate/segmentation/VesselTracking.h>

namespace insonate::bench {

/// A vessel of the truth: its middle, its voxels, and the voxels of its label that are others' or thin branches'.
struct TrueVessel {
  CentreLine line;
  Selection voxels, others;
};

/// The `most` largest vessels of a label whose lines are not shorter than this, the largest first. Voxels go to the
/// line that is nearest, if nothing but the label lies between.
Result<std::vector<TrueVessel>> trueVessels(const LabelMap& labels, std::uint8_t label, std::size_t most,
                                            double shortest_mm, const Progress& progress);

/// Tracks the vessel from clicks on its middle and scores the lumen between the first and the last; a vessel that
/// cannot be tracked scores 0. Voxels that it covers of other vessels where they meet count neither way. `row` names
/// the vessel and receives the scores.
Result<SegmentationScoreRow> scoreClicks(const CtVolume& ct, const TrueVessel& truth, int clicks,
                                         const VesselTracking& how, SegmentationScoreRow row, const Progress& progress);

/// `shape` without what `others` cover of it.
Selection without(Selection shape, const Selection& others);

/// The part of a shape between the planes perpendicular to the vessel at its ends.
Selection betweenEnds(const Selection& shape, const CentreLine& line);

}  // namespace insonate::bench
