#include "ValueShift.h"

#include "../files/Hounsfield.h"

#include <insonate/cases/Import.h>

#include <algorithm>
#include <limits>

namespace insonate {
namespace {

/// Scanners with 12 bits store HU + 1024.
constexpr int kStoredOffset_HU = 1024;

/// Shares of the voxels other than padding, named under the assumption that HU + 1024 is stored.
struct Shares {
  double air = 0, between = 0, softTissue = 0, bone = 0, belowZero = 0;
};

Shares sharesOf(const CtVolume& ct) {
  constexpr int kMaxAir = 250, kMinBetween = 400, kMinSoft = 900, kMaxSoft = 1150;
  std::size_t all = 0, air = 0, between = 0, soft = 0, bone = 0, below = 0;
  for (const std::int16_t value : ct.voxels) {
    all += value != kAirHu;
    below += value != kAirHu && value < 0;
    air += value >= 0 && value < kMaxAir;
    between += value >= kMinBetween && value < kMinSoft;
    soft += value >= kMinSoft && value <= kMaxSoft;
    bone += value > kMaxSoft;
  }
  const auto share = [&](std::size_t count) { return all > 0 ? double(count) / double(all) : 0.0; };
  return {share(air), share(between), share(soft), share(bone), share(below)};
}

}  // namespace

bool hasNothingBelowZero(const CtVolume& ct) {
  return std::ranges::none_of(ct.voxels, [](std::int16_t value) { return value < 0 && value != kAirHu; });
}

std::optional<int> likelyShift(const CtVolume& ct) {
  // Resampling makes a few intermediate values between padding and image.
  constexpr double kFew = 0.01, kMuch = 0.05;
  const Shares shares = sharesOf(ct);
  // A CT in Hounsfield units that is cut off at 0 has only bone there, which is evenly distributed; fat, muscle and
  // organs form a peak.
  const bool softTissueIsAPeak =
      shares.softTissue > kMuch && shares.softTissue > 2 * shares.between && shares.softTissue > shares.bone;
  if (shares.belowZero > kFew || shares.air < kMuch || !softTissueIsAPeak) return std::nullopt;
  return -kStoredOffset_HU;
}

void shiftValues(ImportedCt& imported, int shift_HU) {
  constexpr int kMostHu = std::numeric_limits<std::int16_t>::max();
  for (std::int16_t& value : imported.ct.voxels)
    if (value != kAirHu) value = static_cast<std::int16_t>(std::clamp(value + shift_HU, kAirHu, kMostHu));
  imported.likelyShift_HU.reset();
  imported.series.warnings.push_back("As requested, " + std::to_string(shift_HU) +
                                     " was added to every value to convert it to Hounsfield units.");
}

}  // namespace insonate
