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

/// Properties of the whole case that scenes need, computed once.
struct CaseFacts {
  static constexpr int kBlock = 8;  ///< edge length of a block of labelsNear(), voxels

  CaseFacts(const CtVolume& ct, const LabelMap& labels);

  /// Returns one bit for each label that occurs in the blocks of kBlock voxels that a box of voxels touches; unknown
  /// labels count as soft tissue.
  std::uint32_t labelsNear(const NodeBox& voxels) const;

  std::uint32_t patient = 0;          ///< hash of the CT; identifies the patient even after the labels were edited
  LabelMeans mean_HU{};               ///< mean HU of the voxels of each label; 0 if the label does not occur
  double midline_mm = 0;              ///< x of the patient's midline, across which textures are mirrored
  double trachea_mm = 0;              ///< x of the trachea, from which the lung is told by its distance
  std::array<Vec3, 2> muscleFibre;    ///< fiber direction of the sternocleidomastoid, right and left; unit, patient LPS
  std::vector<std::string> warnings;  ///< sentences about unknown labels

 private:
  std::array<int, 3> blocks_{};
  std::vector<std::uint32_t> labelsOfBlock_;
};

}  // namespace insonate
