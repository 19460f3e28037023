// The two nearest structures of each cell of one row, their boundary, and what follows from it, spread to scanlines.
#if defined(INSONATE_CPU_CELLS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_CELLS_INL_H_
#undef INSONATE_CPU_CELLS_INL_H_
#else
#define INSONATE_CPU_CELLS_INL_H_
#endif

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

/// Channels that can be among the two nearest anywhere in this row: those within reach, and the first of those beyond,
/// which are all equally far.
HWY_INLINE std::uint32_t activeChannels(const TraceInput& in, int row, const TraceBuffers& b) {
  const FramePlan& plan = *in.plan;
  const int columns = kBlockLines / plan.cellLines + 1;
  std::uint32_t active = 0;
  int beyond = -1;
  for (int ch = 0; ch < in.scene->field.channels; ++ch) {
    bool near = false;
    for (int p = 0; p < plan.settings.elevationPlanes && !near; ++p)
      for (int parity = 0; parity < 2 && !near; ++parity) {
        const float* d = b.nodes[p][parity].distance[ch];
        float least = d[0];
        for (int c = 1; c < columns; ++c) least = std::min(least, d[c]);
        near = least < static_cast<float>(TissueField::kReach_mm);
      }
    if (near) active |= 1U << ch;
    if (!near && beyond < 0) beyond = ch;
  }
  (void)row;
  return beyond >= 0 ? active | 1U << beyond : active;
}

/// Spreads one value per cell to one per scanline.
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
  /// For what varies across the cell: the second scanline of a cell lies halfway to the next.
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

/// Distances of each lane's own channel, picked from rows of all channels.
HWY_INLINE FloatVec pick(std::uint32_t active, IntVec channel, const TraceBuffers::NodeRow& row, int at) {
  const CellTag d;
  const CellIntTag di;
  auto out = hn::Zero(d);
  for (std::uint32_t left = active; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const auto mine = hn::RebindMask(d, hn::Eq(channel, hn::Set(di, ch)));
    out = hn::IfThenElse(mine, hn::LoadU(d, row.distance[ch] + at), out);
  }
  return out;
}

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

