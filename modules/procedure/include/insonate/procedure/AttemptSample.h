#pragma once

#include <insonate/core/Transform.h>

#include <array>
#include <cstdint>
#include <optional>

namespace insonate {

/// State of probe and needle in one tick (1 ms) of the force loop. Patient space; transforms are rigid and
/// right-handed.
struct AttemptSample {
  std::int64_t time_us = 0;                     ///< time since the recording began; never decreases
  std::optional<Transform> patientFromProbe{};  ///< pose of the probe; empty: no probe is held
  /// pose of the needle: origin at the tip, z in the direction of insertion; empty: no needle is held
  std::optional<Transform> patientFromNeedle{};
  /// depth of the tip along the needle, measured from the puncture of the skin; empty: no needle is held, or the needle
  /// is outside the body
  std::optional<double> needleDepth_mm{};
  double tenting_mm = 0;    ///< tenting: distance by which the tip has pushed a wall ahead without a puncture; 0: none
  double probeForce_N = 0;  ///< force of the probe on the skin
  /// depth to which the live image shows tissue; 0: there is no image, or the image is frozen
  double imageDepth_mm = 0;
  bool aspirating = false;  ///< true: the syringe aspirates
  /// distances from the needle's tip to artery and lung at their present, deformed positions; negative inside the
  /// structure; empty: unknown, or there is no such structure
  std::optional<double> toArtery_mm{}, toLung_mm{};
  std::optional<double> toVeinCenter_mm{};  ///< distance of the tip from the target vein's center line
  /// lengths of wire, dilator and catheter below the puncture of the skin; empty: the instrument is outside the body
  std::optional<double> wire_mm{}, dilator_mm{}, catheter_mm{};
  /// distances along the vessels from the tips of wire and catheter to the cavo-atrial junction, where the superior
  /// vena cava opens into the right atrium; negative: the tip is beyond it; empty: the tip is outside the body or not
  /// on a way to the heart
  std::optional<double> wireToHeart_mm{}, catheterToHeart_mm{};

  bool operator==(const AttemptSample&) const = default;
};

/// Quantization step of positions in a QuantizedSample.
inline constexpr double kPositionQuantum_mm = 0.001;
/// Quantization step of each component of a unit quaternion; changes the position of a point at 70 mm by at most 1 um.
inline constexpr double kRotationQuantum = 1.0 / (1 << 18);
inline constexpr double kForceQuantum_N = 0.001;
inline constexpr double kDistanceQuantum_mm = 0.01;  ///< quantization step of depth and distances
inline constexpr double kFarthest_mm = 2'000'000 * kPositionQuantum_mm;

/// An AttemptSample in whole quantization steps. Recordings store samples in this form, and all metrics, live and
/// replayed, are computed from it.
struct QuantizedSample {
  static constexpr int kChannels = 27;
  std::int64_t time_us = 0;
  std::array<std::int32_t, kChannels> channel{};

  bool operator==(const QuantizedSample&) const = default;
};

/// Quantizes a sample. A pose that is not finite or farther than kFarthest_mm from the origin is stored as empty: the
/// probe or needle is not held. Other values that are not finite are stored as unknown or 0, and large values are
/// clamped. Neither waits nor allocates.
QuantizedSample quantize(const AttemptSample& sample) noexcept;
/// Converts a quantized sample to an AttemptSample. The result is the same on every computer, since only square roots
/// and basic arithmetic are used.
AttemptSample dequantize(const QuantizedSample& sample) noexcept;

}  // namespace insonate
