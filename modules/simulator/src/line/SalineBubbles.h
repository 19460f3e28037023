#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/flow/BloodFlowModel.h>
#include <insonate/image/Volume.h>
#include <insonate/simulator/SalineFlush.h>
#include <insonate/ultrasound/Instruments.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace insonate {

/// The bubbles of agitated saline. They are released at the tip of the instrument within kInjection_s, move with the
/// blood of the named vessels and on into the vessels that these join, and have dissolved after kLife_s. In a vessel
/// without a name they stay at the tip. The bubbles at a time do not depend on the times that were asked for before.
/// One object must not be used concurrently.
class SalineBubbles {
 public:
  static constexpr double kInjection_s = 2.5, kLife_s = 5;

  /// `labels`: the case's label map, in which bubbles beyond the lumen of the vessel are left out; null: the lumens are
  /// round. The labels must outlive this object.
  explicit SalineBubbles(std::span<const NamedVessel> vessels, const LabelMap* labels = nullptr);

  /// Returns the bubbles `age_s` after a flush, undeformed tissue, patient space; empty before the flush and after
  /// kLife_s. `bloodTime_s`: time in the cycles of heartbeat and breathing at the flush; empty: mean flow. The result
  /// stays valid until the next call.
  std::span<const Bubble> at(const SalineFlush& flush, double age_s, const Physiology& physiology,
                             std::optional<double> bloodTime_s);

 private:
  /// A bubble on its way: `along` counts points of the center line of a tube.
  struct Drop {
    double release_s = 0, amplitude = 0;
    double fromCenter = 0, around = 0;  ///< distance from the center line relative to the radius, and angle about it
    int tube = -1;                      ///< -1: in no named vessel
    double along = 0;
    Vec3 beside_mm{};  ///< distance from the tip, without a named vessel
    bool isGone = false;
  };
  struct Case {
    SalineFlush flush;
    Physiology physiology;
    std::optional<double> bloodTime_s;
    bool operator==(const Case&) const = default;
  };
  void release();
  void advance(double from_s, double to_s);
  void move(Drop& drop, double by_mm) const;
  void goOn(Drop& drop) const;
  double speed_mmps(const Drop& drop) const;
  Vec3 positionOf(const Drop& drop) const;
  void show(double age_s);

  BloodFlowModel model_;
  const LabelMap* labels_;
  Transform indexFromPatient_;
  BloodFlow flow_;
  std::optional<Case> case_;
  int steps_ = 0;            ///< steps of kStep_s that drops_ have gone
  std::vector<Drop> drops_;  ///< after the last whole step
  std::vector<Drop> shown_;  ///< at the time that was asked for
  std::vector<Bubble> bubbles_;
};

}  // namespace insonate
