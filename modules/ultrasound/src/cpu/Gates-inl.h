// What all planes of a block of scanlines send back from one gate.
#if defined(INSONATE_CPU_GATES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_GATES_INL_H_
#undef INSONATE_CPU_GATES_INL_H_
#else
#define INSONATE_CPU_GATES_INL_H_
#endif

#include "cpu/TraceInput.h"
#include "model/Boundary.h"

#include <insonate/core/Hash.h>

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using GateTag = hn::CappedTag<float, 16>;
using GateIntTag = hn::Rebind<std::int32_t, GateTag>;
using GateUintTag = hn::Rebind<std::uint32_t, GateTag>;
using GateVec = hn::Vec<GateTag>;
using GateInt = hn::Vec<GateIntTag>;
using GateUint = hn::Vec<GateUintTag>;

inline constexpr float kSilent_dB = -150;  ///< nothing below this can be seen
inline constexpr float kLostLevel_dB = -1e9F;

HWY_INLINE void startLines(const TraceInput& in, int firstLine, TraceBuffers& b) {
  const FramePlan& plan = *in.plan;
  for (int p = 0; p < plan.settings.elevationPlanes; ++p)
    for (int l = 0; l < kBlockLines; ++l) {
      b.state[p].level_dB[l] = in.lineLevel_dB[firstLine + l];
      b.state[p].channel[l] = -1;
      b.state[p].pair[l] = -1;
    }
  std::fill_n(b.gasGate, kBlockLines, kNoGasYet);
  std::fill_n(b.tissueSeen, kBlockLines, 0);
  std::fill_n(b.echo.get(), std::size_t(2) * plan.settings.looks * plan.gates * kBlockLines, 0.0F);
}

/// 10^(dB / 20): 2^x with the fraction by its Taylor polynomial (relative error below 2e-6 on -0.5..0.5).
HWY_INLINE GateVec amplitudeOf(GateVec level_dB) {
  const GateTag d;
  const GateIntTag di;
  const auto x = hn::Max(hn::Mul(level_dB, hn::Set(d, 0.16609640474F)), hn::Set(d, -120.0F));
  const auto whole = hn::Round(x);
  const auto f = hn::Sub(x, whole);
  auto y = hn::Set(d, 1.3333558e-3F);
  y = hn::MulAdd(y, f, hn::Set(d, 9.6181291e-3F));
  y = hn::MulAdd(y, f, hn::Set(d, 5.5504109e-2F));
  y = hn::MulAdd(y, f, hn::Set(d, 0.24022651F));
  y = hn::MulAdd(y, f, hn::Set(d, 0.69314718F));
  y = hn::MulAdd(y, f, hn::Set(d, 1.0F));
  const auto power = hn::ShiftLeft<23>(hn::Add(hn::ConvertTo(di, whole), hn::Set(di, 127)));
  return hn::Mul(y, hn::BitCast(d, power));
}

HWY_INLINE GateUint hashLanes(GateUint x) {
  const GateUintTag du;
  x = hn::Xor(x, hn::ShiftRight<16>(x));
  x = hn::Mul(x, hn::Set(du, 0x21f0aaadU));
  x = hn::Xor(x, hn::ShiftRight<15>(x));
  x = hn::Mul(x, hn::Set(du, 0x735a2d97U));
  return hn::Xor(x, hn::ShiftRight<15>(x));
}

struct Point {
  GateVec x, y, z;
};

