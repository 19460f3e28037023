#pragma once

#include "model/FramePlan.h"

#include <insonate/image/PlaneDisplacement.h>
#include <insonate/ultrasound/AcousticScene.h>
#include <insonate/ultrasound/Frames.h>

namespace insonate::thesis {

/// Renders one frame in the style of the thesis (see ThesisModel.h), in the plainest form of the code, with a single
/// compounding look.
void renderReference(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
                     const PlaneDisplacement& displacement, EnvelopeFrame& envelope);

}  // namespace insonate::thesis
