#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselLocator.h>

#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Detects in live images that the trainee has found the target vein: the vein has been in the middle of the image for
/// a second (reported once), or the probe has compressed the vein there (reported once each time the vein comes to the
/// middle). In a case without a target each vein counts. Neither waits nor allocates. One object must not be used
/// concurrently.
class VeinWatch {
 public:
  /// Position of the target vein relative to the middle line of an image.
  struct Sight {
    bool isCentered = false;
    std::uint8_t vessel = 0;  ///< number of the vein: AttemptEvent::vessel
    double thickness_mm = 0;  ///< thickness of the deformed lumen along the middle line
    Vec3 middle_mm{};         ///< center of the lumen in undeformed tissue, patient space
  };

  /// Finds the target vein on the middle line of an image; `middleAtRest_mm`: LiveDeformation::middleAtRest_mm. The
  /// vein counts as centered if the vein's center line passes the middle of the chord within 0.35 of the chord's
  /// length, the chord being the part of the line in the lumen. For a round vein this is 0.57 of the radius.
  static Sight sightOf(std::span<const Vec3> middleAtRest_mm, const TissueGrid& grid, const VesselLocator& vessels,
                       std::span<const CenterLine> veins);

  /// Evaluates an image; returns a Centered or Compressed event when it occurs. `sight`: empty if the probe does not
  /// touch the skin or if there is no live image.
  std::optional<AttemptEvent> look(std::int64_t time_us, const std::optional<Sight>& sight, Vec3 axial);

 private:
  /// time since which the target vein has been in the middle; empty: the vein is not in the middle
  std::optional<std::int64_t> since_us_;
  double max_mm_ = 0;  ///< maximum thickness of the target vein since since_us_
  bool isCenteredTold_ = false, isCompressedTold_ = false;
};

}  // namespace insonate
