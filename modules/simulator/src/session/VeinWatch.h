#pragma once

#include <insonate/core/Transform.h>
#include <insonate/haptics/TissueGrid.h>
#include <insonate/image/PlaneDisplacement.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselLocator.h>

#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Tells whether the probe has moved only along its axis since `before`, by at least `minimum_mm` into the body: it was
/// neither slid over the skin nor tilted or rotated.
bool isPressedFrom(const Transform& before, const Transform& now, double minimum_mm);

/// Detects in live images that the trainee has found a vein: the vein has been in the middle of the image for a second
/// (reported once), or the probe has compressed the vein there (reported once each time the vein comes to the middle,
/// and again 10 mm farther along the vein). The tissue may move the vein out of the middle while the probe compresses
/// it. In a case without a target each vein counts as the target. Neither waits nor allocates. One object must not be
/// used concurrently.
class VeinWatch {
 public:
  /// Position of the vein relative to the middle line of an image.
  struct Sight {
    bool isCentered = false;
    std::uint8_t vessel = 0;  ///< number of the vein: AttemptEvent::vessel
    double thickness_mm = 0;  ///< thickness of the deformed lumen along the middle line
    double area_mm2 = 0;      ///< area of the deformed lumen in the image, within 24 mm of the middle line
    Vec3 middle_mm{};         ///< center of the lumen in undeformed tissue, patient space
    double depth_mm = 0;      ///< depth of the center below the face of the probe
  };

  /// Deformed tissue in the plane of an image.
  struct Plane {
    const Transform& patientFromProbe;
    const PlaneDisplacement& displacement;
    std::span<const Vec3> middleAtRest_mm;  ///< LiveDeformation::middleAtRest_mm
  };

  /// Finds a vein (`vessel`: AttemptEvent::vessel; 1 is the target) on the middle line of an image. The vein counts as
  /// centered if the vein's center line passes the middle of the chord within 0.35 of the chord's length, the chord
  /// being the part of the line in the lumen. For a round vein this is 0.57 of the radius.
  static Sight sightOf(const Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
                       std::span<const CenterLine> veins, std::uint8_t vessel = 1);

  /// Evaluates an image; returns a Centered or Compressed event when it occurs. `sight`: empty if the probe does not
  /// touch the skin or if there is no live image; `patientFromProbe` is then ignored.
  std::optional<AttemptEvent> look(std::int64_t time_us, const std::optional<Sight>& sight,
                                   const Transform& patientFromProbe);
  /// Returns the number of the vein that is in the middle, or was there and is now being compressed; 0: none.
  std::uint8_t vessel() const { return open_ ? open_->sight.vessel : std::uint8_t{0}; }

 private:
  /// The vein in the middle with the largest area since the probe came there.
  struct Open {
    Sight sight;
    Transform patientFromProbe;
  };
  void follow(std::int64_t time_us, const Sight& sight, const Transform& patientFromProbe);
  bool isCompressed(const Sight& sight, const Transform& patientFromProbe) const;

  /// time since which the vein has been in the middle; empty: the vein is not in the middle
  std::optional<std::int64_t> since_us_;
  /// empty: the vein has not been in the middle, or the probe was moved in another direction than along its axis
  std::optional<Open> open_;
  Vec3 maxAt_mm_;      ///< place of max_mm_
  double max_mm_ = 0;  ///< maximum thickness of the vein at this place since it came to the middle
  Vec3 toldAt_mm_;     ///< place of the last Compressed event
  bool isCenteredTold_ = false, isCompressedTold_ = false;
};

}  // namespace insonate
