#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselNames.h>

#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Detects that the trainee has found the target vein: the vein lies in the middle of the live image for a second
/// (reported once), or the probe compresses the vein there (reported once each time it comes to the middle). In a case
/// without a target each vein counts. Neither waits nor allocates. Not for concurrent use of one object.
class VeinWatch {
 public:
  /// Position of the target relative to the middle line of an image.
  struct Sight {
    bool isCentered = false;
    std::uint8_t vessel = 0;  ///< AttemptEvent::vessel
    double thickness_mm = 0;  ///< present thickness of the lumen along the middle line
    Vec3 middle_mm{};         ///< center of the lumen, at rest; patient space
  };

  /// Finds the target on the middle line of an image; `middleAtRest_mm` as in LivePress. The line counts as centered if
  /// the vein's center line passes the middle of the chord within 0.35 of the chord's length, the chord being the part
  /// of the line in the lumen. For a round vein this is 0.57 of the radius.
  static Sight sightOf(std::span<const Vec3> middleAtRest_mm, const TissueGrid& grid, const VesselNames& vessels,
                       std::span<const CentreLine> veins);

  /// Evaluates an image; returns an event if one is due. `sight`: empty if the probe does not touch the skin or if
  /// there is no live image.
  std::optional<AttemptEvent> look(std::int64_t time_us, const std::optional<Sight>& sight, Vec3 axial);

 private:
  std::optional<std::int64_t> since_us_;  ///< time since which the target has been in the middle; empty: it is not
  double max_mm_ = 0;                     ///< maximum thickness of the target since then
  bool isCenteredTold_ = false, isCompressedTold_ = false;
};

}  // namespace insonate
