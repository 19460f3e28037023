#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/segmentation/LabelEdit.h>

namespace insonate {

/// Input of grownFromSeeds() and watershed(): voxels that the author has painted as seeds in a box, and the contested
/// voxels, which these tools assign to the seeds. Seeds keep their labels.
struct Seeds {
  Proposal painted;     ///< labels of the seeds' voxels; Proposal::kKeep at voxels without a seed
  Selection contested;  ///< voxels of the same box that the tool assigns to seeds
};

/// Returns the input of these tools for the voxels of a box: voxels with labels in `which` are seeds, voxels with
/// labels in `over` are contested.
Seeds seedsOf(const LabelMap& labels, const VoxelBox& box, const LabelSet& which, const LabelSet& over);

struct SeedCompetition {
  double smoothing_mm = 0.7;    ///< standard deviation of the Gaussian blur that is applied to the CT first
  double lengthCost_HUpmm = 3;  ///< cost of the length of a path, in addition to the change of the CT along the path
};

/// Assigns each contested voxel to the seed from which the path to the voxel has the lowest cost. The cost of each step
/// of a path is the change of the CT along the step plus lengthCost_HUpmm times its length. This is the cellular
/// automaton of V. Vezhnevets, V. Konouchine, "GrowCut", Graphicon 2005, solved as shortest paths (L. Zhu et al., "An
/// effective interactive medical image segmentation method using fast GrowCut", MICCAI IMIC 2014). Voxels that no seed
/// reaches are not changed. Refuses seeds of fewer than two labels; fails when cancelled.
Result<Proposal> grownFromSeeds(const CtVolume& ct, const Seeds& seeds, const SeedCompetition& competition,
                                const Progress& progress = {});

/// Marker-controlled watershed: floods the CT's gradient from the seeds and assigns each contested voxel to the seed
/// that reaches it first (F. Meyer, "Topographic distance and watershed lines", Signal Processing 38, 1994).
/// `smoothing_mm` is the standard deviation of the Gaussian blur that is applied to the CT first. Refuses seeds of
/// fewer than two labels; fails when cancelled.
Result<Proposal> watershed(const CtVolume& ct, const Seeds& seeds, double smoothing_mm, const Progress& progress = {});

}  // namespace insonate
