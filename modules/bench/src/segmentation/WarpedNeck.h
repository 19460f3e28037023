#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <string>
#include <vector>

namespace insonate::bench {

/// Differences of a neck from a built-in neck, and the voxels of its CT.
struct NeckWarp {
  std::uint32_t seed = 1;  ///< seed of the built-in neck and of the bend
  double scale = 1;
  Vec3 turn_deg{};          ///< rotation about the patient's axes x, y and z
  bool isMirrored = false;  ///< right and left are exchanged
  double bend_mm = 0;       ///< greatest smooth displacement along each axis
  Vec3 spacing_mm{0.6, 0.6, 1};
};

/// A built-in neck after a warp: labels, and named vessels in the patient space of the labels.
struct WarpedNeck {
  LabelMap labels;
  std::vector<NamedVessel> vessels;
};

/// Warps a built-in neck. The grid shows the same part of the patient as the CT of a built-in neck.
Result<WarpedNeck> warpedNeck(const std::string& variant, const NeckWarp& warp, const Progress& progress);

}  // namespace insonate::bench
