#pragma once

#include "model/FramePlan.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <vector>

namespace insonate {

/// Part of a point target's echo on one gate of one scanline, before convolution with the point-spread function.
struct PointEcho {
  int gate, line;
  float amplitude;
};

/// Computes the echoes of point targets, which move with the tissue in which they lie.
std::vector<PointEcho> pointEchoes(const FramePlan& plan, const std::vector<PointTarget>& points,
                                   const Transform& patientFromProbe, const PlaneDisplacement& displacement);

}  // namespace insonate
