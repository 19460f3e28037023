#pragma once

#include "model/FramePlan.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::thesis {

/// Renders one frame of the thesis look (see ThesisModel.h) in its plainest form, with a single compounding look.
void renderReference(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                     const PlaneDisplacement& displacement, EnvelopeFrame& envelope);

}  // namespace insonate::thesis
