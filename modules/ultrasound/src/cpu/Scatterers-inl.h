// Individual scatterers: complex noise, computed as a hash of a node of the patient's scatterer lattice.
#if defined(INSONATE_CPU_SCATTERERS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_SCATTERERS_INL_H_
#undef INSONATE_CPU_SCATTERERS_INL_H_
#else
#define INSONATE_CPU_SCATTERERS_INL_H_
#endif

#include "cpu/Lanes-inl.h"
#include "model/Scatterers.h"

#include <insonate/core/Hash.h>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE GateUint hashLanes(GateUint x) {
  const GateUintTag du;
  x = hn::Xor(x, hn::ShiftRight<16>(x));
  x = hn::Mul(x, hn::Set(du, 0x21f0aaadU));
  x = hn::Xor(x, hn::ShiftRight<15>(x));
  x = hn::Mul(x, hn::Set(du, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

/// Corners of the tetrahedron that contains each lane's point: their hashes, and their weights as whole numbers with
/// the sum kWeightOne, two per lane.
struct Corners {
  GateUint hash[4];
  GateInt weight01, weight23;
};
inline constexpr std::int32_t kWeightOne = 32767;

/// Finds the corners of the scatterer lattice around points p. See tetrahedronAt() for the division of the lattice's
/// cells, and hashNode() for the hash.
HWY_INLINE Corners cornersAt(std::uint32_t latticeSeed, const Point& p) {
  const GateTag d;
  const GateIntTag di;
  const GateUintTag du;
  const auto wx = hn::Floor(p.x), wy = hn::Floor(p.y), wz = hn::Floor(p.z);
  const auto fx = hn::Sub(p.x, wx), fy = hn::Sub(p.y, wy), fz = hn::Sub(p.z, wz);
  const auto key = [&](GateVec whole, std::uint32_t factor) {
    return hn::Sub(hn::Mul(hn::BitCast(du, wholeBits(whole)), hn::Set(du, factor)), hn::Set(du, kWholeBits * factor));
  };
  constexpr std::uint32_t kX = 0x8da6b343U, kY = 0xd8163841U, kZ = 0xcb1ab31fU;  // constants of hashNode()
  const auto x0 = key(wx, kX), y0 = key(wy, kY), z0 = key(wz, kZ);
  const auto x1 = hn::Add(x0, hn::Set(du, kX)), y1 = hn::Add(y0, hn::Set(du, kY)), z1 = hn::Add(z0, hn::Set(du, kZ));
  const auto seed = hn::Set(du, latticeSeed);

  const auto xy = hn::Ge(fx, fy), yz = hn::Ge(fy, fz), xz = hn::Ge(fx, fz);
  const auto firstX = hn::And(xy, xz), firstY = hn::AndNot(xy, yz);
  const auto lastX = hn::AndNot(hn::Or(xy, xz), hn::Eq(fx, fx)), lastY = hn::AndNot(yz, xy);
  const auto u = [&](auto mask) { return hn::RebindMask(du, mask); };
  const auto fX = u(firstX), fY = u(firstY), lX = u(lastX), lY = u(lastY);
  Corners corners;
  corners.hash[0] = hashLanes(hn::Xor(hn::Xor(x0, y0), hn::Xor(z0, seed)));
  corners.hash[1] = hashLanes(hn::Xor(hn::Xor(hn::IfThenElse(fX, x1, x0), hn::IfThenElse(fY, y1, y0)),
                                      hn::Xor(hn::IfThenElse(hn::Or(fX, fY), z0, z1), seed)));
  corners.hash[2] = hashLanes(hn::Xor(hn::Xor(hn::IfThenElse(lX, x0, x1), hn::IfThenElse(lY, y0, y1)),
                                      hn::Xor(hn::IfThenElse(hn::Or(lX, lY), z1, z0), seed)));
  corners.hash[3] = hashLanes(hn::Xor(hn::Xor(x1, y1), hn::Xor(z1, seed)));

  const auto whole = [&](GateVec f) {
    const auto one = hn::Set(d, static_cast<float>(kWeightOne));
    return hn::BitCast(di, hn::MulAdd(f, one, hn::Set(d, kToWhole)));
  };
  const auto high = whole(hn::Max(fx, hn::Max(fy, fz))), low = whole(hn::Min(fx, hn::Min(fy, fz)));
  const auto middle = whole(hn::Max(hn::Min(fx, fy), hn::Min(hn::Max(fx, fy), fz)));
  const auto first = hn::Sub(hn::Set(di, static_cast<std::int32_t>(kWholeBits) + kWeightOne), high);
  corners.weight01 = hn::Or(first, hn::ShiftLeft<16>(hn::Sub(high, middle)));
  corners.weight23 = hn::Or(hn::Sub(middle, low), hn::ShiftLeft<16>(low));
  return corners;
}

/// Computes a0 b0 + a1 b1 from the 16-bit numbers in the two halves of a lane.
HWY_INLINE GateInt pairProduct(GateInt a, GateInt b) {
#if HWY_TARGET == HWY_SCALAR  // the scalar target has no vectors of two
  const auto low = [](GateInt v) { return hn::ShiftRight<16>(hn::ShiftLeft<16>(v)); };
  return hn::Add(hn::Mul(low(a), low(b)), hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
#else
  const GateIntTag di;
  const hn::Repartition<std::int16_t, GateTag> d16;
  auto odd = hn::Zero(di);
  const auto even = hn::ReorderWidenMulAccumulate(di, hn::BitCast(d16, a), hn::BitCast(d16, b), hn::Zero(di), odd);
  return hn::RearrangeToOddPlusEven(even, odd);
#endif
}

/// Adds to `sum` the complex scatterer amplitudes {re, im} of each look at p (in the scatterers' lattice), multiplied
/// by `amplitude`; see scattererAmplitudes(). The random numbers are not centered: the contribution of their common
/// mean is added to `offset`, and subtracted at the end. Each half of a hash contains three numbers of five bits. The
/// numbers are multiplied by the weights without being shifted, as 16-bit numbers, two corners at once; the scale
/// compensates for the missing shift.
template <int kLooks>
HWY_INLINE void addScatterers(std::uint32_t latticeSeed, const Point& p, GateVec amplitude, GateVec* sum,
                              GateVec& offset) {
  const GateTag d;
  const GateIntTag di;
  const GateUintTag du;
  const Corners corners = cornersAt(latticeSeed, p);
  const auto power = hn::ConvertTo(d, hn::Add(pairProduct(corners.weight01, corners.weight01),  //
                                              pairProduct(corners.weight23, corners.weight23)));
  // One step of Newton's method after the processor's approximation.
  const auto guess = hn::ApproximateReciprocalSqrt(power);
  const auto correction = hn::NegMulAdd(hn::Mul(hn::Mul(power, hn::Set(d, 0.5F)), guess), guess, hn::Set(d, 1.5F));
  const auto scale =
      hn::Mul(hn::Mul(amplitude, hn::Set(d, static_cast<float>(kScattererUnit))), hn::Mul(guess, correction));
  offset = hn::MulAdd(scale, hn::Set(d, static_cast<float>(kScattererMean * kWeightOne)), offset);

  const auto lower = hn::Set(du, 0xFFFFU), upper = hn::Set(du, 0xFFFF0000U);
  const GateUint* h = corners.hash;
  const GateUint low01 = hn::Or(hn::And(h[0], lower), hn::ShiftLeft<16>(h[1])),
                 low23 = hn::Or(hn::And(h[2], lower), hn::ShiftLeft<16>(h[3])),
                 high01 = hn::Or(hn::ShiftRight<16>(h[0]), hn::And(h[1], upper)),
                 high23 = hn::Or(hn::ShiftRight<16>(h[2]), hn::And(h[3], upper));
  for (int c = 0; c < 2 * kLooks; ++c) {
    const int place = kScattererShift[c] & 15;
    const auto field = hn::Set(du, 0x001F001FU << place);
    const auto of = [&](GateUint pair) { return hn::BitCast(di, hn::And(pair, field)); };
    const bool inLow = kScattererShift[c] < 16;
    const auto value = hn::Add(pairProduct(of(inLow ? low01 : high01), corners.weight01),  //
                               pairProduct(of(inLow ? low23 : high23), corners.weight23));
    const auto unit = hn::Mul(scale, hn::Set(d, 1.0F / static_cast<float>(1 << place)));
    sum[c] = hn::MulAdd(unit, hn::ConvertTo(d, value), sum[c]);
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
