// Undeformed positions of displaced tissue along the scanlines of a block.
#if defined(INSONATE_CPU_SHIFTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_SHIFTS_INL_H_
#undef INSONATE_CPU_SHIFTS_INL_H_
#else
#define INSONATE_CPU_SHIFTS_INL_H_
#endif

#include "cpu/Lanes-inl.h"
#include "cpu/TraceInput.h"
#include "model/PlaneShift.h"

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Shifts in the probe's plane, in mm, from displayed points to the rest positions of their tissue.
template <class V>
struct PlaneShifts {
  V x, z;
};

/// Returns, along one axis of the displacement's lattice, the low neighbor of a position and, in `fraction`, the
/// distance from this neighbor in steps.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> lowPoint(D d, V position_mm, double first_mm, double step_mm,
                                                         int points, V& fraction) {
  const hn::Rebind<std::int32_t, D> di;
  const auto perStep = hn::Set(d, static_cast<float>(1 / step_mm));
  const auto at = hn::Mul(hn::Sub(position_mm, hn::Set(d, static_cast<float>(first_mm))), perStep);
  const auto clamped = hn::Max(hn::Zero(d), hn::Min(at, hn::Set(d, static_cast<float>(points - 1))));
  const auto low = hn::Min(hn::ConvertTo(di, clamped), hn::Set(di, std::max(points - 2, 0)));
  fraction = hn::Sub(clamped, hn::ConvertTo(d, low));
  return low;
}

/// Returns the displacement (rest position minus displayed position) at points of the probe's plane by bilinear
/// interpolation in its lattice; see shiftAt() of model/PlaneShift.h.
template <class D, class V = hn::Vec<D>>
HWY_INLINE PlaneShifts<V> latticeShifts(D d, const PlaneDisplacement& displacement, V x_mm, V z_mm) {
  const hn::Rebind<std::int32_t, D> di;
  auto right = x_mm, down = z_mm;
  const auto i = lowPoint(d, x_mm, displacement.left_mm, displacement.step_mm, displacement.columns, right);
  const auto k = lowPoint(d, z_mm, displacement.top_mm, displacement.step_mm, displacement.rows, down);
  static_assert(sizeof(PlaneDisplacement::Shift) == 2 * sizeof(float));
  const auto* parts = &displacement.restFromDisplayed.front().x_mm;
  const auto corner = hn::ShiftLeft<1>(hn::Add(hn::Mul(k, hn::Set(di, displacement.columns)), i));
  const int toRight = displacement.columns > 1 ? 2 : 0, toBottom = displacement.rows > 1 ? 2 * displacement.columns : 0;
  const auto bilinear = [&](int part) {
    const auto at = [&](int step) { return hn::GatherIndex(d, parts, hn::Add(corner, hn::Set(di, part + step))); };
    const auto along = [&](int step) {
      const auto left = at(step);
      return hn::MulAdd(right, hn::Sub(at(step + toRight), left), left);
    };
    const auto top = along(0);
    return hn::MulAdd(down, hn::Sub(along(toBottom), top), top);
  };
  return {bilinear(0), bilinear(1)};
}

HWY_INLINE void computeShiftRow(const TraceInput& in, int firstLine, int nodeRow, TraceBuffers::ShiftRow& row) {
  const GateTag d;
  const FramePlan& plan = *in.plan;
  const int cellLines = plan.cellLines, firstColumn = firstLine / cellLines;
  const auto range = hn::Set(d, static_cast<float>(plan.range_mm(nodeRow * plan.cellGates)));
  const auto decay = hn::Set(d, in.contactDecay[nodeRow]);
  for (int c = 0; c <= kBlockLines / cellLines; c += static_cast<int>(hn::Lanes(d))) {
    const int column = firstColumn + c;
    const auto load = [&](const std::vector<float>& values) { return hn::LoadU(d, values.data() + column); };
    const auto r = hn::MulAdd(load(in.columnGap_mm), decay, range);
    const auto shift =
        latticeShifts(d, *in.displacement, hn::MulAdd(load(in.probeColumns.dx), r, load(in.probeColumns.x)),
                      hn::MulAdd(load(in.probeColumns.dz), r, load(in.probeColumns.z)));
    hn::Store(shift.x, d, row.columnX + c), hn::Store(shift.z, d, row.columnZ + c);
  }
  const auto spread = [&](const float* columns, float* lines) {
    for (int l = 0; l < kBlockLines; ++l) {
      const int c = l / cellLines;
      lines[l] = l % cellLines ? 0.5F * (columns[c] + columns[c + 1]) : columns[c];
    }
  };
  spread(row.columnX, row.lineX), spread(row.columnZ, row.lineZ);
}

