// What all planes of a block of scanlines send back from one gate.
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

inline constexpr float kSilent_dB = -150;  ///< nothing below this can be seen
inline constexpr float kLostLevel_dB = -1e9F, kKnownLevel_dB = -1e6F;
inline constexpr float kFaintest_dB = -300;  ///< ApertureRays::kFaintest

HWY_INLINE void startLines(const TraceInput& in, int firstLine, TraceBuffers& b, BlockEchoes& e,
                           ApertureTransmission& transmission) {
  const FramePlan& plan = *in.plan;
  for (int p = 0; p < plan.settings.elevationPlanes; ++p)
    for (int l = 0; l < kBlockLines; ++l) {
      b.state[p].level_dB[l] = in.lineLevel_dB[firstLine + l];
      b.state[p].channel[l] = -1;
      b.state[p].pair[l] = -1;
    }
  for (int l = 0; l < kBlockLines; ++l) b.reaching[l] = std::exp2(in.lineLevel_dB[firstLine + l] * kOctavesPerDecibel);
  std::copy_n(b.reaching, kBlockLines, transmission.contact(firstLine));
  std::fill_n(e.gasGate, kBlockLines, kNoGasYet);
  std::fill_n(b.tissueSeen, kBlockLines, 0);
  std::fill_n(e.echo.get(), std::size_t(2) * plan.settings.looks * plan.gates * kBlockLines, 0.0F);
  std::fill_n(e.boundaries.get(), std::size_t(plan.gates) * kBlockLines, 0.0F);
}

/// Points on the scanlines from a block's l-th on, at these ranges, in the frame of the arrays.
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

/// Integral of the quadratic B-spline from the left.
HWY_INLINE GateVec splineBefore(GateVec x) {
  const GateTag d;
  const auto a = hn::Min(hn::Abs(x), hn::Set(d, 1.5F)), left = hn::Sub(hn::Set(d, 1.5F), a);
  const auto inner =
      hn::MulAdd(a, hn::NegMulAdd(hn::Mul(a, a), hn::Set(d, 1.0F / 3), hn::Set(d, 0.75F)), hn::Set(d, 0.5F));
  const auto outer = hn::NegMulAdd(hn::Mul(left, hn::Mul(left, left)), hn::Set(d, 1.0F / 6), hn::Set(d, 1.0F));
  const auto right = hn::IfThenElse(hn::Lt(a, hn::Set(d, 0.5F)), inner, outer);
  return hn::IfThenElse(hn::Lt(x, hn::Zero(d)), hn::Sub(hn::Set(d, 1.0F), right), right);
}

/// The same as Impulse, by vectors.
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

/// The first gate behind a boundary, and the needle's shadow there.
struct Crossing {
  int channel;
  float s, impedance, shadow_dB, patch;
};

/// Echo and loss of the boundary that one scanline crosses between the last gate and this one. Rare, so scalar.
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
  if (plan.settings.effects.reflection && state.level_dB[l] > kSilent_dB && reflection != 0) {
    const double roughness_dB = plan.settings.effects.texture ? roughnessGain_dB(second, patch) : 0;
    const float gain_dB =
        state.level_dB[l] - shadow_dB + static_cast<float>(acoustics::kReflectorGain_dB + roughness_dB);
    const float echo = std::exp2(gain_dB * kOctavesPerDecibel) * std::abs(reflection) *
                       specularLobe(first, second, cells.cosine[l]) *
                       static_cast<float>(plan.boundaryScale * plan.boundaryWeight[plane]);
    const bool samePair = state.pair[l] == cells.profile[l];
    const auto rough_gates =
        static_cast<float>(plan.settings.effects.texture ? roughnessDepth_mm(second) / plan.gate_mm : 0);
    const ImpulseRow impulse(gate - 1, samePair ? state.s[l] / (state.s[l] - s) : 0.5F,
                             std::hypot(cells.spread[l], rough_gates));
    for (int o = 0; o < impulse.count; ++o)
      if (const int g = impulse.first + o; g >= 0 && g < plan.gates)
        e.boundaries[std::size_t(g) * kBlockLines + l] += impulse.weight[o] * echo;
  }
  if (plan.settings.effects.transmission)
    state.level_dB[l] += std::log2(std::max(1 - reflection * reflection, 1e-12F)) / kOctavesPerDecibel;
}

/// NeedleEchoes::shadow_dB(), by vectors.
HWY_INLINE GateVec shadowAt(const NeedleEchoes& needle, int plane, int line, int gate) {
  const GateTag d;
  const auto behind =
      hn::Sub(hn::Set(d, static_cast<float>(gate)), hn::LoadU(d, needle.shadowOnsets_gate(plane) + line));
  const auto share = hn::Min(hn::Max(behind, hn::Zero(d)), hn::Set(d, 1.0F));
  return hn::Mul(hn::LoadU(d, needle.shadowLosses_dB(plane) + line), share);
}

