#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>
#include <optional>

namespace insonate {

/// State of both hands in one tick of the servo. Patient space; transforms are rigid and right-handed.
struct AttemptSample {
  std::int64_t time_us = 0;                      ///< since the recording began; never decreases
  std::optional<Transform> patientFromProbe{};   ///< empty: nobody holds the probe
  std::optional<Transform> patientFromNeedle{};  ///< origin at the tip, z in the direction of insertion
  /// Depth of the tip below the hole in the skin, along the needle; empty: outside.
  std::optional<double> needleDepth_mm{};
  double tenting_mm = 0;       ///< distance by which the tip has pushed the tissue before it; 0: no tenting
  double probeForce_N = 0;     ///< force of the probe on the skin
  double pictureDepth_mm = 0;  ///< depth of the live image; 0: no image, or it is frozen
  bool aspirating = false;     ///< the syringe aspirates
  // Distance from the tip to the structure's present place; negative inside. Empty: unknown, or there is no such
  // structure.
  std::optional<double> toArtery_mm{}, toLung_mm{};
  std::optional<double> toVeinCentre_mm{};  ///< distance of the tip from the center line of the vein

  bool operator==(const AttemptSample&) const = default;
};

/// Quantization steps of a stored sample. Rounded rotations move a point 70 mm away by 1 um at most.
inline constexpr double kPositionQuantum_mm = 0.001;
inline constexpr double kRotationQuantum = 1.0 / (1 << 18);  ///< step of a component of the unit quaternion
inline constexpr double kForceQuantum_N = 0.001;
inline constexpr double kDistanceQuantum_mm = 0.01;  ///< step of depth and distances
inline constexpr double kFarthest_mm = 2'000'000 * kPositionQuantum_mm;

/// A sample in whole quantization steps. This is the stored form, from which all metrics are computed, live or later.
struct QuantisedSample {
  static constexpr int kChannels = 22;
  std::int64_t time_us = 0;
  std::array<std::int32_t, kChannels> channel{};

  bool operator==(const QuantisedSample&) const = default;
};

/// Quantizes a sample. A tool whose pose is not finite, or that is farther than kFarthest_mm from the origin, counts as
/// not held. Other non-finite values count as unknown or 0, and large values are clamped. Neither waits nor allocates.
QuantisedSample quantised(const AttemptSample& sample) noexcept;
/// Inverse of quantised(). Gives the same on every machine, since it uses only square roots and basic arithmetic.
AttemptSample restored(const QuantisedSample& sample) noexcept;

}  // namespace insonate