/// Returns the displacement on the scanlines from the block's scanline `l` on, at the fraction `down` from one row of
/// nodes to the next.
HWY_INLINE PlaneShifts<GateVec> gateShifts(const TraceBuffers& b, int row, int l, GateVec down) {
  const GateTag d;
  const TraceBuffers::ShiftRow &top = b.shift[row & 1], &bottom = b.shift[(row + 1) & 1];
  const auto between = [&](const float* from, const float* to) {
    const auto above = hn::Load(d, from + l);
    return hn::MulAdd(down, hn::Sub(hn::Load(d, to + l), above), above);
  };
  return {between(top.lineX, bottom.lineX), between(top.lineZ, bottom.lineZ)};
}

/// Returns a coordinate after the displacement `by`; `lateral` and `axial` are the changes of the coordinate per mm of
/// displacement along the probe's axes.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V carried(D d, V coordinate, const PlaneShifts<V>& by, float lateral, float axial) {
  return hn::MulAdd(by.x, hn::Set(d, lateral), hn::MulAdd(by.z, hn::Set(d, axial), coordinate));
}

/// Returns the squared in-plane slope of a signed distance in undeformed tissue, computed from its slopes in displaced
/// tissue; see TissueLookup::inPlaneSlopeAtRest().
HWY_INLINE GateVec squaredSlopeAtRest(const TraceInput& in, const TraceBuffers& b, int firstLine, int row, int c,
                                      GateVec axial, GateVec lateral, GateVec perAxial, GateVec perLateral) {
  const GateTag d;
  const TraceBuffers::ShiftRow &top = b.shift[row & 1], &bottom = b.shift[(row + 1) & 1];
  const auto change = [&](const float* from, const float* fromToo, const float* to, const float* toToo, GateVec perMm) {
    const auto first = hn::Sub(hn::LoadU(d, to), hn::LoadU(d, from));
    return hn::Mul(hn::Add(first, hn::Sub(hn::LoadU(d, toToo), hn::LoadU(d, fromToo))), perMm);
  };
  const auto changes = [&](const float* t, const float* u, PlaneShifts<GateVec>& byAxial,
                           GateVec PlaneShifts<GateVec>::*part, PlaneShifts<GateVec>& byLateral) {
    byAxial.*part = change(t + c, t + c + 1, u + c, u + c + 1, perAxial);
    byLateral.*part = change(t + c, u + c, t + c + 1, u + c + 1, perLateral);
  };
  PlaneShifts<GateVec> byAxial, byLateral;
  changes(top.columnX, bottom.columnX, byAxial, &PlaneShifts<GateVec>::x, byLateral);
  changes(top.columnZ, bottom.columnZ, byAxial, &PlaneShifts<GateVec>::z, byLateral);
  const int column = firstLine / in.plan->cellLines + c;
  const auto beamX = hn::LoadU(d, in.probeColumns.dx.data() + column),
             beamZ = hn::LoadU(d, in.probeColumns.dz.data() + column), one = hn::Set(d, 1.0F);
  const auto alongBeam = [&](const auto& v) { return hn::MulAdd(beamX, v.x, hn::Mul(beamZ, v.z)); };
  const auto aside = [&](const auto& v) { return hn::MulSub(beamZ, v.x, hn::Mul(beamX, v.z)); };
  const auto aa = hn::Add(one, alongBeam(byAxial)), la = aside(byAxial), al = alongBeam(byLateral),
             ll = hn::Add(one, aside(byLateral));
  const auto volume = hn::Max(hn::MulSub(aa, ll, hn::Mul(la, al)), hn::Set(d, static_cast<float>(kLeastVolume)));
  const auto a = hn::Div(hn::MulSub(ll, axial, hn::Mul(la, lateral)), volume),
             l = hn::Div(hn::MulSub(aa, lateral, hn::Mul(al, axial)), volume);
  return hn::MulAdd(a, a, hn::Mul(l, l));
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
