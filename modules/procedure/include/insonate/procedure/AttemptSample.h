#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>
#include <optional>

namespace insonate {

/// State of both hands in one tick of the servo. Patient space; transforms are rigid and right-handed.
struct AttemptSample {
  std::int64_t time_us = 0;                      ///< since the recording began; never falls
  std::optional<Transform> patientFromProbe{};   ///< none: nobody holds it
  std::optional<Transform> patientFromNeedle{};  ///< origin at the tip, z the way it goes in
  std::optional<double> needleDepth_mm{};        ///< of the tip below the skin's hole, along the needle; none: outside
  double tenting_mm = 0;                         ///< how far the tip has pushed what is before it; 0: nothing
  double probeForce_N = 0;                       ///< with which the probe presses on the skin
  double pictureDepth_mm = 0;                    ///< of the live image; 0: there is none, or it stands still
  bool aspirating = false;                       ///< the syringe draws
  // From the tip to where the structures are just then; negative inside. None: not known, or there are none.
  std::optional<double> toArtery_mm{}, toLung_mm{};
  std::optional<double> toVeinCentre_mm{};  ///< to the center line of the vein

  bool operator==(const AttemptSample&) const = default;
};

/// Steps in which a recording stores samples. Rounded rotations move a point 70 mm away by 1 um at most.
inline constexpr double kPositionQuantum_mm = 0.001;
inline constexpr double kRotationQuantum = 1.0 / (1 << 18);  ///< of a component of the unit quaternion
inline constexpr double kForceQuantum_N = 0.001;
inline constexpr double kDistanceQuantum_mm = 0.01;  ///< of depth and distances
inline constexpr double kFarthest_mm = 2'000'000 * kPositionQuantum_mm;

/// A sample in whole steps: the stored form, from which all metrics, live or later, are computed.
struct QuantisedSample {
  static constexpr int kChannels = 22;
  std::int64_t time_us = 0;
  std::array<std::int32_t, kChannels> channel{};

  bool operator==(const QuantisedSample&) const = default;
};

/// Quantizes a sample. A tool that is not finite or farther than kFarthest_mm from the origin counts as not held;
/// other non-finite values count as unknown or 0, and large ones are clamped. Neither waits nor allocates.
QuantisedSample quantised(const AttemptSample& sample) noexcept;
/// Inverse of quantised(). The same on every machine: square roots and plain arithmetic.
AttemptSample restored(const QuantisedSample& sample) noexcept;

}  // namespace insonate