/// Gas behind tissue, in the central plane, starts the reverberation.
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
    auto offset = hn::Zero(d), left = hn::Zero(d);
    const auto reaching = hn::Load(d, b.reaching + l);
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
      const auto lost = hn::Lt(hn::Load(d, cells.inside + l), hn::Set(d, 0.99F));
      hn::Store(hn::IfThenElse(lost, hn::Set(d, kLostLevel_dB), hn::Load(d, state.level_dB + l)), d,
                state.level_dB + l);

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

      auto loss = hn::IfThenElse(isA, hn::Load(d, cells.lossA + l), hn::Load(d, cells.lossB + l));
      auto echo = hn::IfThenElse(isA, hn::Load(d, cells.echoA + l), hn::Load(d, cells.echoB + l));
      if (effects.edgeShadow && cells.nearBoundary)
        loss = hn::Add(loss,
                       hn::IfThenElseZero(hn::Lt(hn::Abs(s), hn::Set(d, static_cast<float>(acoustics::kEdgeReach_mm))),
                                          hn::Load(d, cells.edgeLoss + l)));
      if (!effects.attenuation) loss = hn::Zero(d);
      const auto before_dB = hn::Load(d, state.level_dB + l);
      const auto unknown = hn::Lt(before_dB, hn::Set(d, kKnownLevel_dB));
      const auto faintest = hn::Set(d, kFaintest_dB);
      auto level = hn::IfThenElse(unknown, before_dB, hn::Max(before_dB, faintest));
      const auto gel = hn::RebindMask(d, hn::Eq(channel, background));
      if (gelPossible) loss = hn::IfThenZeroElse(gel, loss);
      const auto after_dB = hn::IfThenElse(unknown, level, hn::Max(hn::Sub(level, loss), faintest));
      hn::Store(after_dB, d, state.level_dB + l);
      left = hn::MulAdd(amplitudeOf(after_dB), hn::Set(d, static_cast<float>(plan.boundaryWeight[p])), left);
      level = hn::NegMulAdd(loss, hn::Set(d, 0.5F), level);
      if (in.needle && p == planes / 2) hn::Store(level, d, e.level_dB.get() + std::size_t(gate) * kBlockLines + l);
      level = hn::Sub(level, shadow);
      if (gelPossible) level = hn::IfThenElse(gel, hn::Set(d, kLostLevel_dB), level);
      if (!effects.scattering || hn::AllTrue(d, hn::Lt(level, hn::Set(d, kKnownLevel_dB)))) continue;

      const float off_mm = in.elevation_mm[std::size_t(p) * plan.gates + gate];
      Scattering here{echo, hn::Zero(d)};
      if (effects.texture) {
        const auto right = hn::Lt(x, hn::Set(d, static_cast<float>(in.scene->midline_mm) - in.elevationX * off_mm));
        addTexture(in, cells.channelsPresent, channel, right, line, r, in.displacement ? &shift : nullptr, off_mm,
                   here);
      }
      if (effects.layers && cells.nearBoundary) addLayers(in, cells, l, s, down, here);
      // Over what reaches the gate, which the aperture will tell.
      const auto amplitude = hn::Div(amplitudeOf(hn::Add(level, here.echo_dB)), reaching);
      const auto plane = hn::Set(d, static_cast<float>(plan.boundaryWeight[p]));
      const auto inPhase = hn::Mul(hn::Mul(amplitude, plane), effects.speckle ? here.sheet : hn::Set(d, 1.0F));
      for (int look = 0; look < kLooks; ++look) sum[2 * look] = hn::Add(sum[2 * look], inPhase);
      const auto scale = hn::Set(d, in.scatterScale[std::size_t(p) * plan.gates + gate]);
      if (effects.speckle)
        addScatterers<kLooks>(
            in.latticeSeed,
            shifted(onLattice, in.latticeElevationX, in.latticeElevationY, in.latticeElevationZ, off_mm),
            hn::Mul(amplitude, scale), sum, offset);
    }
    left = hn::Max(left, hn::Set(d, static_cast<float>(ApertureRays::kFaintest)));
    hn::StoreU(hn::Div(left, reaching), d, passed + l);
    hn::Store(left, d, b.reaching + l);
    for (int c = 0; c < 2 * kLooks; ++c) {
      float* out = e.echo.get() + (std::size_t(c) * plan.gates + gate) * kBlockLines + l;
      hn::Store(hn::Add(hn::Sub(sum[c], offset), hn::Load(d, out)), d, out);
    }
  }
  if (effects.reverberation) findGas(in, gate, gelPossible, b, e);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
