#pragma once

#include <insonate/image/Volume.h>

#include <functional>
#include <vector>

namespace insonate::haptics {

/// Signed distance in mm from each voxel's center to the surface of the voxels that `inside` accepts: negative inside,
/// smoothed over about one voxel. 300 everywhere if it accepts no voxel, -300 everywhere if it accepts all.
std::vector<float> signedDistances(const LabelMap& labels, const std::function<bool(std::uint8_t)>& inside);

}  // namespace insonate::haptics
