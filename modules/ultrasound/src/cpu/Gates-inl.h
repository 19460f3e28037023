// Computes the echo of one gate from all planes of a block of scanlines.
#if defined(INSONATE_CPU_GATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_GATES_INL_H_
#undef INSONATE_CPU_GATES_INL_H_
#else
#define INSONATE_CPU_GATES_INL_H_
#endif

#include "cpu/ApertureTransmission.h"
#include "cpu/Lanes-inl.h"
#include "cpu/Scatterers-inl.h"
#include "cpu/Shifts-inl.h"
#include "cpu/Texture-inl.h"
#include "cpu/TraceInput.h"
#include "model/Boundary.h"
#include "model/Impulse.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void startLines(const TraceInput& in, int firstLine, TraceBuffers& b, BlockEchoes& e,
                           ApertureTransmission& transmission) {
  const FramePlan& plan = *in.plan;
  std::copy_n(in.lineStrength.data() + firstLine, kBlockLines, b.reaching);
  std::copy_n(b.reaching, kBlockLines, transmission.contact(firstLine));
  for (int p = 0; p < plan.settings.elevationPlanes; ++p) {
    std::copy_n(b.reaching, kBlockLines, b.state[p].amplitude);
    std::fill_n(b.state[p].channel, kBlockLines, -1);
    std::fill_n(b.state[p].pair, kBlockLines, -1);
  }
  std::fill_n(e.gasGate, kBlockLines, kNoGasYet);
  std::fill_n(b.tissueSeen, kBlockLines, 0);
  std::fill_n(e.boundaries.get(), std::size_t(plan.gates) * kBlockLines, 0.0F);
}

/// Returns the points at the given ranges on the scanlines from the block's scanline `line` on, in the frame of the
/// arrays.
HWY_INLINE Point pointsOn(const RayArrays& rays, int line, GateVec range) {
  const GateTag d;
  const auto along = [&](const std::vector<float>& origin, const std::vector<float>& direction) {
    return hn::MulAdd(hn::LoadU(d, direction.data() + line), range, hn::LoadU(d, origin.data() + line));
  };
  return {along(rays.x, rays.dx), along(rays.y, rays.dy), along(rays.z, rays.dz)};
}

HWY_INLINE Point shifted(const Point& p, float x, float y, float z, float by) {
  const GateTag d;
  return {hn::Add(p.x, hn::Set(d, x * by)), hn::Add(p.y, hn::Set(d, y * by)), hn::Add(p.z, hn::Set(d, z * by))};
}

/// Returns the integral of the quadratic B-spline from minus infinity to x.
HWY_INLINE GateVec splineBefore(GateVec x) {
  const GateTag d;
  const auto a = hn::Min(hn::Abs(x), hn::Set(d, 1.5F)), left = hn::Sub(hn::Set(d, 1.5F), a);
  const auto inner =
      hn::MulAdd(a, hn::NegMulAdd(hn::Mul(a, a), hn::Set(d, 1.0F / 3), hn::Set(d, 0.75F)), hn::Set(d, 0.5F));
  const auto outer = hn::NegMulAdd(hn::Mul(left, hn::Mul(left, left)), hn::Set(d, 1.0F / 6), hn::Set(d, 1.0F));
  const auto right = hn::IfThenElse(hn::Lt(a, hn::Set(d, 0.5F)), inner, outer);
  return hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 1.0F), right), right);
}

/// SIMD version of Impulse: weights by which a boundary's echo is spread over gates.
struct ImpulseRow {
  int first, count;
  alignas(64) float weight[32];

  HWY_INLINE ImpulseRow(int gate, float fraction, float width) {
    const GateTag d;
    width =
        std::clamp(width, static_cast<float>(Impulse::kNarrowest_gates), static_cast<float>(Impulse::kWidest_gates));
    const float reach = width / 2 + 1.5F;
    const int before = static_cast<int>(std::ceil(fraction - reach));
    first = gate + before;
    count = static_cast<int>(std::floor(fraction + reach)) - before + 1;
    const auto half = hn::Set(d, width / 2), share = hn::Set(d, 1 / width);
    for (int k = 0; k < count; k += static_cast<int>(hn::Lanes(d))) {
      const auto off = hn::Add(hn::Iota(d, static_cast<float>(k)), hn::Set(d, static_cast<float>(before) - fraction));
      const auto covered = hn::Sub(splineBefore(hn::Add(off, half)), splineBefore(hn::Sub(off, half)));
      hn::Store(hn::Mul(covered, share), d, weight + k);
    }
  }
};

