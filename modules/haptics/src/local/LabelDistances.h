#pragma once

#include <insonate/image/Volume.h>

#include <functional>
#include <vector>

namespace insonate::haptics {

/// Computes for each voxel the signed distance in mm from its center to the surface of the voxels whose labels `inside`
/// accepts: negative inside, smoothed over about one voxel. 300 everywhere if no voxel is accepted, -300 everywhere if
/// all are.
std::vector<float> signedDistances(const LabelMap& labels, const std::function<bool(std::uint8_t)>& inside);

}  // namespace insonate::haptics
