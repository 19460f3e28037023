#pragma once

#include "scene/NodeLattice.h"

#include <insonate/image/Volume.h>
#include <insonate/tissue/Labels.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace insonate {

using LabelMeans = std::array<double, kLabelCount>;

/// Facts about the whole case that scenes need, found once.
struct CaseFacts {
  static constexpr int kBlock = 8;  ///< edge of a block, voxels

  CaseFacts(const CtVolume& ct, const LabelMap& labels);

  /// One bit for each label in the blocks that a box of voxels touches; unknown labels count as soft tissue.
  std::uint32_t labelsNear(const NodeBox& voxels) const;

  std::uint32_t patient = 0;          ///< hash of the CT; identifies the patient independent of edits of the labels
  LabelMeans mean_HU{};               ///< mean of each label; 0 if the label does not occur
  double midline_mm = 0;              ///< x in the patient frame; textures are mirrored across it
  std::array<Vec3, 2> muscleFibre;    ///< fiber direction of the sternocleidomastoid, right and left; unit, patient LPS
  std::vector<std::string> warnings;  ///< about unknown labels

 private:
  std::array<int, 3> blocks_{};
  std::vector<std::uint32_t> labelsOfBlock_;
};

}  // namespace insonate
