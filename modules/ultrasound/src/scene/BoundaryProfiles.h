#pragma once

#include <insonate/tissue/AcousticTable.h>

#include <cstdint>
#include <span>
#include <vector>

namespace insonate {

/// The connective layers at the boundary of every pair of structures, as a function of the signed distance s from the
/// boundary (positive on the first structure's side), tabulated so that every engine reads the same numbers.
class BoundaryProfiles {
 public:
  static constexpr int kEntries = 256;
  /// Step of the table along s, deliberately no round number: distances on a regular grid would otherwise lie exactly
  /// on the limits of entries, where rounding would decide.
  static constexpr double kStep_mm = 0.0251;
  static constexpr double kReach_mm = kEntries / 2 * kStep_mm;

  /// Packs one entry of the table into 32 bits: occupancy (0 to 255: 0 to 1), echo (0 to 255: -32 to +31.75 dB),
  /// anisotropy and patchiness (0 to 255: 0 to 1), from the lowest byte up.
  static std::uint32_t pack(double occupancy, double echo_dB, double anisotropy, double patchiness);

  BoundaryProfiles() = default;
  BoundaryProfiles(const AcousticTable& table, std::span<const std::uint8_t> channelLabels);

  /// Returns the index of the first table entry for an ordered pair of channels (structures).
  int first(int channelA, int channelB) const { return (channelA * channels_ + channelB) * kEntries; }
  const std::vector<std::uint32_t>& entries() const { return entries_; }

 private:
  int channels_ = 0;
  std::vector<std::uint32_t> entries_;
};

/// Tells whether two tissues have equal impedance, attenuation and scattering, so that no boundary is visible between
/// them, whatever their labels.
bool acousticallyEqual(const AcousticTissue& a, const AcousticTissue& b);

}  // namespace insonate
