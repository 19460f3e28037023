#pragma once

#include "BloodLevel.h"
#include "Work.h"

#include <vector>

namespace insonate::segmentation {

/// The way from one point in blood to another that stays in blood as long as it can, patient mm, from voxel to voxel.
std::vector<Vec3> pathThroughBlood(const CtVolume& ct, Vec3 from_mm, Vec3 to_mm, const BloodLevel& level, Work& work);

}  // namespace insonate::segmentation
