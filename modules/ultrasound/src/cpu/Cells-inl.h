// Finds the two nearest structures of each cell of one row, computes their boundary and the values that depend on it,
// and expands the results from cells to scanlines.
#if defined(INSONATE_CPU_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_CELLS_INL_H_
#undef INSONATE_CPU_CELLS_INL_H_
#else
#define INSONATE_CPU_CELLS_INL_H_
#endif

#include "cpu/Shifts-inl.h"
#include "cpu/TraceInput.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using CellTag = hn::CappedTag<float, 16>;
using CellIntTag = hn::Rebind<std::int32_t, CellTag>;
using FloatVec = hn::Vec<CellTag>;
using IntVec = hn::Vec<CellIntTag>;

/// Returns one bit for each channel (structure) that can be nearest or second nearest somewhere in a row of cells. Each
/// channel has a minimum and a maximum distance in the row. Let the bound be the second smallest of all maximum
/// distances: at every place two channels are at most that far. A channel whose minimum exceeds the bound is therefore
/// left out. Channels out of reach all have the same distance; only the first of them is kept.
HWY_INLINE std::uint32_t activeChannels(int channels, const TraceBuffers::NodeRow& top,
                                        const TraceBuffers::NodeRow& bottom) {
  float first = 1e30F, second = 1e30F;
  for (int ch = 0; ch < channels; ++ch) {
    const float most = std::max(top.most[ch], bottom.most[ch]);
    if (most < first)
      second = first, first = most;
    else if (most < second)
      second = most;
  }
  std::uint32_t active = 0;
  bool beyond = false;
  for (int ch = 0; ch < channels; ++ch) {
    const float least = std::min(top.least[ch], bottom.least[ch]);
    const bool outOfReach = least >= static_cast<float>(TissueField::kReach_mm);
    if (least > second || (outOfReach && beyond)) continue;
    beyond = beyond || outOfReach;
    active |= 1U << ch;
  }
  return active;
}

/// Expands values from one per lattice cell to one per scanline.
class Spread {
 public:
  explicit Spread(int cellLines) : cellLines_(cellLines) {
    const CellIntTag di;
    alignas(64) std::int32_t low[16], high[16];
    const int lanes = static_cast<int>(hn::Lanes(di));
    for (int i = 0; i < lanes; ++i) low[i] = i / 2, high[i] = (lanes + i) / 2;
    lowLanes_ = hn::Load(di, low), highLanes_ = hn::Load(di, high);
  }

  template <class T, class V>
  HWY_INLINE void store(V value, T* out, int cell) const {
    const hn::Rebind<T, CellTag> d;
    if (cellLines_ == 1) return hn::Store(value, d, out + cell);
    const std::size_t lanes = hn::Lanes(d);
    hn::Store(hn::TableLookupLanes(value, hn::IndicesFromVec(d, lowLanes_)), d, out + 2 * cell);
    hn::Store(hn::TableLookupLanes(value, hn::IndicesFromVec(d, highLanes_)), d, out + 2 * cell + lanes);
  }
  /// Expands a value that varies across the cell: the second scanline of a cell lies halfway to the next cell.
  HWY_INLINE void storeMixed(FloatVec left, FloatVec right, float* out, int cell) const {
    if (cellLines_ == 1) return store(left, out, cell);
    const CellTag d;
    const CellIntTag di;
    const std::size_t lanes = hn::Lanes(d);
    const auto middle = hn::Mul(hn::Add(left, right), hn::Set(d, 0.5F));
    const auto odd = hn::RebindMask(d, hn::Ne(hn::And(hn::Iota(di, 0), hn::Set(di, 1)), hn::Zero(di)));
    const auto low = hn::IndicesFromVec(d, lowLanes_), high = hn::IndicesFromVec(d, highLanes_);
    hn::Store(hn::IfThenElse(odd, hn::TableLookupLanes(middle, low), hn::TableLookupLanes(left, low)), d,
              out + 2 * cell);
    hn::Store(hn::IfThenElse(odd, hn::TableLookupLanes(middle, high), hn::TableLookupLanes(left, high)), d,
              out + 2 * cell + lanes);
  }

 private:
  int cellLines_;
  IntVec lowLanes_, highLanes_;
};

