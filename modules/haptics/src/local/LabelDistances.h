#pragma once

#include <insonate/image/Volume.h>

#include <functional>
#include <vector>

namespace insonate::haptics {

/// Signed distance in mm of each voxel's center to the surface of the voxels that `inside` accepts: negative inside,
/// rounded over about a voxel. 300 everywhere where there are none, -300 where there are no others.
std::vector<float> signedDistances(const LabelMap& labels, const std::function<bool(std::uint8_t)>& inside);

}  // namespace insonate::haptics
