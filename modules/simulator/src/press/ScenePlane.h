#pragma once

#include <insonate/deformation/TissuePlane.h>
#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <vector>

namespace insonate::press {

/// Tissue in the image plane of a probe pose, sampled from an acoustic scene; input of the deformation models. Outside
/// the window, the tissue at the window's edge is continued, so that results do not depend on the extent of the scene.
class ScenePlane final : public TissuePlane {
 public:
  explicit ScenePlane(const DeformationWindow& window) : window_(window) {}

  /// Sets scene and probe pose. The scene must cover the window and outlive all calls of sample() and
  /// sampleCurvature().
  void look(const AcousticScene& scene, const Transform& patientFromProbe);

  void sample(std::span<const PlanePoint> at, std::span<PlaneTissue> tissue) const override;
  void sampleCurvature(std::span<const PlanePoint> at, float PlaneTissue::*outline,
                       std::span<OutlineCurvature> bends) const override;

 private:
  void sampleBeside(std::span<const PlanePoint> at, Vec3 aside_mm, std::span<PlaneTissue> tissue) const;

  DeformationWindow window_;
  const AcousticScene* scene_ = nullptr;
  Transform patientFromProbe_;
  mutable std::vector<PlanePoint> points_;
  mutable PlaneSamples samples_;
  mutable std::vector<PlaneTissue> here_, beside_;
};

}  // namespace insonate::press