struct NearestPair {
  IntVec a, b;
};

HWY_INLINE NearestPair nearestPair(std::uint32_t active, const TraceBuffers::NodeRow& top,
                                   const TraceBuffers::NodeRow& bottom, int c) {
  const CellTag d;
  const CellIntTag di;
  auto nearest = hn::Set(d, 1e30F), second = nearest;
  auto a = hn::Zero(di), b = a;
  for (std::uint32_t left = active; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const float *t = top.distance[ch] + c, *u = bottom.distance[ch] + c;
    const auto sum =
        hn::Add(hn::Add(hn::LoadU(d, t), hn::LoadU(d, t + 1)), hn::Add(hn::LoadU(d, u), hn::LoadU(d, u + 1)));
    const auto first = hn::Lt(sum, nearest), next = hn::Lt(sum, second);
    const auto firstI = hn::RebindMask(di, first), nextI = hn::RebindMask(di, next);
    const auto channel = hn::Set(di, ch);
    b = hn::IfThenElse(firstI, a, hn::IfThenElse(nextI, channel, b));
    second = hn::IfThenElse(first, nearest, hn::IfThenElse(next, sum, second));
    a = hn::IfThenElse(firstI, channel, a);
    nearest = hn::IfThenElse(first, sum, nearest);
  }
  return {a, b};
}

/// Signed distance s = (dB - dA) / 2 to the boundary between the two nearest structures A and B, at the corners of a
/// cell and, in the neighboring planes, at the cell's first corner.
struct CellDistances {
  FloatVec corner[4], before, after;
};

HWY_INLINE CellDistances distancesOf(std::uint32_t active, const NearestPair& pair, const TraceBuffers::NodeRow& top,
                                     const TraceBuffers::NodeRow& bottom, const TraceBuffers::NodeRow& before,
                                     const TraceBuffers::NodeRow& after, int c) {
  const CellTag d;
  const CellIntTag di;
  const auto half = hn::Set(d, 0.5F);
  const auto zero = hn::Zero(d);
  CellDistances s{{zero, zero, zero, zero}, zero, zero};
  for (std::uint32_t left = active; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const auto lanes = hn::Set(di, ch);
    // +1/2 if the channel is the second nearest, -1/2 if it is the nearest.
    const auto sign = hn::Sub(hn::IfThenElseZero(hn::RebindMask(d, hn::Eq(pair.b, lanes)), half),
                              hn::IfThenElseZero(hn::RebindMask(d, hn::Eq(pair.a, lanes)), half));
    const auto add = [&](FloatVec& sum, const TraceBuffers::NodeRow& row, int at) {
      sum = hn::MulAdd(sign, hn::LoadU(d, row.distance[ch] + at), sum);
    };
    add(s.corner[0], top, c), add(s.corner[1], top, c + 1), add(s.corner[2], bottom, c),
        add(s.corner[3], bottom, c + 1);
    add(s.before, before, c), add(s.after, after, c);
  }
  return s;
}

/// Acoustic constants of the two structures nearest to each SIMD lane's cell.
struct PairConstants {
  FloatVec echo[2], halfway[2], impedance[2];
};

HWY_INLINE PairConstants constantsOf(const TraceInput& in, std::uint32_t active, const NearestPair& pair, FloatVec ct) {
  const CellTag d;
  const CellIntTag di;
  PairConstants k;
  for (int side = 0; side < 2; ++side) k.echo[side] = k.halfway[side] = k.impedance[side] = hn::Zero(d);
  for (std::uint32_t left = active; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const ChannelConstants& channel = in.channels[ch];
    const auto echo = hn::MulAdd(hn::Set(d, channel.ctEcho_dBperHU), ct, hn::Set(d, channel.echo_dB));
    const auto halfway = hn::Set(d, channel.halfway);
    const auto impedance =
        hn::MulAdd(hn::Set(d, channel.impedance * channel.ctImpedancePerHU), ct, hn::Set(d, channel.impedance));
    for (int side = 0; side < 2; ++side) {
      const auto mine = hn::RebindMask(d, hn::Eq(side == 0 ? pair.a : pair.b, hn::Set(di, ch)));
      k.echo[side] = hn::IfThenElse(mine, echo, k.echo[side]);
      k.halfway[side] = hn::IfThenElse(mine, halfway, k.halfway[side]);
      k.impedance[side] = hn::IfThenElse(mine, impedance, k.impedance[side]);
    }
  }
  return k;
}

