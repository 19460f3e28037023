#pragma once

#include "model/FramePlan.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>

#include <vector>

namespace insonate {

/// Share of a point target's echo that falls on one gate of one scanline, before the beam.
struct PointEcho {
  int gate, line;
  float amplitude;
};

/// Points move with the tissue that they lie in.
std::vector<PointEcho> pointEchoes(const FramePlan& plan, const std::vector<PointTarget>& points,
                                   const Transform& patientFromProbe, const PlaneDisplacement& displacement);

}  // namespace insonate