HWY_INLINE Point rotated(const FloatMatrix& m, const Point& p) {
  const GateTag d;
  const auto row = [&](float x, float y, float z) {
    return hn::MulAdd(hn::Set(d, x), p.x, hn::MulAdd(hn::Set(d, y), p.y, hn::Mul(hn::Set(d, z), p.z)));
  };
  return {row(m.xx, m.xy, m.xz), row(m.yx, m.yy, m.yz), row(m.zx, m.zy, m.zz)};
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

/// See scattererAmplitudes(): adds amplitude times {re, im} of each look to `sum`; p in the scatterers' lattice.
template <int kLooks>
HWY_INLINE void addScatterers(std::uint32_t latticeSeed, const Point& p, GateVec amplitude, GateVec* sum) {
  const GateTag d;
  const GateIntTag di;
  const GateUintTag du;
  const auto wx = hn::Floor(p.x), wy = hn::Floor(p.y), wz = hn::Floor(p.z);
  const auto fx = hn::Sub(p.x, wx), fy = hn::Sub(p.y, wy), fz = hn::Sub(p.z, wz);
  const auto key = [&](GateVec whole, std::uint32_t factor) {
    return hn::Mul(hn::BitCast(du, hn::ConvertTo(di, whole)), hn::Set(du, factor));
  };
  constexpr std::uint32_t kX = 0x8da6b343U, kY = 0xd8163841U, kZ = 0xcb1ab31fU;  // of hashNode()
  const auto x0 = key(wx, kX), y0 = key(wy, kY), z0 = hn::Xor(key(wz, kZ), hn::Zero(du));
  const auto x1 = hn::Add(x0, hn::Set(du, kX)), y1 = hn::Add(y0, hn::Set(du, kY)), z1 = hn::Add(z0, hn::Set(du, kZ));
  const auto seed = hn::Set(du, latticeSeed);

  const auto xy = hn::Ge(fx, fy), yz = hn::Ge(fy, fz), xz = hn::Ge(fx, fz);
  const auto firstX = hn::And(xy, xz), firstY = hn::AndNot(xy, yz);
  const auto lastX = hn::AndNot(hn::Or(xy, xz), hn::Eq(fx, fx)), lastY = hn::AndNot(yz, xy);
  const auto u = [&](auto mask) { return hn::RebindMask(du, mask); };
  const auto high = hn::Max(fx, hn::Max(fy, fz)), low = hn::Min(fx, hn::Min(fy, fz));
  const auto middle = hn::Max(hn::Min(fx, fy), hn::Min(hn::Max(fx, fy), fz));
  const GateVec weight[4] = {hn::Sub(hn::Set(d, 1.0F), high), hn::Sub(high, middle), hn::Sub(middle, low), low};

  const auto fX = u(firstX), fY = u(firstY), lX = u(lastX), lY = u(lastY);
  const GateUint h[4] = {hashLanes(hn::Xor(hn::Xor(x0, y0), hn::Xor(z0, seed))),
                         hashLanes(hn::Xor(hn::Xor(hn::IfThenElse(fX, x1, x0), hn::IfThenElse(fY, y1, y0)),
                                           hn::Xor(hn::IfThenElse(hn::Or(fX, fY), z0, z1), seed))),
                         hashLanes(hn::Xor(hn::Xor(hn::IfThenElse(lX, x0, x1), hn::IfThenElse(lY, y0, y1)),
                                           hn::Xor(hn::IfThenElse(hn::Or(lX, lY), z1, z0), seed))),
                         hashLanes(hn::Xor(hn::Xor(x1, y1), hn::Xor(z1, seed)))};

  auto power = hn::Mul(weight[0], weight[0]);
  for (int c = 1; c < 4; ++c) power = hn::MulAdd(weight[c], weight[c], power);
  const auto scale = hn::Div(hn::Mul(amplitude, hn::Set(d, static_cast<float>(kScattererUnit))), hn::Sqrt(power));
  const auto five = hn::Set(du, 31U);
  const auto mean = hn::Set(d, static_cast<float>(kScattererMean));
  const auto component = [&](auto bits) {
    constexpr int kShift = decltype(bits)::value;
    auto value = hn::Zero(d);
    for (int c = 0; c < 4; ++c)
      value =
          hn::MulAdd(weight[c], hn::ConvertTo(d, hn::BitCast(di, hn::And(hn::ShiftRight<kShift>(h[c]), five))), value);
    return hn::Sub(value, mean);
  };
  sum[0] = hn::MulAdd(scale, component(std::integral_constant<int, 0>{}), sum[0]);
  sum[1] = hn::MulAdd(scale, component(std::integral_constant<int, 5>{}), sum[1]);
  if constexpr (kLooks > 1) {
    sum[2] = hn::MulAdd(scale, component(std::integral_constant<int, 10>{}), sum[2]);
    sum[3] = hn::MulAdd(scale, component(std::integral_constant<int, 15>{}), sum[3]);
  }
  if constexpr (kLooks > 2) {
    sum[4] = hn::MulAdd(scale, component(std::integral_constant<int, 20>{}), sum[4]);
    sum[5] = hn::MulAdd(scale, component(std::integral_constant<int, 25>{}), sum[5]);
  }
}

/// Texture of one structure, -1..1, bright parts as far as the beam meets them squarely.
HWY_INLINE GateVec textureOf(const TextureTile& tile, const FloatMatrix& tileFromPatient, const Point& patient,
                             GateVec facing) {
  const GateTag d;
  const GateIntTag di;
  const Point t = rotated(tileFromPatient, patient);
  const auto index = [&](GateVec at, int size) {
    return hn::And(hn::ConvertTo(di, hn::Floor(at)), hn::Set(di, size - 1));
  };
  const auto voxel =
      hn::Add(hn::Mul(hn::Add(hn::Mul(index(t.y, tile.size[1]), hn::Set(di, tile.size[0])), index(t.x, tile.size[0])),
                      hn::Set(di, tile.size[2])),
              index(t.z, tile.size[2]));
  // Four voxels a word: fetch the word, move the voxel to the top, bring it down with its sign.
  const auto word =
      hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(tile.value.data()), hn::ShiftRight<2>(voxel));
  const auto up = hn::ShiftLeft<3>(hn::Sub(hn::Set(di, 3), hn::And(voxel, hn::Set(di, 3))));
  const auto byte = hn::ShiftRight<24>(hn::Shl(word, up));
  const auto value = hn::Mul(hn::ConvertTo(d, byte), hn::Set(d, 1.0F / 127));
  const auto lit = hn::Mul(value, hn::MulAdd(hn::Set(d, 0.8F), hn::Mul(facing, facing), hn::Set(d, 0.2F)));
  return hn::IfThenElse(hn::Gt(value, hn::Zero(d)), lit, value);
}