HWY_INLINE void computeCellRow(const TraceInput& in, int plane, int row, std::uint32_t active, TraceBuffers& b) {
  const CellTag d;
  const CellIntTag di;
  const FramePlan& plan = *in.plan;
  const Effects& effects = plan.settings.effects;
  const int lastPlane = plan.settings.elevationPlanes - 1;
  const int lowPlane = std::max(plane - 1, 0), highPlane = std::min(plane + 1, lastPlane);
  const auto &top = b.nodes[plane][row & 1], &bottom = b.nodes[plane][(row + 1) & 1];
  const auto &before = b.nodes[lowPlane][row & 1], &after = b.nodes[highPlane][row & 1];
  TraceBuffers::CellRow& cells = b.cells[plane];
  const Spread spread(plan.cellLines);
  const bool onePair = in.scene->field.channels == 1;

  const double range_mm = plan.range_mm((row + 0.5) * plan.cellGates);
  const auto perAxial = hn::Set(d, static_cast<float>(0.5 / (plan.cellGates * plan.gate_mm)));
  const auto perLateral =
      hn::Set(d, static_cast<float>(0.5 / (plan.cellLines * plan.grid.scanlineSpacing_mm(range_mm))));
  const std::size_t gate = std::min(row * plan.cellGates, plan.gates - 1);
  const float elevationStep_mm = in.elevation_mm[highPlane * std::size_t(plan.gates) + gate] -
                                 in.elevation_mm[lowPlane * std::size_t(plan.gates) + gate];
  const auto perElevation = hn::Set(d, lastPlane > 0 ? 1 / elevationStep_mm : 0.0F);
  const auto half = hn::Set(d, 0.5F), one = hn::Set(d, 1.0F), quarter = hn::Set(d, 0.25F);
  std::uint32_t present = 0;
  auto nearest = hn::Set(d, 1e30F);

  for (int c = 0; c < kBlockLines / plan.cellLines; c += static_cast<int>(hn::Lanes(d))) {
    const NearestPair pair = nearestPair(active, top, bottom, c);
    const auto corner = [&](const TraceBuffers::NodeRow& r, int at) {
      if (onePair) return hn::Set(d, static_cast<float>(TissueField::kReach_mm));
      return hn::Mul(hn::Sub(pick(active, pair.b, r, at), pick(active, pair.a, r, at)), half);
    };
    const auto s0 = corner(top, c), s1 = corner(top, c + 1), s2 = corner(bottom, c), s3 = corner(bottom, c + 1);
    const auto axial = hn::Mul(hn::Add(hn::Sub(s2, s0), hn::Sub(s3, s1)), perAxial);
    const auto lateral = hn::Mul(hn::Add(hn::Sub(s1, s0), hn::Sub(s3, s2)), perLateral);
    const auto inPlane2 = hn::MulAdd(axial, axial, hn::Mul(lateral, lateral));
    const auto elevation = lastPlane > 0 ? hn::Mul(hn::Sub(corner(after, c), corner(before, c)), perElevation)
                                         : hn::Sqrt(hn::Max(hn::Sub(one, inPlane2), hn::Zero(d)));
    const auto gradient = hn::Sqrt(hn::MulAdd(elevation, elevation, inPlane2));
    const auto cosine = hn::Min(one, hn::Div(hn::Abs(axial), hn::Max(gradient, hn::Set(d, 0.3F))));
    // 20 log10(0.12 + 0.88 cos^2)
    const auto facing = hn::Mul(hn::Log2(d, hn::MulAdd(hn::Set(d, 0.88F), hn::Mul(cosine, cosine), hn::Set(d, 0.12F))),
                                hn::Set(d, 6.0205999F));
    const auto average = [&](const float* t, const float* u) {
      return hn::Mul(hn::Add(hn::Add(hn::LoadU(d, t + c), hn::LoadU(d, t + c + 1)),
                             hn::Add(hn::LoadU(d, u + c), hn::LoadU(d, u + c + 1))),
                     quarter);
    };
    const auto ct = effects.texture ? average(top.ct, bottom.ct) : hn::Zero(d);
    const ChannelConstants& k = in.channels;
    const auto withCt = [&](const float* base, const float* perHu, IntVec channel) {
      return hn::MulAdd(hn::GatherIndex(d, perHu, channel), ct, hn::GatherIndex(d, base, channel));
    };
    const auto impedance = [&](IntVec channel) {
      const auto z = hn::GatherIndex(d, k.impedance, channel);
      return hn::MulAdd(hn::Mul(z, hn::GatherIndex(d, k.ctImpedancePerHU, channel)), ct, z);
    };
    spread.storeMixed(s0, s1, cells.sTop, c);
    spread.storeMixed(s2, s3, cells.sBottom, c);
    spread.store(cosine, cells.cosine, c);
    spread.store(facing, cells.facing_dB, c);
    spread.store(average(top.patch, bottom.patch), cells.patch, c);
    spread.store(withCt(k.echo_dB, k.ctEcho_dBperHU, pair.a), cells.echoA, c);
    spread.store(withCt(k.echo_dB, k.ctEcho_dBperHU, pair.b), cells.echoB, c);
    spread.store(hn::GatherIndex(d, k.loss_dB, pair.a), cells.lossA, c);
    spread.store(hn::GatherIndex(d, k.loss_dB, pair.b), cells.lossB, c);
    spread.store(impedance(pair.a), cells.impedanceA, c);
    spread.store(impedance(pair.b), cells.impedanceB, c);
    spread.store(average(top.inside, bottom.inside), cells.inside, c);
    spread.store(pair.a, cells.channelA, c);
    spread.store(pair.b, cells.channelB, c);
    const auto profile = hn::Mul(hn::Add(hn::Mul(pair.a, hn::Set(di, in.scene->field.channels)), pair.b),
                                 hn::Set(di, BoundaryProfiles::kEntries));
    spread.store(profile, cells.profile, c);
    nearest = hn::Min(nearest, hn::Min(hn::Min(hn::Abs(s0), hn::Abs(s1)), hn::Min(hn::Abs(s2), hn::Abs(s3))));
  }
  for (int l = 0; l < kBlockLines; ++l) {
    const int a = cells.channelA[l], bb = cells.channelB[l];
    present |= 1U << a | 1U << bb;
    const AcousticTissue &first = *in.channels.tissue[a], &second = *in.channels.tissue[bb];
    const bool vessel = (first.vessel || second.vessel) && !acousticallyEqual(first, second);
    cells.edgeLoss[l] = vessel && cells.cosine[l] < static_cast<float>(acoustics::kEdgeCosine) ? in.edgeLoss_dB : 0.0F;
  }
  cells.channelsPresent = present;
  // A cell is less than a millimetre: no sample of it is nearer to the boundary than its nearest corner by more.
  cells.nearBoundary = hn::GetLane(hn::MinOfLanes(d, nearest)) < static_cast<float>(BoundaryProfiles::kReach_mm) + 1;
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
