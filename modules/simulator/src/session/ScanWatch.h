#pragma once

#include "session/VeinWatch.h"

#include <insonate/ultrasound/ColorSettings.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace insonate {

/// Detects what a trainee finds with the probe in live images: the target vein in the middle of the image (Centered) or
/// compressed there (Compressed), other named veins compressed (Compressed), and color Doppler over the target vein
/// (ColorShown). Neither waits nor allocates. One object must not be used concurrently.
class ScanWatch {
 public:
  /// Finds the veins on the middle line of an image.
  void see(const VeinWatch::Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
           std::span<const CenterLine> veins);
  /// Returns the target vein in the last image of see(); empty before the first.
  const std::optional<VeinWatch::Sight>& target() const { return target_; }

  /// Evaluates the last image of see(); returns the events that have occurred. The returned span is valid until the
  /// next call. `isLive`, false: the probe does not touch the skin, or there is no live image. `color`: settings of
  /// color Doppler, null if it is off; `width_mm`: width of the image at the face.
  std::span<const AttemptEvent> look(std::int64_t time_us, bool isLive, const Transform& patientFromProbe,
                                     const ColorSettings* color, double width_mm);

 private:
  bool isInColor(const ColorSettings& color, double width_mm) const;
  std::optional<AttemptEvent> lookAtColor(std::int64_t time_us, const Transform& patientFromProbe, bool isCovered);

  std::optional<VeinWatch::Sight> target_, other_;
  VeinWatch targetWatch_, otherWatch_;
  std::optional<std::int64_t> colorSince_us_;  ///< color has covered the target since; empty: it does not cover it
  std::array<AttemptEvent, 3> events_;
};

}  // namespace insonate