/// Scattering level and how much of it comes from sheets, which echo as one.
struct Scattering {
  GateVec echo_dB, sheet;
};

/// Adds the texture of each structure that the cells of this row name, where a lane lies in it.
HWY_INLINE void addTexture(const TraceInput& in, std::uint32_t present, GateInt channel, const Point& patient,
                           const Point& beam, Scattering& here) {
  const GateTag d;
  const GateIntTag di;
  const auto right = hn::Lt(patient.x, hn::Set(d, static_cast<float>(in.scene->midline_mm)));
  for (std::uint32_t left = present; left; left &= left - 1) {
    const int ch = __builtin_ctz(left);
    const ChannelConstants& structure = in.channels[ch];
    if (!structure.textured) continue;
    const auto mine = hn::RebindMask(d, hn::Eq(channel, hn::Set(di, ch)));
    if (hn::AllFalse(d, mine)) continue;
    for (int side = 0; side < 2; ++side) {
      const auto lanes = side == 0 ? hn::And(mine, right) : hn::AndNot(right, mine);
      if (hn::AllFalse(d, lanes)) continue;
      const ChannelConstants::Side& frame = structure.side[side];
      const auto facing =
          hn::MulAdd(beam.x, hn::Set(d, frame.thinX),
                     hn::MulAdd(beam.y, hn::Set(d, frame.thinY), hn::Mul(beam.z, hn::Set(d, frame.thinZ))));
      const auto value = hn::IfThenElseZero(lanes, textureOf(*structure.tile, frame.tileFromPatient, patient, facing));
      here.echo_dB = hn::MulAdd(value, hn::Set(d, structure.textureStrength_dB), here.echo_dB);
      if (structure.sheets) here.sheet = hn::Max(here.sheet, value);
    }
  }
}