/// Values at the first gate behind a boundary, including the needle's shadow.
struct Crossing {
  int channel;
  float s, impedance, shadow_dB, patch;
};

/// Adds the echo and the loss of a boundary that scanline `l` crosses between the previous gate and this one. Crossings
/// are rare, so the code is scalar.
HWY_INLINE void crossBoundary(const TraceInput& in, int plane, int gate, int l, const Crossing& at, TraceBuffers& b,
                              BlockEchoes& e) {
  const auto& [channel, s, impedance, shadow_dB, patch] = at;
  const FramePlan& plan = *in.plan;
  TraceBuffers::LineState& state = b.state[plane];
  const TraceBuffers::CellRow& cells = b.cells[plane];
  const int above = state.channel[l];
  if (above == in.scene->field.backgroundChannel && plan.range_mm(gate - 1) < acoustics::kContactReach_mm)
    return;  // gel
  const float reflection = (impedance - state.impedance[l]) / (impedance + state.impedance[l]);
  const AcousticTissue &first = *in.channels[above].tissue, &second = *in.channels[channel].tissue;
  const AcousticTissue& surface = surfaceOf(first, second);
  if (plan.settings.effects.reflection && state.amplitude[l] > static_cast<float>(ApertureRays::kUnseen) &&
      reflection != 0) {
    const double roughness_dB = plan.settings.effects.texture ? roughnessGain_dB(surface, patch) : 0;
    const float gain_dB = static_cast<float>(acoustics::kReflectorGain_dB + roughness_dB) - shadow_dB;
    const float echo = state.amplitude[l] * std::exp2(gain_dB * kOctavesPerDecibel) * std::abs(reflection) *
                       specularLobe(first, second, cells.cosine[l]) *
                       static_cast<float>(plan.boundaryScale * plan.boundaryWeight[plane]);
    const bool samePair = state.pair[l] == cells.profile[l];
    const auto rough_gates =
        static_cast<float>(plan.settings.effects.texture ? roughnessDepth_mm(surface) / plan.gate_mm : 0);
    const ImpulseRow impulse(gate - 1, samePair ? state.s[l] / (state.s[l] - s) : 0.5F,
                             std::hypot(cells.spread[l], rough_gates));
    for (int o = 0; o < impulse.count; ++o)
      if (const int g = impulse.first + o; g >= 0 && g < plan.gates)
        e.boundaries[std::size_t(g) * kBlockLines + l] += impulse.weight[o] * echo;
  }
  if (plan.settings.effects.transmission) state.amplitude[l] *= std::max(1 - reflection * reflection, 1e-12F);
}

/// SIMD version of NeedleEchoes::shadow_dB(): returns the two-way loss by the needle's shadow at a gate.
HWY_INLINE GateVec shadowAt(const NeedleEchoes& needle, int plane, int line, int gate) {
  const GateTag d;
  const auto behind =
      hn::Sub(hn::Set(d, static_cast<float>(gate)), hn::LoadU(d, needle.shadowOnsets_gate(plane) + line));
  const auto share = hn::Min(hn::Max(behind, hn::Zero(d)), hn::Set(d, 1.0F));
  return hn::Mul(hn::LoadU(d, needle.shadowLosses_dB(plane) + line), share);
}

/// Finds the first gas behind tissue in the central plane; there reverberation starts.
HWY_INLINE void findGas(const TraceInput& in, int gate, bool gelPossible, TraceBuffers& b, BlockEchoes& e) {
  const GateTag d;
  const GateIntTag di;
  const GateUintTag du;
  const int central = in.plan->settings.elevationPlanes / 2;
  const auto gas = hn::Set(du, in.gasChannels), one = hn::Set(du, 1U);
  const auto background = hn::Set(di, gelPossible ? in.scene->field.backgroundChannel : -1);
  for (int l = 0; l < kBlockLines; l += static_cast<int>(hn::Lanes(d))) {
    const auto gasGate = hn::Load(di, e.gasGate + l);
    const auto open = hn::Eq(gasGate, hn::Set(di, kNoGasYet));
    if (hn::AllFalse(di, open)) continue;
    const auto inside = hn::RebindMask(di, hn::Ge(hn::Load(d, b.cells[central].inside + l), hn::Set(d, 0.99F)));
    const auto channel = hn::Load(di, b.state[central].channel + l);
    const auto isGas = hn::RebindMask(di, hn::Eq(hn::And(hn::Shr(gas, hn::BitCast(du, channel)), one), one));
    const auto here = hn::AndNot(hn::Eq(channel, background), isGas);
    const auto seen = hn::Load(di, b.tissueSeen + l);
    const auto starts = hn::And(here, hn::Ne(seen, hn::Zero(di)));
    const auto found = hn::IfThenElse(starts, hn::Set(di, gate), gasGate);
    hn::Store(hn::IfThenElse(open, hn::IfThenElse(inside, found, hn::Set(di, kNoGasEver)), gasGate), di, e.gasGate + l);
    hn::Store(hn::IfThenElse(here, seen, hn::Set(di, 1)), di, b.tissueSeen + l);
  }
}

