#include "press/ScenePlane.h"

#include <algorithm>

namespace insonate::press {

static_assert(PlaneTissue::kFar_mm == kPlaneReach_mm);

void ScenePlane::look(const AcousticScene& scene, const Transform& patientFromProbe) {
  scene_ = &scene;
  patientFromProbe_ = patientFromProbe;
}

void ScenePlane::sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const {
  const auto half = static_cast<float>(window_.half_mm);
  const auto top = static_cast<float>(window_.top_mm), bottom = static_cast<float>(window_.bottom_mm);
  points_.resize(at.size());
  for (std::size_t n = 0; n < at.size(); ++n)
    points_[n] = {std::clamp(at[n].x_mm, -half, half), std::clamp(at[n].z_mm, top, bottom)};
  samplePlane(*scene_, patientFromProbe_, points_, samples_);
  for (std::size_t n = 0; n < at.size(); ++n)
    tissue[n] = {samples_.label[n], samples_.toArtery_mm[n], samples_.toVein_mm[n], samples_.toBone_mm[n],
                 samples_.toSkin_mm[n]};
}

}  // namespace insonate::press
