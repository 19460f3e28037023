#include "display/RowKernels.h"

#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "display/RowKernels.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target.h, which includes this file once for each instruction set.
#include "display/Rows-inl.h"

HWY_BEFORE_NAMESPACE();
namespace insonate::display {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// 10 log10, within 1e-5 dB, of normal positive numbers.
template <class V>
HWY_INLINE V decibels(F d, V power) {
  // power = 2^e m with m in [sqrt(1/2), sqrt(2)); ln m = 2 atanh((m - 1) / (m + 1)).
  const I di;
  const auto bits = hn::BitCast(di, power);
  const auto e = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3F3504F3)));
  const auto m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(e)));
  const auto one = hn::Set(d, 1.0F);
  const auto s = hn::Div(hn::Sub(m, one), hn::Add(m, one));
  const auto s2 = hn::Mul(s, s);
  constexpr float k = 8.685889638F;  // 20 / ln 10
  auto sum = hn::Set(d, k / 5);
  sum = hn::Add(hn::Mul(sum, s2), hn::Set(d, k / 3));
  sum = hn::Add(hn::Mul(sum, s2), hn::Set(d, k));
  return hn::Add(hn::Mul(hn::ConvertTo(d, e), hn::Set(d, 3.010299957F)), hn::Mul(s, sum));
}

void compressRow(const CompressRow& t) {
  const F d;
  const auto share = hn::Set(d, t.mix), offset = hn::Set(d, t.offset_dB);
  const auto low = hn::Set(d, t.low_dB), high = hn::Set(d, t.high_dB), tiny = hn::Set(d, 1e-20F);
  const auto shaded = hn::Set(d, t.shadeShare);
  const auto grainy = hn::Set(d, t.hazeGrain), smooth = hn::Set(d, 1 - t.hazeGrain), grainiest = hn::Set(d, 4.0F);
  overPadded(t.columns, [&](int i) {
    const auto own = hn::Load(d, t.power + i);
    const auto haze = mix(hn::Load(d, t.hazeBefore + i), hn::Load(d, t.hazeAfter + i), share);
    const auto mean = mix(hn::Load(d, t.meanBefore + i), hn::Load(d, t.meanAfter + i), share);
    // Has the speckle of the place's own echo, since both pass through the same beam.
    const auto grain = hn::Min(hn::Div(own, hn::Max(mean, tiny)), grainiest);
    const auto power = hn::Max(hn::Add(own, hn::Mul(haze, hn::Add(smooth, hn::Mul(grainy, grain)))), tiny);
    auto lineOffset = hn::Add(offset, hn::Mul(shaded, hn::Load(d, t.shade_dB + i)));
    if (t.line_dB) lineOffset = hn::Add(lineOffset, hn::Load(d, t.line_dB + i));
    const auto level = hn::Min(hn::Max(hn::Add(decibels(d, power), lineOffset), low), high);
    hn::Store(level, d, t.level_dB + i);
    hn::Store(hn::Add(hn::Load(d, t.sum + i), level), d, t.sum + i);
  });
}

void scaleRow(float* row, float factor, int columns) {
  const F d;
  const auto f = hn::Set(d, factor);
  overPadded(columns, [&](int i) { hn::Store(hn::Mul(hn::Load(d, row + i), f), d, row + i); });
}

void meanRow(const float* above, const float* here, const float* below, int stride, int columns, float* mean) {
  const F d;
  const auto centre = hn::Set(d, 3.0F / 36), next = hn::Set(d, 2.0F / 36), outer = hn::Set(d, 1.0F / 36);
  const auto two = hn::Set(d, 2.0F);
  overPadded(columns, [&](int i) {
    const auto tap = [&](int o) {
      const auto sides = hn::Add(hn::LoadU(d, above + i + o), hn::LoadU(d, below + i + o));
      return hn::Add(hn::Mul(two, hn::LoadU(d, here + i + o)), sides);
    };
    auto sum = hn::Mul(centre, tap(0));
    sum = hn::Add(sum, hn::Mul(next, hn::Add(tap(-stride), tap(stride))));
    sum = hn::Add(sum, hn::Mul(outer, hn::Add(tap(-2 * stride), tap(2 * stride))));
    hn::Store(sum, d, mean + i);
  });
}

