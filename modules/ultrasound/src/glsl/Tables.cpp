#include "glsl/Tables.h"

#include "glsl/Device.h"
#include "model/Boundary.h"
#include "model/PointEchoes.h"
#include "model/Reverberation.h"
#include "model/Scatterers.h"
#include "scene/TextureTiles.h"

#include <cmath>
#include <cstring>
#include <map>

namespace insonate::glsl {
namespace {

float f(double value) {
  return static_cast<float>(value);
}

/// A map to cells of a lattice, with the whole part of its offset separate: floats then hold places near the probe and
/// lose no precision far from the patient's origin.
void setRows(Transform cellFromProbe, double rounding, Rows& rows, Int4& base) {
  const Vec3 o = cellFromProbe.offset;
  const Vec3 whole{std::floor(o.x), std::floor(o.y), std::floor(o.z)};
  cellFromProbe.offset = o - whole + Vec3{rounding, rounding, rounding};
  rows = rowsOf(cellFromProbe);
  base = {static_cast<std::int32_t>(whole.x), static_cast<std::int32_t>(whole.y), static_cast<std::int32_t>(whole.z),
          0};
}

/// Offsets of a scene's words. Channels without a structure are at the end.
struct WordsOfScene {
  explicit WordsOfScene(const TissueField& field)
      : node((field.channels + 1) / 2),
        ct(field.distance.size() * node),
        profiles(ct + (field.distance.size() + 1) / 2) {}