/// Connective layers at the boundary take over from the tissue.
HWY_INLINE void addLayers(const TraceInput& in, const TraceBuffers::CellRow& cells, int l, GateVec s,
                          Scattering& here) {
  const GateTag d;
  const GateIntTag di;
  const auto scaled = hn::Floor(hn::Mul(s, hn::Set(d, static_cast<float>(1 / BoundaryProfiles::kStep_mm))));
  const auto entry = hn::Add(hn::ConvertTo(di, scaled), hn::Set(di, BoundaryProfiles::kEntries / 2));
  const auto inReach = hn::And(hn::Gt(entry, hn::Set(di, -1)), hn::Lt(entry, hn::Set(di, BoundaryProfiles::kEntries)));
  if (hn::AllFalse(di, inReach)) return;
  const auto index = hn::Add(hn::Load(di, cells.profile + l), hn::IfThenElseZero(inReach, entry));
  const auto packed =
      hn::GatherIndex(di, reinterpret_cast<const std::int32_t*>(in.scene->profiles.entries().data()), index);
  const auto byteMask = hn::Set(di, 255);
  const auto unit = hn::Set(d, 1.0F / 255);
  const auto toFloat = [&](GateInt v) { return hn::ConvertTo(d, hn::And(v, byteMask)); };
  const auto occupancy = hn::Mul(toFloat(packed), unit);
  const auto echo = hn::MulAdd(toFloat(hn::ShiftRight<8>(packed)), hn::Set(d, 0.25F), hn::Set(d, -32.0F));
  const auto anisotropy = hn::Mul(toFloat(hn::ShiftRight<16>(packed)), unit);
  const auto patchiness = hn::Mul(toFloat(hn::ShiftRight<24>(packed)), unit);
  const auto one = hn::Set(d, 1.0F);
  const auto presence =
      hn::Min(one, hn::Max(hn::Zero(d), hn::MulAdd(hn::Set(d, 0.9F), hn::Load(d, cells.patch + l), hn::Set(d, 0.5F))));
  const auto covered = hn::Mul(occupancy, hn::NegMulAdd(patchiness, hn::Sub(one, presence), one));
  const auto layer = hn::MulAdd(anisotropy, hn::Load(d, cells.facing_dB + l), echo);
  const auto coverHere = hn::IfThenElseZero(hn::RebindMask(d, inReach), covered);
  here.echo_dB = hn::MulAdd(coverHere, hn::Sub(layer, here.echo_dB), here.echo_dB);
  here.sheet = hn::MulAdd(coverHere, hn::Sub(anisotropy, here.sheet), here.sheet);
}

/// Echo and loss of the boundary that one scanline crosses between the last gate and this one. Rare, so scalar.
HWY_INLINE void crossBoundary(const TraceInput& in, int plane, int gate, int l, int channel, float s, float impedance,
                              TraceBuffers& b) {
  const FramePlan& plan = *in.plan;
  TraceBuffers::LineState& state = b.state[plane];
  const TraceBuffers::CellRow& cells = b.cells[plane];
  const int above = state.channel[l];
  if (above == in.scene->field.backgroundChannel && plan.range_mm(gate - 1) < acoustics::kContactReach_mm)
    return;  // gel
  const float reflection = (impedance - state.impedance[l]) / (impedance + state.impedance[l]);
  const AcousticTissue &first = *in.channels[above].tissue, &second = *in.channels[channel].tissue;
  if (plan.settings.effects.reflection && state.level_dB[l] > kSilent_dB && reflection != 0) {
    const double roughness_dB = plan.settings.effects.texture ? second.roughness_dB * cells.patch[l] : 0;
    const double echo = std::pow(10.0, (state.level_dB[l] + acoustics::kReflectorGain_dB + roughness_dB) / 20) *
                        std::abs(reflection) * specularLobe(first, second, cells.cosine[l]) * plan.boundaryScale *
                        plan.boundaryWeight[plane];
    const bool samePair = state.pair[l] == cells.profile[l];
    const ImpulseWeights w = impulseAt(samePair ? state.s[l] / (state.s[l] - s) : 0.5);
    for (int o = 0; o < 4; ++o)
      if (const int g = gate - 2 + o; g >= 0 && g < plan.gates)
        for (int look = 0; look < plan.settings.looks; ++look)
          b.echo[(std::size_t(2) * look * plan.gates + g) * kBlockLines + l] += static_cast<float>(w.weight[o] * echo);
  }
  if (plan.settings.effects.transmission)
    state.level_dB[l] += 20 * std::log10(std::max(1 - reflection * reflection, 1e-12F));
}