void tensorRow(const TensorRow& t) {
  const F d;
  const auto lateral = hn::Set(d, t.lateral), axial = hn::Set(d, t.axial);
  overPadded(t.columns, [&](int i) {
    const auto gx = hn::Mul(lateral, hn::Sub(hn::LoadU(d, t.here + i + t.stride), hn::LoadU(d, t.here + i - t.stride)));
    const auto gz = hn::Mul(axial, hn::Sub(hn::Load(d, t.below + i), hn::Load(d, t.above + i)));
    hn::Store(hn::Mul(gx, gx), d, t.xx + i);
    hn::Store(hn::Mul(gx, gz), d, t.xz + i);
    hn::Store(hn::Mul(gz, gz), d, t.zz + i);
  });
}

/// Slopes of interfaces are computed for groups of 8 scanlines, whatever the instruction set.
using Cell = hn::CappedTag<float, 8>;
constexpr int kCell = 8;

/// Sum of 8 values, in the same order for every instruction set.
HWY_INLINE float cellSum(const float* v) {
  return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
}

/// One slope for each cell, the mean over its interfaces; interfaces in other directions are not followed.
HWY_INLINE void settleSlopes(float* edge, float* slope, int columns) {
  const Cell d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto one = hn::Set(d, 1.0F), zero = hn::Zero(d);
  HWY_ALIGN float weighted[kCell];
  for (int cell = 0; cell < columns; cell += kCell) {
    const float weight = cellSum(edge + cell);
    if (weight == 0) {
      slope[cell] = 0;
      continue;
    }
    for (int i = 0; i < kCell; i += lanes)
      hn::Store(hn::Mul(hn::Load(d, edge + cell + i), hn::Load(d, slope + cell + i)), d, weighted + i);
    const float common = cellSum(weighted) / weight;
    for (int i = cell; i < cell + kCell; i += lanes) {
      const auto apart = hn::Abs(hn::Sub(hn::Load(d, slope + i), hn::Set(d, common)));
      hn::Store(hn::Mul(hn::Load(d, edge + i), hn::Max(hn::Sub(one, apart), zero)), d, edge + i);
    }
    slope[cell] = common;
  }
}

void orientRow(const OrientRow& t) {
  const F d;
  const auto eighth = hn::Set(d, 0.125F), quarter = hn::Set(d, 0.25F), half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F),
             zero = hn::Zero(d);
  const auto averaged = [&](const float* const* rows, int i) {
    const auto column = [&](int o) {
      const auto load = [&](int r) { return hn::LoadU(d, rows[r] + i + o); };
      const auto inner = hn::Add(load(2), hn::Add(load(1), load(3)));
      return hn::Add(hn::Mul(quarter, inner), hn::Mul(eighth, hn::Add(load(0), load(4))));
    };
    return hn::Add(hn::Mul(half, column(0)), hn::Mul(quarter, hn::Add(column(-t.stride), column(t.stride))));
  };
  const auto from = hn::Set(d, t.from), perEdge = hn::Set(d, 1 / (t.to - t.from));
  const auto maxSlope = hn::Set(d, t.maxSlope), tiny = hn::Set(d, 1e-6F);
  overPadded(t.columns, [&](int i) {
    const auto xx = averaged(t.xx, i), xz = averaged(t.xz, i), zz = averaged(t.zz, i);
    const auto difference = hn::Sub(zz, xx), twice = hn::Add(xz, xz);
    const auto anisotropy = hn::Sqrt(hn::Add(hn::Mul(difference, difference), hn::Mul(twice, twice)));
    // The interface is at a right angle to the eigenvector (xz, l1 - xx) of the larger eigenvalue l1.
    const auto alongScan = hn::Max(hn::Mul(half, hn::Add(difference, anisotropy)), tiny);
    const auto slope = hn::Neg(hn::Div(xz, alongScan));
    const auto limited = hn::Min(hn::Max(slope, hn::Neg(maxSlope)), maxSlope);
    // From half the maximum slope on, the strength decreases.
    const auto steepness = hn::Mul(hn::Abs(limited), hn::Set(d, 2 / t.maxSlope));
    const auto followed = hn::Min(hn::Max(hn::Sub(hn::Add(one, one), steepness), zero), one);
    const auto ramp = [&](auto v) { return hn::Min(hn::Max(hn::Mul(hn::Sub(v, from), perEdge), zero), one); };
    hn::Store(ramp(hn::Add(xx, zz)), d, t.structure + i);
    hn::Store(hn::Mul(ramp(anisotropy), followed), d, t.edge + i);
    hn::Store(limited, d, t.slope + i);
  });
  settleSlopes(t.edge, t.slope, t.columns);
}