  std::size_t node;  ///< words of one node
  std::size_t ct, profiles;
};

std::int32_t effectBits(const Effects& e) {
  std::int32_t bits = 0;
  const auto add = [&](bool on, EffectBit bit) { bits |= on ? bit : 0; };
  add(e.scattering, kScattering), add(e.reflection, kReflection), add(e.attenuation, kAttenuation);
  add(e.transmission, kTransmission), add(e.speckle, kSpeckle), add(e.layers, kLayers), add(e.texture, kTexture);
  add(e.edgeShadow, kEdgeShadow);
  return bits;
}

void setChannel(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe, int c,
                ChannelBlock& out) {
  const std::uint8_t label = scene.field.label[c];
  const AcousticTissue& tissue = scene.table.of(label);
  const double f_MHz = plan.settings.frequency_MHz;
  out.loss_dB = f(2 * tissue.attenuation_dBpcmMHz * std::pow(f_MHz, tissue.attenuationExponent) * plan.gate_mm / 10);
  out.echo_dB = f(tissue.echogenicity_dB), out.ctEcho_dBperHU = f(tissue.ctEchogenicity_dBper100HU / 100);
  out.impedance_MRayl = f(tissue.impedance_MRayl), out.ctImpedancePerHU = f(tissue.ctImpedancePer100HU / 100);
  out.textureStrength_dB = f(tissue.textureStrength_dB), out.roughness_dB = f(tissue.roughness_dB);
  out.specularExponent = f(tissue.specularExponent), out.specularDiffuse = f(tissue.specularDiffuse);
  out.tile = static_cast<std::int32_t>(tissue.texture);
  out.flags = (hasSheets(tissue.texture) ? kSheets : 0) | (tissue.gas ? kGas : 0) | (tissue.vessel ? kVessel : 0);
  out.grazed = 0;
  for (int other = 0; other < scene.field.channels; ++other) {
    const AcousticTissue& beside = scene.table.of(scene.field.label[other]);
    if ((tissue.vessel || beside.vessel) && !acousticallyEqual(tissue, beside)) out.grazed |= 1 << other;
  }
  for (int side = 0; side < 2; ++side) {
    const TextureFrame& frame = scene.textureFrames[label][side];
    setRows(frame.tileFromPatient * patientFromProbe, TextureTile::kRounding_voxels, out.tileFromProbe[side],
            out.tileBase[side]);
    const Vec3 thin = transposed(patientFromProbe.linear) * frame.thinAxis;
    out.thinAxis[side] = {f(thin.x), f(thin.y), f(thin.z), 0};
  }
}

void setSizes(const FramePlan& plan, FrameBlock& b) {
  const ImagingSettings& s = plan.settings;
  b.lines = plan.lines, b.gates = plan.gates, b.samples = plan.grid.samples();
  b.planes = s.elevationPlanes, b.stride = plan.stride, b.cellGates = plan.cellGates, b.cellLines = plan.cellLines;
  b.nodeRows = plan.nodeRows, b.nodeColumns = plan.nodeColumns;
  b.gate_mm = f(plan.gate_mm), b.spacingAtFace_mm = f(plan.grid.scanlineSpacing_mm(0));
  b.spacingPerMm = f(plan.grid.scanlineSpacing_mm(1) - plan.grid.scanlineSpacing_mm(0));
  b.planeSpacing_sd = f(plan.planeSpacing_sd), b.boundaryScale = f(plan.boundaryScale);
  b.edgeLoss_dB = f(2 * acoustics::kEdgeLoss_dBpcmMHz * s.frequency_MHz * plan.gate_mm / 10);
  b.effects = effectBits(s.effects), b.conforming = s.conformingContact ? 1 : 0;
  for (int p = 0; p < s.elevationPlanes; ++p)
    b.plane[p] = {f(plan.planeOffset_sd[p]), f(plan.scatterWeight[p]), f(plan.boundaryWeight[p]), 0};
  const std::array<int, kTiles> offsets = tileOffsets();
  for (int t = 0; t < kTiles; ++t) {
    const auto& size = (t < kTextureKinds ? textureTile(static_cast<Texture>(t)) : patchTile()).size;
    b.tile[t] = {offsets[t], size[0], size[1], size[2]};
  }
}

}  // namespace

Rows rowsOf(const Transform& t) {
  const auto& c = t.linear.column;
  return {Float4{f(c[0].x), f(c[1].x), f(c[2].x), f(t.offset.x)},
          Float4{f(c[0].y), f(c[1].y), f(c[2].y), f(t.offset.y)},
          Float4{f(c[0].z), f(c[1].z), f(c[2].z), f(t.offset.z)}};
}

PlanTables::PlanTables(const FramePlan& p, bool thesis) {
  setSizes(p, block);
  block.looks = thesis ? 1 : p.settings.looks, block.parts = thesis ? 1 : 2, block.clampSides = thesis ? 1 : 0;
  for (int line = 0; line < p.nodeColumns * p.cellLines; ++line) {
    const Vec3 origin = p.grid.origin(line), direction = p.grid.direction(line);
    plan.push_back({f(origin.x), f(origin.z), f(direction.x), f(direction.z)});
  }
  block.gateTable = static_cast<std::int32_t>(plan.size());
  for (int gate = 0; gate < p.gates; ++gate)
    plan.push_back(
        {f(p.elevationSd_mm[gate]), f(p.scatterScale[gate]), f(p.lateralRadius[gate]), f(p.aperture.cone_lines[gate])});

  kernels.assign(p.axialKernel.begin(), p.axialKernel.end());
  block.axialEntries = p.maxAxialRadius + 1;
  block.lateralKernel = static_cast<std::int32_t>(kernels.size()), block.lateralEntries = p.maxLateralRadius + 1;
  kernels.insert(kernels.end(), p.lateralKernel.begin(), p.lateralKernel.end());
  block.upsampleTable = static_cast<std::int32_t>(kernels.size());
  for (int phase = 0; phase < p.stride; ++phase) {
    const double gate = (phase + 0.5) / p.stride - 0.5, t = gate < 0 ? gate + 1 : gate;
    const CubicWeights cubic = cubicAt(t);
    // In the thesis style, rays go straight from gate to gate.
    const double straight[4] = {0, 1 - t, t, 0};
    for (int o = 0; o < 4; ++o) kernels.push_back(f(thesis ? straight[o] : cubic.weight[o]));
  }

  const Reverberation behindGas(p);
  for (int behind = 0; behind < p.gates; ++behind) {
    Float4 repeat;
    for (const Reverberation::Repeat& r : behindGas.at(behind)) {
      if (r.strength >= behindGas.rings())
        repeat.x = r.share;
      else
        repeat.y = r.share, repeat.z = f(r.strength), repeat.w = f(r.gatesAbove);
    }
    repeats.push_back(repeat);
  }
}

std::vector<std::int32_t> sceneWords(const AcousticScene::Impl& scene) {
  const TissueField& field = scene.field;
  const WordsOfScene at(field);
  const auto& profiles = scene.profiles.entries();
  std::vector<std::int32_t> words(at.profiles + profiles.size());
  for (std::size_t n = 0; n < field.distance.size(); ++n)
    std::memcpy(words.data() + n * at.node, field.distance[n].to, at.node * 4);
  std::memcpy(words.data() + at.ct, field.ctDeviation.data(), field.distance.size() * 2);
  std::memcpy(words.data() + at.profiles, profiles.data(), profiles.size() * 4);
  return words;
}

void setScene(const AcousticScene::Impl& scene, FrameBlock& block) {
  const TissueField& field = scene.field;
  const WordsOfScene at(field);
  block.ctWords = static_cast<std::int32_t>(at.ct), block.profileWords = static_cast<std::int32_t>(at.profiles);
  block.fieldSize = {field.size[0], field.size[1], field.size[2], static_cast<std::int32_t>(at.node)};
  block.channels = field.channels, block.backgroundChannel = field.backgroundChannel;
}

void setPose(const FramePlan& plan, const AcousticScene::Impl& scene, const Transform& patientFromProbe,
             FrameBlock& block) {
  block.nodeFromProbe = rowsOf(scene.field.nodeFromPatient * patientFromProbe);
  const ScattererLattice lattice(patientFromProbe.linear.column[1], plan.latticePitch_mm, plan.latticeElevationPitch_mm,
                                 plan.specklePattern);
  block.latticeSeed = static_cast<std::int32_t>(lattice.seed);
  setRows({lattice.latticeFromPatient * patientFromProbe.linear, lattice.latticeFromPatient * patientFromProbe.offset},
          0, block.latticeFromProbe, block.latticeBase);
  const double perMm = 1 / patchTile().voxel_mm.x;
  const Mat3 patches{{Vec3{perMm, 0, 0}, Vec3{0, perMm, 0}, Vec3{0, 0, perMm}}};
  setRows({patches * patientFromProbe.linear, patches * (patientFromProbe.offset - scene.textureOrigin_mm)},
          TextureTile::kRounding_voxels, block.patchFromProbe, block.patchBase);
  const auto& c = patientFromProbe.linear.column;
  block.fromMiddle[0] = {f(c[0].x), f(c[1].x), f(c[2].x), f(patientFromProbe.offset.x - scene.midline_mm)};
  block.fromMiddle[1] = {f(c[0].x), f(c[1].x), f(c[2].x), f(patientFromProbe.offset.x - scene.trachea_mm)};
  for (int channel = 0; channel < scene.field.channels; ++channel)
    setChannel(plan, scene, patientFromProbe, channel, block.channel[channel]);
}

Result<void> uploadDisplacement(const gpu::CurrentContext& current, const PlaneDisplacement& displacement,
                                FrameBlock& block, gpu::PairTexture& texture) {
  static_assert(sizeof(PlaneDisplacement::Shift) == 2 * sizeof(float));
  static const PlaneDisplacement atRest{
      .left_mm = 0, .top_mm = 0, .step_mm = 1, .columns = 1, .rows = 1, .restFromDisplayed = {{0, 0}}, .lung = {}};
  const PlaneDisplacement& d = displacement.empty() ? atRest : displacement;
  block.displacementColumns = d.columns, block.displacementRows = d.rows;
  block.displacementLeft_mm = f(d.left_mm), block.displacementTop_mm = f(d.top_mm);
  block.displacementStep_mm = f(d.step_mm);
  return texture.write(current, d.columns, d.rows,
                       std::span(&d.restFromDisplayed[0].x_mm, 2 * d.restFromDisplayed.size()));
}

std::vector<Float4> pointTable(const FramePlan& plan, const AcousticScene::Impl& scene,
                               const Transform& patientFromProbe, const PlaneDisplacement& displacement) {
  std::vector<Float4> table;
  if (scene.points.empty()) return table;
  std::map<std::pair<int, int>, float> sum;
  for (const PointEcho& echo : pointEchoes(plan, scene.points, patientFromProbe, displacement))
    sum[{echo.gate, echo.line}] += echo.amplitude;
  for (const auto& [at, amplitude] : sum) table.push_back({f(at.first), f(at.second), amplitude, 0});
  return table;
}

void setNeedle(const FramePlan& plan, const NeedleEchoes& needle, std::vector<float>& words) {
  const int planes = plan.settings.elevationPlanes;
  words.resize(std::size_t(4 + 2 * planes) * plan.lines);
  for (int plane = 0; plane < planes; ++plane)
    for (int line = 0; line < plan.lines; ++line) {
      float* shadow = words.data() + std::size_t(4) * plan.lines + 2 * (std::size_t(plane) * plan.lines + line);
      shadow[0] = needle.shadowOnsets_gate(plane)[line], shadow[1] = needle.shadowLosses_dB(plane)[line];
    }
  for (int line = 0; line < plan.lines; ++line) {
    const NeedleEchoes::Line& of = needle.line(line);
    float* head = words.data() + std::size_t(4) * line;
    head[0] = f(of.first), head[1] = f(of.end), head[2] = of.ring_gates, head[3] = f(double(words.size()));
    words.insert(words.end(), needle.amplitudes(line) + of.first, needle.amplitudes(line) + of.end);
  }
}

ThesisBlock thesisBlock(const FramePlan& plan, const thesis::ThesisPlan& thesis, const AcousticScene::Impl& scene,
                        const Transform& patientFromProbe) {
  ThesisBlock b{};
  b.mapRows = thesis.mapRows;
  b.noiseSeed = static_cast<std::int32_t>(thesis::noiseSeed(patientFromProbe, plan.settings.time_s));
  b.row_mm = f(thesis.row_mm), b.interface_mm = f(thesis.interface_mm), b.steepness_mm = f(thesis.steepness_mm);
  b.lossLength_mm = f(thesis.lossLength_mm), b.tailShare = f(thesis.tailShare);
  b.noiseAcross = f(thesis.noise.across), b.noiseDown = f(thesis.noise.down), b.depth_mm = f(plan.settings.depth_mm);
  const auto channels = thesis::channelAcoustics(plan.settings, scene);
  for (int c = 0; c < scene.field.channels; ++c) {
    const thesis::ChannelAcoustics& a = channels[c];
    b.medium[c] = {f(a.lnImpedance), f(a.lnImpedancePerHU), f(a.loss_dBpmm), f(a.echo_dB)};
    b.perHU[c] = {f(a.echo_dBperHU), 0, 0, 0};
  }
  return b;
}

}  // namespace insonate::glsl