template <int kLooks>
HWY_INLINE void traceGate(const TraceInput& in, int firstLine, int row, int gate, TraceBuffers& b, BlockEchoes& e,
                          float* passed) {
  const GateTag d;
  const GateIntTag di;
  const FramePlan& plan = *in.plan;
  const Effects& effects = plan.settings.effects;
  const int planes = plan.settings.elevationPlanes;
  const auto down = hn::Set(d, static_cast<float>(gate - row * plan.cellGates) / static_cast<float>(plan.cellGates));
  const auto range = hn::Set(d, static_cast<float>(plan.range_mm(gate)));
  const auto decay = hn::Set(d, in.contactDecay[plan.nodeRows + gate]);
  const bool gelPossible = plan.range_mm(gate) < acoustics::kContactReach_mm && in.scene->field.backgroundChannel >= 0;
  const auto background = hn::Set(di, in.scene->field.backgroundChannel);

  for (int l = 0; l < kBlockLines; l += static_cast<int>(hn::Lanes(d))) {
    GateVec sum[2 * kLooks];
    for (GateVec& v : sum) v = hn::Zero(d);
    auto offset = hn::Zero(d), left = hn::Zero(d), inPhase = hn::Zero(d);
    // Scattering is stored relative to the amplitude that reaches the gate, which only the aperture's rays determine.
    const auto overReaching = hn::Div(hn::Set(d, 1.0F), hn::Load(d, b.reaching + l));
    const int line = firstLine + l;
    const auto r = hn::MulAdd(hn::LoadU(d, in.lineGap_mm.data() + line), decay, range);
    auto x = hn::MulAdd(hn::LoadU(d, in.lines.dx.data() + line), r, hn::LoadU(d, in.lines.x.data() + line));
    Point onLattice = pointsOn(in.latticeLines, line, r);
    PlaneShifts<GateVec> shift{hn::Zero(d), hn::Zero(d)};
    if (in.displacement) {
      shift = gateShifts(b, row, l, down);
      x = carried(d, x, shift, in.patientAxes.lateral.x, in.patientAxes.axial.x);
      const auto &lateral = in.latticeAxes.lateral, &axial = in.latticeAxes.axial;
      onLattice = {carried(d, onLattice.x, shift, lateral.x, axial.x),
                   carried(d, onLattice.y, shift, lateral.y, axial.y),
                   carried(d, onLattice.z, shift, lateral.z, axial.z)};
    }
    for (int p = 0; p < planes; ++p) {
      const TraceBuffers::CellRow& cells = b.cells[p];
      TraceBuffers::LineState& state = b.state[p];
      const auto known = hn::Ge(hn::Load(d, cells.inside + l), hn::Set(d, 0.99F));
      hn::Store(hn::IfThenElseZero(known, hn::Load(d, state.amplitude + l)), d, state.amplitude + l);

      const auto sTop = hn::Load(d, cells.sTop + l);
      const auto s = hn::MulAdd(down, hn::Sub(hn::Load(d, cells.sBottom + l), sTop), sTop);
      const auto isA = hn::Ge(s, hn::Zero(d));
      const auto channel =
          hn::IfThenElse(hn::RebindMask(di, isA), hn::Load(di, cells.channelA + l), hn::Load(di, cells.channelB + l));
      const auto impedance = hn::IfThenElse(isA, hn::Load(d, cells.impedanceA + l), hn::Load(d, cells.impedanceB + l));
      const auto shadow = in.needle ? shadowAt(*in.needle, p, line, gate) : hn::Zero(d);
      const auto before = hn::Load(di, state.channel + l);
      const auto crossed = hn::AndNot(hn::Lt(before, hn::Zero(di)), hn::Ne(before, channel));
      if (!hn::AllFalse(di, crossed)) {
        alignas(64) std::int32_t ch[16];
        alignas(64) float sLane[16], zLane[16], shadowLane[16], patchLane[16];
        hn::Store(channel, di, ch), hn::Store(s, d, sLane), hn::Store(impedance, d, zLane);
        hn::Store(shadow, d, shadowLane);
        const auto patchTop = hn::Load(d, cells.patchTop + l);
        hn::Store(hn::MulAdd(down, hn::Sub(hn::Load(d, cells.patchBottom + l), patchTop), patchTop), d, patchLane);
        for (int i = 0; i < static_cast<int>(hn::Lanes(d)); ++i)
          if (state.channel[l + i] >= 0 && state.channel[l + i] != ch[i])
            crossBoundary(in, p, gate, l + i, {ch[i], sLane[i], zLane[i], shadowLane[i], patchLane[i]}, b, e);
      }
      hn::Store(channel, di, state.channel + l);
      hn::Store(hn::Load(di, cells.profile + l), di, state.pair + l);
      hn::Store(s, d, state.s + l);
      hn::Store(impedance, d, state.impedance + l);

      const auto echo = hn::IfThenElse(isA, hn::Load(d, cells.echoA + l), hn::Load(d, cells.echoB + l));
      const auto one = hn::Set(d, 1.0F);
      auto halfway = one;
      if (effects.attenuation) {
        halfway = hn::IfThenElse(isA, hn::Load(d, cells.halfwayA + l), hn::Load(d, cells.halfwayB + l));
        if (effects.edgeShadow && cells.nearBoundary) {
          const auto atEdge = hn::Lt(hn::Abs(s), hn::Set(d, static_cast<float>(acoustics::kEdgeReach_mm)));
          halfway = hn::Mul(halfway, hn::IfThenElse(atEdge, hn::Load(d, cells.halfwayEdge + l), one));
        }
      }
      const auto gel = hn::RebindMask(d, hn::Eq(channel, background));
      if (gelPossible) halfway = hn::IfThenElse(gel, one, halfway);
      const auto above = hn::Load(d, state.amplitude + l);
      auto level = hn::Mul(above, halfway);
      const auto faintest = hn::Min(above, hn::Set(d, static_cast<float>(ApertureRays::kFaintest)));
      const auto below = hn::Max(hn::Mul(level, halfway), faintest);
      hn::Store(below, d, state.amplitude + l);
      left = hn::MulAdd(below, hn::Set(d, static_cast<float>(plan.boundaryWeight[p])), left);
      if (in.needle && p == planes / 2) hn::Store(level, d, e.level.get() + std::size_t(gate) * kBlockLines + l);
      if (in.needle) level = hn::Mul(level, amplitudeOf(hn::Neg(shadow)));
      if (gelPossible) level = hn::IfThenZeroElse(gel, level);
      if (!effects.scattering || hn::AllTrue(d, hn::Le(level, hn::Zero(d)))) continue;

      const float off_mm = in.elevation_mm[std::size_t(p) * plan.gates + gate];
      Scattering here{echo, hn::Zero(d)};
      if (effects.texture) {
        const auto right = hn::Lt(x, hn::Set(d, static_cast<float>(in.scene->midline_mm) - in.elevationX * off_mm));
        addTexture(in, cells.channelsPresent, channel, right, line, r, in.displacement ? &shift : nullptr, off_mm,
                   here);
      }
      if (effects.layers && cells.nearBoundary) addLayers(in, cells, l, s, down, here);
      const auto amplitude = hn::Mul(hn::Mul(level, overReaching), amplitudeOf(here.echo_dB));
      const auto plane = hn::Set(d, static_cast<float>(plan.boundaryWeight[p]));
      inPhase = hn::MulAdd(hn::Mul(amplitude, plane), effects.speckle ? here.sheet : one, inPhase);
      const auto scale = hn::Set(d, in.scatterScale[std::size_t(p) * plan.gates + gate]);
      if (effects.speckle)
        addScatterers<kLooks>(
            in.latticeSeed,
            shifted(onLattice, in.latticeElevationX, in.latticeElevationY, in.latticeElevationZ, off_mm),
            hn::Mul(amplitude, scale), sum, offset);
    }
    left = hn::Max(left, hn::Set(d, static_cast<float>(ApertureRays::kFaintest)));
    hn::StoreU(hn::Mul(left, overReaching), d, passed + l);
    hn::Store(left, d, b.reaching + l);
    const auto inPhaseOffset = hn::Sub(inPhase, offset);
    for (int c = 0; c < 2 * kLooks; ++c)
      hn::Store(c % 2 == 0 ? hn::Add(sum[c], inPhaseOffset) : hn::Sub(sum[c], offset), d,
                e.echo.get() + (std::size_t(c) * plan.gates + gate) * kBlockLines + l);
  }
  if (effects.reverberation) findGas(in, gate, gelPossible, b, e);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
