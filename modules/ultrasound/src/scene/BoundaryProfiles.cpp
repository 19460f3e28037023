#include "scene/BoundaryProfiles.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Layers fade toward their borders: if patchiness or angle weakens a layer, it is thinner as well as darker
/// (layerCover() in model/Boundary.h).
constexpr double kFade = 0.45, kLeastFade_mm = 0.05, kMostFade_mm = 1;

struct Level {
  double occupancy = 0, echo_dB = 0, anisotropy = 0, patchiness = 0;
};

double occupancyOf(const BoundaryLayer& layer, double t_mm) {
  const double fade_mm = std::clamp(kFade * (layer.to_mm - layer.from_mm), kLeastFade_mm, kMostFade_mm);
  const double in = (t_mm - layer.from_mm) / fade_mm + 0.5;
  const double out = (layer.to_mm - t_mm) / fade_mm + 0.5;
  return std::clamp(std::min(in, out), 0.0, 1.0);
}

void add(Level& level, const AcousticTissue& tissue, double t_mm) {
  for (const BoundaryLayer& layer : tissue.layers) {
    const double q = occupancyOf(layer, t_mm);
    if (q <= 0) continue;
    const double share = q / (level.occupancy + q);
    level.echo_dB += share * (layer.echo_dB - level.echo_dB);
    level.anisotropy += share * (layer.anisotropy - level.anisotropy);
    level.patchiness += share * (layer.patchiness - level.patchiness);
    level.occupancy = std::max(level.occupancy, q);
  }
}

std::uint32_t byteOf(double value01) {
  return static_cast<std::uint32_t>(std::lround(std::clamp(value01, 0.0, 1.0) * 255));
}

}  // namespace

std::uint32_t BoundaryProfiles::pack(double occupancy, double echo_dB, double anisotropy, double patchiness) {
  const auto echo = static_cast<std::uint32_t>(std::clamp(std::lround((echo_dB + 32) * 4), 0L, 255L));
  return byteOf(occupancy) | echo << 8 | byteOf(anisotropy) << 16 | byteOf(patchiness) << 24;
}

bool acousticallyEqual(const AcousticTissue& a, const AcousticTissue& b) {
  return a.impedance_MRayl == b.impedance_MRayl && a.attenuation_dBpcmMHz == b.attenuation_dBpcmMHz &&
         a.echogenicity_dB == b.echogenicity_dB;
}

BoundaryProfiles::BoundaryProfiles(const AcousticTable& table, std::span<const std::uint8_t> channelLabels)
    : channels_(static_cast<int>(channelLabels.size())), entries_(std::size_t(channels_) * channels_ * kEntries, 0) {
  for (int a = 0; a < channels_; ++a)
    for (int b = 0; b < channels_; ++b) {
      const AcousticTissue &first_ = table.of(channelLabels[a]), &second = table.of(channelLabels[b]);
      if (a == b || acousticallyEqual(first_, second)) continue;
      for (int i = 0; i < kEntries; ++i) {
        const double s_mm = (i - kEntries / 2 + 0.5) * kStep_mm;
        Level level;
        // Beside a vessel there are only the vessel's own wall and sheath.
        if (first_.vessel || !second.vessel) add(level, first_, -s_mm);
        if (second.vessel || !first_.vessel) add(level, second, s_mm);
        entries_[first(a, b) + i] = pack(level.occupancy, level.echo_dB, level.anisotropy, level.patchiness);
      }
    }
}

}  // namespace insonate
