// Vectors with one value per scanline, and elementary functions on them.
#if defined(INSONATE_CPU_LANES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_LANES_INL_H_
#undef INSONATE_CPU_LANES_INL_H_
#else
#define INSONATE_CPU_LANES_INL_H_
#endif

#include "scene/TextureTiles.h"

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using GateTag = hn::CappedTag<float, 16>;
using GateIntTag = hn::Rebind<std::int32_t, GateTag>;
using GateUintTag = hn::Rebind<std::uint32_t, GateTag>;
using GateVec = hn::Vec<GateTag>;
using GateInt = hn::Vec<GateIntTag>;
using GateUint = hn::Vec<GateUintTag>;

struct Point {
  GateVec x, y, z;
};

/// Constant for rounding: added to a float below 2^22 in magnitude, 1.5 * 2^23 leaves no bits for a fraction. The sum
/// is then the nearest whole number, and its bits are kWholeBits plus that number. This is cheaper than conversions,
/// which guard against overflow.
inline constexpr float kToWhole = 12582912.0F;
inline constexpr std::uint32_t kWholeBits = 0x4B400000U;

/// Returns kWholeBits plus the whole number nearest to x; the low 22 bits are those of the whole number.
HWY_INLINE GateInt wholeBits(GateVec x) {
  const GateTag d;
  return hn::BitCast(GateIntTag(), hn::Add(x, hn::Set(d, kToWhole)));
}

/// The factor log2(10) / 20, which converts dB of amplitude to an exponent of 2.
inline constexpr float kOctavesPerDecibel = 0.16609640474F;

/// Returns 10^(dB / 20), at least 10^-36. Computed as 2^x, with a Taylor polynomial for the fraction of x (relative
/// error below 3e-6 on -0.5 to 0.5).
HWY_INLINE GateVec amplitudeOf(GateVec level_dB) {
  const GateTag d;
  const GateIntTag di;
  const auto x = hn::Max(hn::Mul(level_dB, hn::Set(d, kOctavesPerDecibel)), hn::Set(d, -120.0F));
  const auto whole = hn::Add(x, hn::Set(d, kToWhole));
  const auto f = hn::Sub(x, hn::Sub(whole, hn::Set(d, kToWhole)));
  auto y = hn::Set(d, 1.3333558e-3F);
  y = hn::MulAdd(y, f, hn::Set(d, 9.6181291e-3F));
  y = hn::MulAdd(y, f, hn::Set(d, 5.5504109e-2F));
  y = hn::MulAdd(y, f, hn::Set(d, 0.24022651F));
  y = hn::MulAdd(y, f, hn::Set(d, 0.69314718F));
  y = hn::MulAdd(y, f, hn::Set(d, 1.0F));
  return hn::BitCast(d, hn::Add(hn::BitCast(di, y), hn::ShiftLeft<23>(hn::BitCast(di, whole))));
}

/// Loads four consecutive voxels of a texture tile along its axis w, beginning at each position in `place`; one voxel
/// per byte of a lane.
template <class V>
HWY_INLINE V tileWords(const TextureTile& tile, V place) {
  const hn::DFromV<V> di;
  return hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(tile.value.data()), place);
}

/// Extracts byte kByte of each lane as a signed number: -127 to 127.
template <int kByte, class V>
HWY_INLINE V byteOf(V word) {
  return hn::ShiftRight<24>(hn::ShiftLeft<24 - 8 * kByte>(word));
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
