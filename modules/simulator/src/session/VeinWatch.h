#pragma once

#include <insonate/haptics/TissueGrid.h>
#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselNames.h>

#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Detects that the trainee has found the target vein: it lies in the middle of the live image for a second (reported
/// once), and the probe compresses it there (reported once each time it comes to the middle). In a case without a
/// target each vein counts. Neither waits nor allocates. Not for concurrent use of one object.
class VeinWatch {
 public:
  /// Position of the target relative to the middle line of an image.
  struct Sight {
    bool isCentered = false;
    std::uint8_t vessel = 0;  ///< AttemptEvent::vessel
    double thickness_mm = 0;  ///< of its lumen along the line, now
    Vec3 middle_mm{};         ///< of its lumen, at rest; patient space
  };

  /// `middleAtRest_mm` as in LivePress. The line is centered where it passes the center line of the vein within 0.35 of
  /// the lumen's length along it, which is 0.57 of the radius of a round vein.
  static Sight sightOf(std::span<const Vec3> middleAtRest_mm, const TissueGrid& grid, const VesselNames& vessels,
                       std::span<const CentreLine> veins);

  /// A probe that touches the skin sees this; none: it does not touch, or there is no live image.
  std::optional<AttemptEvent> look(std::int64_t time_us, const std::optional<Sight>& sight, Vec3 axial);

 private:
  std::optional<std::int64_t> since_us_;  ///< the target is in the middle
  double most_mm_ = 0;                    ///< its thickness since then
  bool isCenteredTold_ = false, isCompressedTold_ = false;
};

}  // namespace insonate