/// The levels under the taps -3..3, each in the row of an interface with the cell's slope.
HWY_INLINE void alongRows(const SmoothRow& t, int cell, const float* (&rows)[7]) {
  const float perTap = t.slope[cell] * t.rowsPerSlope;
  const float half = perTap < 0 ? -0.5F : 0.5F;
  const auto under = [&](int tap, int offset) {
    const int wanted = t.row + offset;
    const int r = wanted < 0 ? 0 : wanted >= t.rows ? t.rows - 1 : wanted;
    return t.origin + static_cast<std::ptrdiff_t>(r) * t.rowStride + tap * t.alongStride;
  };
  rows[3] = under(0, 0);
  for (int tap = 1; tap <= 3; ++tap) {
    const int offset = static_cast<int>(perTap * static_cast<float>(tap) + half);
    rows[3 - tap] = under(-tap, -offset);
    rows[3 + tap] = under(tap, offset);
  }
}

void smoothRow(const SmoothRow& t) {
  const Cell d;
  constexpr int kWidest = 1024 + 2 * 32;
  HWY_ALIGN float thinned[kWidest];
  float* const axial = thinned + t.margin;
  const F f;
  const auto a0 = hn::Set(f, t.axialWeight[0]), a1 = hn::Set(f, t.axialWeight[1]), a2 = hn::Set(f, t.axialWeight[2]);
  for (int i = -t.margin; i < t.columns + t.margin; i += static_cast<int>(hn::Lanes(f))) {
    auto sum = hn::Mul(a0, hn::LoadU(f, t.axial[2] + i));
    sum = hn::Add(sum, hn::Mul(a1, hn::Add(hn::LoadU(f, t.axial[1] + i), hn::LoadU(f, t.axial[3] + i))));
    sum = hn::Add(sum, hn::Mul(a2, hn::Add(hn::LoadU(f, t.axial[0] + i), hn::LoadU(f, t.axial[4] + i))));
    hn::StoreU(sum, f, axial + i);
  }

  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto p0 = hn::Set(d, t.plainWeight[0]), p1 = hn::Set(d, t.plainWeight[1]), p2 = hn::Set(d, t.plainWeight[2]);
  const auto b0 = hn::Set(d, t.alongWeight[0]), b1 = hn::Set(d, t.alongWeight[1]), b2 = hn::Set(d, t.alongWeight[2]);
  const auto b3 = hn::Set(d, t.alongWeight[3]), share = hn::Set(d, t.mix), one = hn::Set(d, 1.0F), zero = hn::Zero(d);
  const auto contrast = hn::Set(d, t.contrast), bend = hn::Set(d, t.contrastBend);
  const auto reach = hn::Set(d, t.contrastReach);
  const auto strength = hn::Set(d, t.strength), rest = hn::Set(d, 1 - t.strength);
  const auto along = [&](int i) {
    const float* r[7];
    alongRows(t, i / kCell * kCell, r);
    const auto pair = [&](int tap) { return hn::Add(hn::LoadU(d, r[3 - tap] + i), hn::LoadU(d, r[3 + tap] + i)); };
    auto sum = hn::Mul(b0, hn::LoadU(d, r[3] + i));
    sum = hn::Add(sum, hn::Mul(b1, pair(1)));
    sum = hn::Add(sum, hn::Mul(b2, pair(2)));
    return hn::Add(sum, hn::Mul(b3, pair(3)));
  };
  for (int i = 0; i < t.columns; i += lanes) {
    const auto between = [&](const float* before, const float* after) {
      return mix(hn::LoadU(d, before + i), hn::LoadU(d, after + i), share);
    };
    const auto pair = [&](int apart) {
      return hn::Add(hn::LoadU(d, axial + i - apart), hn::LoadU(d, axial + i + apart));
    };
    const auto steep = hn::LoadU(d, axial + i);
    auto level = hn::Mul(p0, steep);
    level = hn::Add(level, hn::Mul(p1, pair(t.plainStride)));
    level = hn::Add(level, hn::Mul(p2, pair(2 * t.plainStride)));
    const auto structure = between(t.structureBefore, t.structureAfter);
    const auto edge = between(t.edgeBefore, t.edgeAfter), mean = between(t.meanBefore, t.meanAfter);
    level = mix(level, steep, structure);
    if (!hn::AllTrue(d, hn::Eq(edge, zero))) level = mix(level, along(i), edge);
    const auto apart = hn::Min(hn::Max(hn::Sub(level, mean), hn::Neg(reach)), reach);
    const auto more = hn::Mul(apart, hn::Add(contrast, hn::Mul(bend, apart)));
    const auto smooth = hn::Add(level, hn::Mul(hn::Sub(one, structure), more));
    hn::StoreU(hn::Add(hn::Mul(rest, hn::LoadU(d, t.axial[2] + i)), hn::Mul(strength, smooth)), d, t.out + i);
  }
}

