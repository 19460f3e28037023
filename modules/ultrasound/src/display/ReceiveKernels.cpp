#include "display/ReceiveKernels.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/ReceiveKernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h, which includes this file once for each instruction set.
#include "display/Rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace insonate::display {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// The same for a row without padding of at least 16 columns: the last vector overlaps the one before.
template <class Body>
HWY_INLINE void overExact(int columns, const Body& body) {
  const int lanes = static_cast<int>(hn::Lanes(F()));
  int i = 0;
  for (; i + lanes <= columns; i += lanes) body(i);
  if (i < columns) body(columns - lanes);
}

/// hash32() of core/Hash.h.
template <class V>
HWY_INLINE V hashed(U d, V x) {
  x = hn::Xor(x, hn::ShiftRight<16>(x));
  x = hn::Mul(x, hn::Set(d, 0x21f0aaadU));
  x = hn::Xor(x, hn::ShiftRight<15>(x));
  x = hn::Mul(x, hn::Set(d, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

/// The number of ones among the 32 bits of a hash, with zero mean and unit variance: a binomial distribution, nearly
/// Gaussian (excess kurtosis -1/16), and closer once rows are mixed.
template <class V>
HWY_INLINE auto onesOf(V hash) {
  const F f;
  const I di;
  const auto centered = hn::Sub(hn::BitCast(di, hn::PopulationCount(hash)), hn::Set(di, 16));
  return hn::Mul(hn::ConvertTo(f, centered), hn::Set(f, 0.353553391F));  // sqrt(1/8)
}

void whiteRow(const WhiteRow& t) {
  const F f;
  const U d;
  const auto seed = hn::Set(d, t.seed), step = hn::Set(d, 0x8da6b343U), other = hn::Set(d, 0x9e3779b9U);
  overPadded(t.columns, [&](int i) {
    const auto column = hn::Iota(d, static_cast<std::uint32_t>(i));
    const auto first = hashed(d, hn::Xor(hn::Mul(column, step), seed));
    hn::Store(onesOf(first), f, t.real + i);
    hn::Store(onesOf(hashed(d, hn::Add(first, other))), f, t.imaginary + i);
  });
}

constexpr float kMaxAmplitude = 1e9F;  // stronger and infinite echoes are limited to this

template <bool kNoise>
HWY_INLINE void compoundLooks(const CompoundRow& t) {
  const F d;
  const auto zero = hn::Zero(d), most = hn::Set(d, kMaxAmplitude);
  const auto share = hn::Set(d, t.looks > 0 ? 1 / static_cast<float>(t.looks) : 0.0F),
             gain = hn::Set(d, t.gain * t.gain);
  const auto noise = hn::Set(d, t.noise.amplitude);
  overExact(t.columns, [&](int i) {
    auto sum = zero;
    for (int l = 0; l < t.looks; ++l) {
      const auto a = hn::LoadU(d, t.look[l] + i);
      sum = hn::Add(sum, hn::IfThenElseZero(hn::Gt(a, zero), hn::Min(a, most)));
    }
    if (t.contact) sum = hn::Mul(sum, hn::LoadU(d, t.contact + i));
    const auto mean = hn::Mul(sum, share);
    auto power = hn::Mul(mean, mean);
    if constexpr (kNoise) {
      const auto inPhase = hn::Mul(hn::Mul(mean, noise), hn::LoadU(d, t.noise.twiceInPhase + i));
      const auto alone = hn::Mul(hn::Mul(noise, noise), hn::LoadU(d, t.noise.power + i));
      power = hn::Max(hn::Add(power, hn::Add(inPhase, alone)), zero);
    }
    hn::StoreU(hn::Mul(power, gain), d, t.power + i);
  });
}

void compoundRow(const CompoundRow& t) {
  if (t.noise.power)
    compoundLooks<true>(t);
  else
    compoundLooks<false>(t);
  const F d;
  const auto ceiling = hn::Set(d, t.ceiling), strongCeiling = hn::Set(d, t.strongCeiling);
  overPadded(t.columns, [&](int i) {
    const auto power = hn::Load(d, t.power + i);
    hn::Store(hn::Add(hn::Load(d, t.sum + i), hn::Min(power, ceiling)), d, t.sum + i);
    hn::Store(hn::Add(hn::Load(d, t.strong + i), hn::Min(power, strongCeiling)), d, t.strong + i);
  });
}

void ringingRow(const RingingRow& t) {
  const F d;
  const auto touching = hn::Set(d, t.touching), lifted = hn::Set(d, t.lifted);
  overPadded(t.columns, [&](int i) {
    const auto ring = hn::Mul(hn::Load(d, t.line + i), mix(touching, lifted, hn::Load(d, t.lack + i)));
    hn::Store(hn::Add(hn::Load(d, t.power + i), ring), d, t.power + i);
  });
}

void hazeRow(const HazeRow& t) {
  const F d;
  const auto side = hn::Set(d, t.spread), middle = hn::Set(d, 1 - 2 * t.spread);
  const auto tailDecay = hn::Set(d, t.tailDecay), grainDecay = hn::Set(d, t.grainDecay),
             longDecay = hn::Set(d, t.longDecay);
  const auto share = hn::Set(d, t.share), longShare = hn::Set(d, t.longShare), smooth = hn::Set(d, t.smoothShare),
             rough = hn::Set(d, 1 - t.smoothShare);
  const auto tiny = hn::Set(d, 1e-20F), most = hn::Set(d, 4.0F);
  const auto half = hn::Set(d, 0.5F);
  const auto carried = [&](const float* above, int i) {
    const auto sides = hn::Add(hn::LoadU(d, above + i - t.stride), hn::LoadU(d, above + i + t.stride));
    // Includes the nearest ones, since a comb would keep values between its teeth.
    const auto near = hn::Add(hn::LoadU(d, above + i - 1), hn::LoadU(d, above + i + 1));
    const auto here = hn::MulAdd(hn::Sub(hn::Mul(near, half), hn::Load(d, above + i)), half, hn::Load(d, above + i));
    return hn::Add(hn::Mul(middle, here), hn::Mul(side, sides));
  };
  overPadded(t.columns, [&](int i) {
    const auto power = hn::Load(d, t.power + i);
    const auto tail = mix(power, carried(t.tailAbove, i), tailDecay);
    const auto grain = mix(power, carried(t.grainAbove, i), grainDecay);
    hn::Store(tail, d, t.tail + i);
    hn::Store(grain, d, t.grain + i);
    const auto longTail = mix(hn::Load(d, t.strong + i), carried(t.longAbove, i), longDecay);
    hn::Store(longTail, d, t.longTail + i);
    const auto speckle = hn::Min(hn::Div(power, hn::Max(grain, tiny)), most);
    const auto tails = hn::Add(hn::Mul(share, tail), hn::Mul(longShare, longTail));
    const auto even = hn::Mul(hn::Add(tails, hn::Load(d, t.smeared + i)), hn::Load(d, t.drift + i));
    hn::Store(hn::Mul(even, hn::Add(smooth, hn::Mul(rough, speckle))), d, t.haze + i);
  });
}

}  // namespace HWY_NAMESPACE
}  // namespace insonate::display
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::display {

HWY_EXPORT(whiteRow);
HWY_EXPORT(compoundRow);
HWY_EXPORT(ringingRow);
HWY_EXPORT(hazeRow);

void whiteRow(const WhiteRow& task) {
  HWY_DYNAMIC_DISPATCH(whiteRow)(task);
}
void compoundRow(const CompoundRow& task) {
  HWY_DYNAMIC_DISPATCH(compoundRow)(task);
}
void ringingRow(const RingingRow& task) {
  HWY_DYNAMIC_DISPATCH(ringingRow)(task);
}
void hazeRow(const HazeRow& task) {
  HWY_DYNAMIC_DISPATCH(hazeRow)(task);
}

}  // namespace insonate::display
#endif