/// Gas behind tissue, in the central plane, starts the reverberation.
HWY_INLINE void findGas(const TraceInput& in, int gate, bool gelPossible, TraceBuffers& b) {
  const int central = in.plan->settings.elevationPlanes / 2;
  const TraceBuffers::CellRow& cells = b.cells[central];
  for (int l = 0; l < kBlockLines; ++l) {
    if (cells.inside[l] < 0.99F && b.gasGate[l] == kNoGasYet) b.gasGate[l] = kNoGasEver;
    if (b.gasGate[l] != kNoGasYet) continue;
    const int channel = b.state[central].channel[l];
    const bool gel = gelPossible && channel == in.scene->field.backgroundChannel;
    if (!in.channels[channel].gas || gel)
      b.tissueSeen[l] = 1;
    else if (b.tissueSeen[l])
      b.gasGate[l] = gate;
  }
}

template <int kLooks>
HWY_INLINE void traceGate(const TraceInput& in, int firstLine, int row, int gate, TraceBuffers& b) {
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
    const int line = firstLine + l;
    const auto r = hn::MulAdd(hn::LoadU(d, in.lineGap_mm.data() + line), decay, range);
    const Point beam{hn::LoadU(d, in.lines.dx.data() + line), hn::LoadU(d, in.lines.dy.data() + line),
                     hn::LoadU(d, in.lines.dz.data() + line)};
    const Point onPlane = pointsOn(in.lines, line, r), onLattice = pointsOn(in.latticeLines, line, r);
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
      const auto before = hn::Load(di, state.channel + l);
      const auto crossed = hn::AndNot(hn::Lt(before, hn::Zero(di)), hn::Ne(before, channel));
      if (!hn::AllFalse(di, crossed)) {
        alignas(64) std::int32_t ch[16];
        alignas(64) float sLane[16], zLane[16];
        hn::Store(channel, di, ch), hn::Store(s, d, sLane), hn::Store(impedance, d, zLane);
        for (int i = 0; i < static_cast<int>(hn::Lanes(d)); ++i)
          if (state.channel[l + i] >= 0 && state.channel[l + i] != ch[i])
            crossBoundary(in, p, gate, l + i, ch[i], sLane[i], zLane[i], b);
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
      auto level = hn::Load(d, state.level_dB + l);
      const auto gel = hn::RebindMask(d, hn::Eq(channel, background));
      if (gelPossible) loss = hn::IfThenZeroElse(gel, loss);
      hn::Store(hn::Sub(level, loss), d, state.level_dB + l);
      level = hn::NegMulAdd(loss, hn::Set(d, 0.5F), level);
      if (gelPossible) level = hn::IfThenElse(gel, hn::Set(d, kLostLevel_dB), level);
      if (!effects.scattering || hn::AllTrue(d, hn::Lt(level, hn::Set(d, kSilent_dB)))) continue;

      const float e = in.elevation_mm[std::size_t(p) * plan.gates + gate];
      Scattering here{echo, hn::Zero(d)};
      if (effects.texture)
        addTexture(in, cells.channelsPresent, channel, shifted(onPlane, in.elevationX, in.elevationY, in.elevationZ, e),
                   beam, here);
      if (effects.layers && cells.nearBoundary) addLayers(in, cells, l, s, here);
      const auto amplitude = amplitudeOf(hn::Add(level, here.echo_dB));
      const auto plane = hn::Set(d, static_cast<float>(plan.boundaryWeight[p]));
      const auto inPhase = hn::Mul(hn::Mul(amplitude, plane), effects.speckle ? here.sheet : hn::Set(d, 1.0F));
      for (int look = 0; look < kLooks; ++look) sum[2 * look] = hn::Add(sum[2 * look], inPhase);
      const auto scale = hn::Set(d, in.scatterScale[std::size_t(p) * plan.gates + gate]);
      if (effects.speckle)
        addScatterers<kLooks>(in.latticeSeed,
                              shifted(onLattice, in.latticeElevationX, in.latticeElevationY, in.latticeElevationZ, e),
                              hn::Mul(amplitude, scale), sum);
    }
    for (int c = 0; c < 2 * kLooks; ++c) {
      float* out = b.echo.get() + (std::size_t(c) * plan.gates + gate) * kBlockLines + l;
      hn::Store(hn::Add(sum[c], hn::Load(d, out)), d, out);
    }
  }
  if (effects.reverberation) findGas(in, gate, gelPossible, b);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
