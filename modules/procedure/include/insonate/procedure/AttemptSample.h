#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>
#include <optional>

namespace insonate {

/// State of probe and needle in one tick (1 ms) of the force loop. Patient space; transforms are rigid and
/// right-handed.
struct AttemptSample {
  std::int64_t time_us = 0;                      ///< time since the recording began; never decreases
  std::optional<Transform> patientFromProbe{};   ///< pose of the probe; empty: no probe is held
  std::optional<Transform> patientFromNeedle{};  ///< pose of the needle: origin at the tip, z in the direction of
                                                 ///< insertion; empty: no needle is held
  /// Depth of the tip below the puncture of the skin, along the needle; empty: the needle is outside the body.
  std::optional<double> needleDepth_mm{};
  double tenting_mm = 0;       ///< distance by which the tip pushes tissue ahead before it punctures a wall; 0: none
  double probeForce_N = 0;     ///< force of the probe on the skin
  double pictureDepth_mm = 0;  ///< depth that the live image shows; 0: no image, or it is frozen
  bool aspirating = false;     ///< true: the syringe aspirates
  // Distance from the needle's tip to artery and lung in their present, deformed position; negative inside. Empty:
  // unknown, or there is no such structure.
  std::optional<double> toArtery_mm{}, toLung_mm{};
  std::optional<double> toVeinCentre_mm{};  ///< distance of the tip from the target vein's center line

  bool operator==(const AttemptSample&) const = default;
};

/// Quantization step of positions in a stored sample.
inline constexpr double kPositionQuantum_mm = 0.001;
inline constexpr double kRotationQuantum =
    1.0 /
    (1 << 18);  ///< quantization step of each component of the unit quaternion; moves a point at 70 mm by 1 um at most
inline constexpr double kForceQuantum_N = 0.001;
inline constexpr double kDistanceQuantum_mm = 0.01;  ///< quantization step of depth and distances
inline constexpr double kFarthest_mm = 2'000'000 * kPositionQuantum_mm;

/// An AttemptSample in whole quantization steps: the stored form, from which all metrics are computed, live or later.
struct QuantisedSample {
  static constexpr int kChannels = 22;
  std::int64_t time_us = 0;
  std::array<std::int32_t, kChannels> channel{};

  bool operator==(const QuantisedSample&) const = default;
};

/// Quantizes a sample. A probe or needle whose pose is not finite, or that is farther than kFarthest_mm from the
/// origin, counts as not held. Other non-finite values count as unknown or 0, and large values are clamped. Neither
/// waits nor allocates.
QuantisedSample quantised(const AttemptSample& sample) noexcept;
/// Converts a quantized sample back; inverse of quantised(). Gives the same result on every computer, since it uses
/// only square roots and basic arithmetic.
AttemptSample restored(const QuantisedSample& sample) noexcept;

}  // namespace insonate
