#pragma once

#include "live/SceneNeed.h"

#include <insonate/procedure/AttemptSample.h>
#include <insonate/simulator/AttemptSettings.h>
#include <insonate/simulator/LiveImaging.h>

#include <memory>
#include <optional>
#include <vector>

namespace insonate {

/// Computes tissue and image of one moment of an attempt, from settings and the state of that moment alone: the tissue
/// is solved from rest, and no image affects the next. Therefore the same moment gives the same bits in any order. Not
/// for concurrent use; uses the calling thread's TBB arena.
class MomentImaging {
 public:
  /// `source` is that of a case with this grid; the case's volumes must outlive both.
  MomentImaging(const VolumeGeometry& grid, std::shared_ptr<const SceneSource> source);
  ~MomentImaging();

  /// Sets the settings that apply from now on. Fails if no image can be made with them.
  Result<void> use(const AttemptSettings& settings);

  /// Solves the tissue under the probe at this pose, unless the last solution was for the same pose and blood pressure.
  Result<void> press(const Transform& patientFromProbe, double time_s);
  /// Result of press(): no force and no displacement if the tissue is not compressed.
  const Deformation& deformation() const;
  /// Map near a point, as LivePress::restFromPatient near the needle's tip.
  Transform restNear(Vec3 patient_mm) const;
  /// Result of press(), as in LivePress; empty if no tissue was solved.
  const std::vector<Vec3>& middleAtRest_mm() const { return middleAtRest_mm_; }

  /// Region that the scenes of a pose need, for computing them ahead. Call it after use().
  live::SceneNeed need() const { return *need_; }

  /// Renders the image of a held probe; `number` is left 0, and `time_s` is the recording's.
  Result<std::shared_ptr<const LiveFrame>> picture(const AttemptSample& sample);

 private:
  struct Scene {
    Region region_mm;
    std::shared_ptr<const AcousticScene> scene;
  };
  Result<void> takeScene(const Transform& patientFromProbe);
  const AcousticScene& scene() const { return *scenes_.front().scene; }
  void describePress(LiveFrame& frame) const;

  const VolumeGeometry grid_;
  const std::shared_ptr<const SceneSource> source_;
  std::optional<AttemptSettings> settings_;
  std::shared_ptr<const ImagingSetup> setup_;
  std::optional<live::SceneNeed> need_;
  std::optional<Imager> imager_;
  std::vector<Scene> scenes_;  ///< the last scenes, the latest first
  int scenesMade_ = 0;
  std::optional<PressedTissue> tissue_;  ///< solved for pose_ and blood_; empty: no tissue is solved
  std::optional<Transform> pose_;
  std::vector<Vec3> middleAtRest_mm_;
  BloodPressure blood_;
  TentedTissue tented_;
};

}  // namespace insonate