void enhanceRow(const EnhanceRow& t) {
  const F d;
  const auto half = hn::Set(d, 0.5F), share = hn::Set(d, t.share), reach = hn::Set(d, t.reach_dB);
  overPadded(t.columns, [&](int i) {
    const auto around = hn::Mul(half, hn::Add(hn::LoadU(d, t.above + i), hn::LoadU(d, t.below + i)));
    const auto apart = hn::Min(hn::Max(hn::Sub(hn::LoadU(d, t.here + i), around), hn::Neg(reach)), reach);
    hn::StoreU(hn::Add(hn::LoadU(d, t.level_dB + i), hn::Mul(share, apart)), d, t.level_dB + i);
  });
}

void greyRow(const GreyRow& t) {
  const F d;
  const hn::Rebind<std::uint8_t, F> d8;
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0F);
  const auto share = hn::Set(d, t.persistence), black = hn::Set(d, t.black_dB), perLevel = hn::Set(d, t.perLevel);
  const auto a = hn::Set(d, t.a), b = hn::Set(d, t.b), c = hn::Set(d, t.c);
  const auto white = hn::Set(d, 255.0F), round = hn::Set(d, 0.5F);
  overPadded(t.columns, [&](int i) {
    auto level = hn::LoadU(d, t.level_dB + i);
    if (t.previous) {
      level = mix(level, hn::LoadU(d, t.previous + i), share);
      hn::StoreU(level, d, t.previous + i);
    }
    const auto x = hn::Min(hn::Max(hn::Mul(hn::Sub(level, black), perLevel), zero), one);
    const auto y = hn::Mul(x, hn::Add(a, hn::Mul(x, hn::Add(b, hn::Mul(x, c)))));
    const auto gray = hn::ConvertTo(I(), hn::Add(hn::Mul(y, white), round));
    hn::StoreU(hn::DemoteTo(d8, gray), d8, t.gray + i);
  });
}

void refineRow(const std::uint8_t* gray, int columns, std::uint16_t* fine) {
  const hn::CappedTag<std::int16_t, 16> d;
  const hn::Rebind<std::uint8_t, decltype(d)> d8;
  const hn::RebindToUnsigned<decltype(d)> d16;
  const auto nine = hn::Set(d, 9), half = hn::Set(d, 8), black = hn::Zero(d), white = hn::Set(d, 255);
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < columns; i += lanes) {
    const auto at = [&](int o) { return hn::PromoteTo(d, hn::LoadU(d8, gray + i + o)); };
    const auto here = at(0);
    const auto inner = hn::Mul(nine, hn::Add(here, at(1)));
    const auto between = hn::ShiftRight<4>(hn::Add(hn::Sub(inner, hn::Add(at(-1), at(2))), half));
    const auto held = hn::BitCast(d16, hn::Min(hn::Max(between, black), white));
    hn::StoreU(hn::Or(hn::BitCast(d16, here), hn::ShiftLeft<8>(held)), d16, fine + i);
  }
}

void packRow(const std::uint8_t* here, const std::uint8_t* below, int columns, std::uint32_t* packed) {
  const U d;
  const hn::Rebind<std::uint8_t, U> d8;
  overPadded(columns, [&](int i) {
    const auto byte = [&](const std::uint8_t* from) { return hn::PromoteTo(d, hn::LoadU(d8, from + i)); };
    const auto upper = hn::Or(byte(here), hn::ShiftLeft<8>(byte(here + 1)));
    const auto lower = hn::Or(hn::ShiftLeft<16>(byte(below)), hn::ShiftLeft<24>(byte(below + 1)));
    hn::StoreU(hn::Or(upper, lower), d, packed + i);
  });
}

