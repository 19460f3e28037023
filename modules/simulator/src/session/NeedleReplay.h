#pragma once

#include "session/MomentImaging.h"

#include <insonate/cases/CaseView.h>
#include <insonate/haptics/HapticServo.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/procedure/AttemptSample.h>
#include <insonate/simulator/VesselLocator.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace insonate {

/// Moves a needle through a case as it was recorded, and computes which walls it punctures. The tissue near the needle
/// is deformed by the recorded poses of the probe, at the mean blood pressure. One object must not be used
/// concurrently; uses the calling thread's TBB arena.
class NeedleReplay {
 public:
  /// Fails if the case has no acoustic scenes or no center lines, or if cancelled. `patient` must not change.
  static Result<NeedleReplay> make(const std::shared_ptr<const PatientCase>& patient, const Progress& progress);

  /// Begins a recording; the needle is outside the body. `target`: number of the target vein (see
  /// VesselLocator::vesselAt()).
  void restart(VesselLocator vessels, std::uint8_t target);
  Result<void> use(const AttemptSettings& settings);
  /// Moves probe and needle to the next sample. Returns the events at walls on this way.
  Result<std::vector<AttemptEvent>> move(const AttemptSample& sample);

  /// Returns distances and label at the tip, in undeformed tissue; empty if there is no needle or no tissue.
  const std::optional<TissueSample>& atTip() const { return atTip_; }
  /// Returns the distance from the tip to the center line of the target vein (see AttemptSample::toVeinCenter_mm).
  std::optional<double> toVeinCenter_mm() const { return vessels_.distanceToCenterLine_mm(tip_mm_, veins_, target_); }
  bool isInBody() const { return inBody_; }

 private:
  NeedleReplay(CaseVolumes volumes, std::shared_ptr<const SceneSource> source, std::vector<CenterLine> veins);
  void takeGrid(const Transform& patientFromNeedle);
  Result<void> deform(const AttemptSample& sample);
  ServoOutput tick(const AttemptSample& sample);

  CaseVolumes volumes_;
  std::vector<CenterLine> veins_;
  VesselLocator vessels_;
  std::uint8_t target_ = 1;
  std::unique_ptr<MomentImaging> imaging_;
  HapticServo servo_;
  std::shared_ptr<const TissueGrid> grid_;
  Vec3 gridCenter_mm_;
  Transform restFromPatient_;
  std::optional<Transform> solvedFor_;  ///< pose of the probe for which the tissue was solved last
  std::int64_t solveAt_us_ = 0, mapAt_us_ = 0;
  Vec3 tip_mm_;  ///< in undeformed tissue
  std::optional<TissueSample> atTip_;
  bool held_ = false, inBody_ = false;
};

}  // namespace insonate
