#pragma once

#include "live/SceneNeed.h"

#include <insonate/procedure/AttemptSample.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/MovingBlood.h>

#include <memory>
#include <optional>
#include <vector>

namespace insonate {

/// Computes the tissue deformation and the ultrasound image of one moment of an attempt, from the state of that moment
/// alone: the deformation is solved from the undeformed state, and no image affects the next. The same moment therefore
/// gives the same bits in any order. One object must not be used concurrently; uses the calling thread's TBB arena.
class MomentImaging {
 public:
  /// `vessels`: named vessels of the case, for color Doppler. `source`: source of acoustic scenes of a case with this
  /// label map; the case's volumes must outlive `source` and this object.
  MomentImaging(const LabelMap& labels, std::shared_ptr<const SceneSource> source,
                std::span<const NamedVessel> vessels = {});
  ~MomentImaging();

  /// Sets the settings that apply from now on. Fails if no image can be made with them.
  Result<void> use(const AttemptSettings& settings);

  /// Computes the deformation by the probe at this pose and the blood pressure at `time_s`, unless the last deformation
  /// was computed for the same.
  Result<void> press(const Transform& patientFromProbe, double time_s);
  /// Returns the deformation that press() computed; without force and displacement if the tissue is not compressed.
  const Deformation& deformation() const;
  /// Returns an affine map to the undeformed position of tissue, valid near a point (see
  /// LiveDeformation::restFromPatient).
  Transform restNear(Vec3 patient_mm) const;
  /// Returns LiveDeformation::middleAtRest_mm of the deformation that press() computed; empty if none was computed.
  const std::vector<Vec3>& middleAtRest_mm() const { return middleAtRest_mm_; }

  /// Returns the region that the acoustic scenes for a pose must cover, for computing them in advance. Call it after
  /// use().
  live::SceneNeed need() const { return *need_; }

  /// Renders the image for a sample with a held probe. LiveFrame::number is 0, LiveFrame::time_s is the time in the
  /// recording. `before`: a slightly earlier sample, from which color Doppler computes the motion of the probe; null:
  /// the probe does not move.
  Result<std::shared_ptr<const LiveFrame>> picture(const AttemptSample& sample, const AttemptSample* before = nullptr);
  /// Tells whether the settings have color Doppler.
  bool hasColor() const { return setup_ && setup_->color.has_value(); }

 private:
  struct Scene {
    Region region_mm;
    std::shared_ptr<const AcousticScene> scene;
  };
  bool useRods(const AttemptSettings& settings);
  Result<void> takeScene(const Transform& patientFromProbe);
  const AcousticScene& scene() const { return *scenes_.front().scene; }
  void describePress(LiveFrame& frame) const;
  ColorMotion motionOf(const AttemptSample& sample, const AttemptSample* before, const PlaneDisplacement& displacement);

  const VolumeGeometry grid_;
  const std::shared_ptr<const SceneSource> source_;
  std::optional<AttemptSettings> settings_;
  SharedRods rods_;  ///< instruments of settings_; null: none
  std::shared_ptr<const ImagingSetup> setup_;
  std::optional<live::SceneNeed> need_;
  std::optional<Imager> imager_;
  std::vector<Scene> scenes_;  ///< the scenes used last, the latest first
  int scenesMade_ = 0;
  std::optional<CompressedTissue> tissue_;  ///< deformation for pose_ and blood_; empty: tissue is not deformed
  std::optional<Transform> pose_;
  std::vector<Vec3> middleAtRest_mm_;
  BloodPressure blood_;
  TentedTissue tented_;
  MovingBlood flow_;
};

}  // namespace insonate