void scanRow(const std::uint32_t* packed, const std::int32_t* index, const std::uint16_t* weight, int count,
             std::uint8_t* gray) {
  const U d;
  const I di;
  const hn::Rebind<std::uint16_t, U> half;
  const hn::Rebind<std::uint8_t, U> d8;
  const auto low = hn::Set(d, 0x00FF00FFU), byte = hn::Set(d, 0xFFU);
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int i = 0; i < count; i += lanes) {
    const auto four = hn::GatherIndex(d, packed, hn::LoadU(di, index + i));
    const auto weights = hn::PromoteTo(d, hn::LoadU(half, weight + i));
    // Upper and lower row in the halves of each lane; 256 left + (right - left) x stays below 2^16 in both.
    const auto left = hn::And(four, low), right = hn::And(hn::ShiftRight<8>(four), low);
    const auto rows = hn::Add(hn::ShiftLeft<8>(left), hn::Mul(hn::Sub(right, left), hn::And(weights, byte)));
    const auto upper = hn::BitCast(di, hn::And(rows, hn::Set(d, 0xFFFFU)));
    const auto lower = hn::BitCast(di, hn::ShiftRight<16>(rows));
    const auto down = hn::BitCast(di, hn::ShiftRight<8>(weights));
    const auto sum = hn::Add(hn::ShiftLeft<8>(upper), hn::Mul(hn::Sub(lower, upper), down));
    const auto value = hn::DemoteTo(d8, hn::ShiftRight<16>(hn::Add(sum, hn::Set(di, 1 << 15))));
    if (i + lanes <= count) {
      hn::StoreU(value, d8, gray + i);
    } else {
      std::uint8_t rest[16];
      hn::StoreU(value, d8, rest);
      std::memcpy(gray + i, rest, static_cast<std::size_t>(count - i));
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace insonate::display
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::display {

HWY_EXPORT(compressRow);
HWY_EXPORT(scaleRow);
HWY_EXPORT(meanRow);
HWY_EXPORT(tensorRow);
HWY_EXPORT(orientRow);
HWY_EXPORT(smoothRow);
HWY_EXPORT(enhanceRow);
HWY_EXPORT(greyRow);
HWY_EXPORT(refineRow);
HWY_EXPORT(packRow);
HWY_EXPORT(scanRow);

void compressRow(const CompressRow& task) {
  HWY_DYNAMIC_DISPATCH(compressRow)(task);
}
void scaleRow(float* row, float factor, int columns) {
  HWY_DYNAMIC_DISPATCH(scaleRow)(row, factor, columns);
}
void meanRow(const float* above, const float* here, const float* below, int stride, int columns, float* mean) {
  HWY_DYNAMIC_DISPATCH(meanRow)(above, here, below, stride, columns, mean);
}
void tensorRow(const TensorRow& task) {
  HWY_DYNAMIC_DISPATCH(tensorRow)(task);
}
void orientRow(const OrientRow& task) {
  HWY_DYNAMIC_DISPATCH(orientRow)(task);
}
void smoothRow(const SmoothRow& task) {
  HWY_DYNAMIC_DISPATCH(smoothRow)(task);
}
void enhanceRow(const EnhanceRow& task) {
  HWY_DYNAMIC_DISPATCH(enhanceRow)(task);
}
void greyRow(const GreyRow& task) {
  HWY_DYNAMIC_DISPATCH(greyRow)(task);
}
void refineRow(const std::uint8_t* gray, int columns, std::uint16_t* fine) {
  HWY_DYNAMIC_DISPATCH(refineRow)(gray, columns, fine);
}
void packRow(const std::uint8_t* here, const std::uint8_t* below, int columns, std::uint32_t* packed) {
  HWY_DYNAMIC_DISPATCH(packRow)(here, below, columns, packed);
}
void scanRow(const std::uint32_t* packed, const std::int32_t* index, const std::uint16_t* weight, int count,
             std::uint8_t* gray) {
  HWY_DYNAMIC_DISPATCH(scanRow)(packed, index, weight, count, gray);
}

}  // namespace insonate::display
#endif
