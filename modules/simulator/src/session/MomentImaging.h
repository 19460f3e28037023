#pragma once

#include "live/SceneNeed.h"

#include <insonate/procedure/AttemptSample.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>

#include <memory>
#include <optional>

namespace insonate {

/// Tissue and picture of one moment of an attempt, from settings and the state of that moment alone: the tissue is
/// solved from rest, no picture goes into the next. So the same moment gives the same, bit for bit, whatever was asked
/// before. Not for concurrent use; uses the calling thread's TBB arena.
class MomentImaging {
 public:
  /// The case must outlive it.
  explicit MomentImaging(const PatientCase& patient);
  ~MomentImaging();

  /// What holds from now on. Fails where no picture can be made of it.
  Result<void> use(const AttemptSettings& settings);

  /// Solves the tissue under the probe at this pose; nothing where it was solved last.
  Result<void> press(const Transform& patientFromProbe, double time_s);
  /// Of press(). No force and nothing displaced where nothing is pressed.
  const Deformation& deformation() const;
  /// restFromPatient of a point, as LivePress has it near the needle's tip.
  Transform restNear(Vec3 patient_mm) const;

  /// Of a probe that is held; `number` is left 0, and `time_s` is the recording's.
  Result<std::shared_ptr<const LiveFrame>> picture(const AttemptSample& sample);

 private:
  Result<void> takeScene(const Transform& patientFromProbe);
  void tellPress(LiveFrame& frame) const;

  const PatientCase& patient_;
  std::shared_ptr<const SceneSource> source_;
  std::optional<AttemptSettings> settings_;
  std::shared_ptr<const ImagingSetup> setup_;
  std::optional<live::SceneNeed> need_;
  std::optional<Imager> imager_;
  std::shared_ptr<const AcousticScene> scene_;
  Region sceneRegion_mm_;
  std::optional<PressedTissue> tissue_;  ///< of pose_ and blood_; none: nothing is pressed
  std::optional<Transform> pose_;
  BloodPressure blood_;
  TentedTissue tented_;
};

}  // namespace insonate
