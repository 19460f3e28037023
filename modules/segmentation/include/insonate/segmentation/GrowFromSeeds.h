#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelEdit.h>

namespace insonate {

/// Labels that were painted as seeds: their voxels in a box are fixed, all others are contested.
struct Seeds {
  Proposal painted;     ///< kKeep where no seed is
  Selection contested;  ///< of the same box: voxels that seeds may take
};

/// Seeds of all labels in `which`; they contest the voxels of labels in `over`.
Seeds seedsOf(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, const LabelSet& over);

struct Competition {
  double smoothing_mm = 0.7;  ///< standard deviation of the blur of the CT before
  double perMm_HU = 3;        ///< what a millimeter of way costs, beside the change of the CT along it
};

/// Each contested voxel goes to the seed from which the way is cheapest, a step costing the change of the CT along it:
/// the cellular automaton of V. Vezhnevets, V. Konouchine, "GrowCut", Graphicon 2005, solved as shortest paths (L. Zhu
/// et al., "An effective interactive medical image segmentation method using fast GrowCut", MICCAI IMIC 2014). What no
/// seed can reach stays. Refuses seeds of fewer than two labels; fails when cancelled.
Result<Proposal> grownFromSeeds(const CtVolume& ct, const Seeds& seeds, const Competition& competition,
                                const Progress& progress = {});

/// Each contested voxel goes to the seed whose water reaches it first when the CT's gradient is flooded from the seeds
/// (marker-controlled watershed: F. Meyer, "Topographic distance and watershed lines", Signal Processing 38, 1994).
/// `smoothing_mm` is the standard deviation of the blur before. Refuses and fails as grownFromSeeds().
Result<Proposal> watershed(const CtVolume& ct, const Seeds& seeds, double smoothing_mm, const Progress& progress = {});

}  // namespace insonate
