#include "press/ScenePlane.h"

#include <algorithm>

namespace insonate::press {

static_assert(PlaneTissue::kFar_mm == kPlaneReach_mm);

void ScenePlane::look(const AcousticScene& scene, const Transform& patientFromProbe) {
  scene_ = &scene;
  patientFromProbe_ = patientFromProbe;
}

void ScenePlane::sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const {
  sampleBeside(at, {}, tissue);
}

void ScenePlane::sampleCurvature(std::span<const PlanePoint> at, float PlaneTissue::*outline,
                                 std::span<OutlineCurvature> bends) const {
  // Wide enough that the roughness of the outline (some hundredths of a millimeter) has no effect.
  constexpr double kAside_mm = 2;
  here_.resize(at.size()), beside_.resize(at.size());
  sampleBeside(at, {}, here_);
  std::fill(bends.begin(), bends.end(), OutlineCurvature{});
  const auto add = [&](Vec3 aside_mm, float OutlineCurvature::*part) {
    sampleBeside(at, aside_mm, beside_);
    for (std::size_t n = 0; n < at.size(); ++n)
      bends[n].*part += (beside_[n].*outline - here_[n].*outline) / float(kAside_mm * kAside_mm);
  };
  for (const double aside_mm : {-kAside_mm, kAside_mm}) {
    add({aside_mm, 0, 0}, &OutlineCurvature::inPlane_permm);
    add({0, 0, aside_mm}, &OutlineCurvature::inPlane_permm);
    add({0, aside_mm, 0}, &OutlineCurvature::outOfPlane_permm);
  }
}

void ScenePlane::sampleBeside(std::span<const PlanePoint> at, Vec3 aside_mm, std::span<PlaneTissue> tissue) const {
  Transform patientFromBeside = patientFromProbe_;
  patientFromBeside.offset = patientFromProbe_ * aside_mm;
  const auto half = static_cast<float>(window_.half_mm);
  const auto top = static_cast<float>(window_.top_mm), bottom = static_cast<float>(window_.bottom_mm);
  points_.resize(at.size());
  for (std::size_t n = 0; n < at.size(); ++n)
    points_[n] = {std::clamp(at[n].x_mm, -half, half), std::clamp(at[n].z_mm, top, bottom)};
  samplePlane(*scene_, patientFromBeside, points_, samples_);
  for (std::size_t n = 0; n < at.size(); ++n)
    tissue[n] = {samples_.label[n], samples_.toArtery_mm[n], samples_.toVein_mm[n], samples_.toBone_mm[n],
                 samples_.toSkin_mm[n]};
}

}  // namespace insonate::press