HWY_INLINE std::uint32_t channelBits(IntVec a, IntVec b) {
  const CellIntTag di;
  const auto one = hn::Set(di, 1);
  alignas(64) std::int32_t bits[16];
  hn::Store(hn::Or(hn::Shl(one, a), hn::Shl(one, b)), di, bits);
  std::uint32_t all = 0;
  for (std::size_t i = 0; i < hn::Lanes(di); ++i) all |= static_cast<std::uint32_t>(bits[i]);
  return all;
}

HWY_INLINE void computeCellRow(const TraceInput& in, int firstLine, int plane, int row, TraceBuffers& b) {
  const CellTag d;
  const CellIntTag di;
  const FramePlan& plan = *in.plan;
  const int lastPlane = plan.settings.elevationPlanes - 1;
  const int lowPlane = std::max(plane - 1, 0), highPlane = std::min(plane + 1, lastPlane);
  const auto &top = b.nodes[plane][row & 1], &bottom = b.nodes[plane][(row + 1) & 1];
  const auto &before = b.nodes[lowPlane][row & 1], &after = b.nodes[highPlane][row & 1];
  TraceBuffers::CellRow& cells = b.cells[plane];
  const Spread spread(plan.cellLines);
  const int channels = in.scene->field.channels;
  const std::uint32_t active = activeChannels(channels, top, bottom);

  const double range_mm = plan.range_mm((row + 0.5) * plan.cellGates);
  const auto perAxial = hn::Set(d, static_cast<float>(0.5 / (plan.cellGates * plan.gate_mm)));
  const auto perLateral =
      hn::Set(d, static_cast<float>(0.5 / (plan.cellLines * plan.grid.scanlineSpacing_mm(range_mm))));
  const std::size_t gate = std::min(row * plan.cellGates, plan.gates - 1);
  const float elevationStep_mm = in.elevation_mm[highPlane * std::size_t(plan.gates) + gate] -
                                 in.elevation_mm[lowPlane * std::size_t(plan.gates) + gate];
  const auto perElevation = hn::Set(d, lastPlane > 0 ? 1 / elevationStep_mm : 0.0F);
  const auto lateralSpread = hn::Set(d, static_cast<float>(plan.grid.scanlineSpacing_mm(range_mm) / plan.gate_mm));
  const auto elevationSpread =
      hn::Set(d, static_cast<float>(plan.planeSpacing_sd * plan.elevationSd_mm[gate] / plan.gate_mm));
  const auto one = hn::Set(d, 1.0F), quarter = hn::Set(d, 0.25F);
  const auto edgeCosine = hn::Set(d, static_cast<float>(acoustics::kEdgeCosine));
  std::uint32_t present = 0;
  auto nearest = hn::Set(d, 1e30F);

  for (int c = 0; c < kBlockLines / plan.cellLines; c += static_cast<int>(hn::Lanes(d))) {
    const NearestPair pair = nearestPair(active, top, bottom, c);
    CellDistances s = distancesOf(active, pair, top, bottom, before, after, c);
    if (channels == 1)
      for (FloatVec& v : s.corner) v = hn::Set(d, static_cast<float>(TissueField::kReach_mm));
    const auto axial = hn::Mul(hn::Add(hn::Sub(s.corner[2], s.corner[0]), hn::Sub(s.corner[3], s.corner[1])), perAxial);
    const auto lateral =
        hn::Mul(hn::Add(hn::Sub(s.corner[1], s.corner[0]), hn::Sub(s.corner[3], s.corner[2])), perLateral);
    const auto inPlane2 = hn::MulAdd(axial, axial, hn::Mul(lateral, lateral));
    const auto atRest2 = lastPlane == 0 && in.displacement
                             ? squaredSlopeAtRest(in, b, firstLine, row, c, axial, lateral, perAxial, perLateral)
                             : inPlane2;
    const auto elevation = lastPlane > 0 ? hn::Mul(hn::Sub(s.after, s.before), perElevation)
                                         : hn::Sqrt(hn::Max(hn::Sub(one, atRest2), hn::Zero(d)));
    const auto gradient = hn::Sqrt(hn::MulAdd(elevation, elevation, inPlane2));
    const auto cosine = hn::Min(one, hn::Div(hn::Abs(axial), hn::Max(gradient, hn::Set(d, 0.3F))));
    const auto aside = hn::Mul(lateral, lateralSpread), across = hn::Mul(elevation, elevationSpread);
    const auto spread_gates = hn::Div(hn::Sqrt(hn::MulAdd(aside, aside, hn::Mul(across, across))),
                                      hn::Max(hn::Abs(axial), hn::Set(d, 1e-3F)));
    // Facing in dB: 20 log10(0.12 + 0.88 cos^2).
    const auto facing = hn::Mul(hn::Log2(d, hn::MulAdd(hn::Set(d, 0.88F), hn::Mul(cosine, cosine), hn::Set(d, 0.12F))),
                                hn::Set(d, 6.0205999F));
    const auto average = [&](const float* t, const float* u) {
      return hn::Mul(hn::Add(hn::Add(hn::LoadU(d, t + c), hn::LoadU(d, t + c + 1)),
                             hn::Add(hn::LoadU(d, u + c), hn::LoadU(d, u + c + 1))),
                     quarter);
    };
    const auto ct = plan.settings.effects.texture && in.anyCt ? average(top.ct, bottom.ct) : hn::Zero(d);
    const PairConstants k = constantsOf(in, active, pair, ct);
    const auto pairIndex = hn::Add(hn::ShiftLeft<4>(pair.a), pair.b);
    static_assert(TissueField::kStride == 16);
    const auto edge = hn::IfThenElse(hn::Lt(cosine, edgeCosine), hn::GatherIndex(d, in.halfwayEdge, pairIndex), one);
    const auto profile =
        hn::Mul(hn::Add(hn::Mul(pair.a, hn::Set(di, channels)), pair.b), hn::Set(di, BoundaryProfiles::kEntries));
    spread.storeMixed(s.corner[0], s.corner[1], cells.sTop, c);
    spread.storeMixed(s.corner[2], s.corner[3], cells.sBottom, c);
    spread.store(cosine, cells.cosine, c);
    spread.store(spread_gates, cells.spread, c);
    spread.store(facing, cells.facing_dB, c);
    spread.storeMixed(hn::LoadU(d, top.patch + c), hn::LoadU(d, top.patch + c + 1), cells.patchTop, c);
    spread.storeMixed(hn::LoadU(d, bottom.patch + c), hn::LoadU(d, bottom.patch + c + 1), cells.patchBottom, c);
    spread.storeMixed(hn::LoadU(d, top.wander_steps + c), hn::LoadU(d, top.wander_steps + c + 1), cells.wanderTop_steps,
                      c);
    spread.storeMixed(hn::LoadU(d, bottom.wander_steps + c), hn::LoadU(d, bottom.wander_steps + c + 1),
                      cells.wanderBottom_steps, c);
    spread.store(k.echo[0], cells.echoA, c), spread.store(k.echo[1], cells.echoB, c);
    spread.store(k.halfway[0], cells.halfwayA, c), spread.store(k.halfway[1], cells.halfwayB, c);
    spread.store(k.impedance[0], cells.impedanceA, c), spread.store(k.impedance[1], cells.impedanceB, c);
    spread.store(edge, cells.halfwayEdge, c);
    spread.store(average(top.inside, bottom.inside), cells.inside, c);
    spread.store(pair.a, cells.channelA, c), spread.store(pair.b, cells.channelB, c);
    spread.store(profile, cells.profile, c);
    present |= channelBits(pair.a, pair.b);
    for (const FloatVec& v : s.corner) nearest = hn::Min(nearest, hn::Abs(v));
  }
  cells.channelsPresent = present;
  // A cell is smaller than a millimeter: each of its samples is at most that much closer to the boundary than the
  // nearest corner.
  cells.nearBoundary = hn::GetLane(hn::MinOfLanes(d, nearest)) < static_cast<float>(BoundaryProfiles::kReach_mm) + 1;
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
