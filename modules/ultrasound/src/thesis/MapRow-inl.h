// Computes medium and boundaries at one map row, with SIMD across the columns; the formulas are those of
// ThesisModel.cpp.
#if defined(INSONATE_THESIS_MAP_ROW_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_THESIS_MAP_ROW_INL_H_
#undef INSONATE_THESIS_MAP_ROW_INL_H_
#else
#define INSONATE_THESIS_MAP_ROW_INL_H_
#endif

#include "model/PlaneShift.h"
#include "thesis/ThesisKernel.h"

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <algorithm>
#include <numbers>

HWY_BEFORE_NAMESPACE();
namespace insonate::thesis::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<float, 16>;
using Vec = hn::Vec<Tag>;

inline constexpr float kLnPerDecibel = static_cast<float>(std::numbers::ln10 / 20);
inline const float kReflectorGain = static_cast<float>(std::pow(10.0, kReflectorGain_dB / 20));

HWY_INLINE int columnsOf(const FramePlan& plan) {
  return kBlockLines / plan.cellLines + 1;
}

/// The eight corners of the tissue field's cell that contains a continuous node index: their offsets and interpolation
/// weights. Outside the field, nodes at the edge are repeated.
struct FieldCorners {
  std::size_t offset[8];
  float weight[8];
};

HWY_INLINE FieldCorners cornersAt(const TissueField& field, Vec3 node) {
  const std::size_t stride[3] = {1, std::size_t(field.size[0]), std::size_t(field.size[0]) * field.size[1]};
  std::size_t base = 0, step[3];
  float f[3];
  for (int a = 0; a < 3; ++a) {
    const double at = std::clamp(node[a], 0.0, field.size[a] - 1.0);
    const int low = std::min(static_cast<int>(at), std::max(field.size[a] - 2, 0));
    f[a] = static_cast<float>(at - low);
    base += low * stride[a];
    step[a] = field.size[a] > 1 ? stride[a] : 0;
  }
  FieldCorners c;
  for (int k = 0; k < 8; ++k) {
    c.offset[k] = base + (k & 1 ? step[0] : 0) + (k & 2 ? step[1] : 0) + (k & 4 ? step[2] : 0);
    c.weight[k] = (k & 1 ? f[0] : 1 - f[0]) * (k & 2 ? f[1] : 1 - f[1]) * (k & 4 ? f[2] : 1 - f[2]);
  }
  return c;
}

HWY_INLINE void sampleNode(const TissueField& field, Vec3 patient_mm, int column, KernelBuffers::NodeRow& row) {
  const Vec3 node = field.nodeFromPatient * patient_mm;
  const FieldCorners at = cornersAt(field, node);
  const hn::CappedTag<float, 8> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const hn::Rebind<std::int16_t, decltype(d)> d16;
  alignas(64) float sum[TissueField::kStride];
  for (int first = 0; first < field.channels; first += static_cast<int>(hn::Lanes(d))) {
    auto total = hn::Zero(d);
    for (int k = 0; k < 8; ++k) {
      const auto raw = hn::LoadU(d16, field.distance[at.offset[k]].to + first);
      total = hn::MulAdd(hn::ConvertTo(d, hn::PromoteTo(di, raw)), hn::Set(d, at.weight[k]), total);
    }
    hn::Store(hn::Mul(total, hn::Set(d, static_cast<float>(1 / TissueField::kUnitsPerMm))), d, sum + first);
  }
  for (int c = 0; c < field.channels; ++c) row.distance_mm[c][column] = sum[c];
  float ct = 0;
  for (int k = 0; k < 8; ++k) ct += at.weight[k] * static_cast<float>(field.ctDeviation[at.offset[k]]);
  row.ct_HU[column] = ct;
  row.beyond[column] = static_cast<float>(beyondLattice(field, node));
}

/// Computes the rest position minus the displayed position of the tissue at a row of nodes, patient frame, mm; the same
/// for all planes.
HWY_INLINE void shiftRow(const KernelInput& in, int firstLine, int nodeRow, Vec3* shifts) {
  const FramePlan& plan = *in.plan;
  const double range_mm = plan.range_mm(nodeRow * plan.cellGates);
  for (int c = 0; c < columnsOf(plan); ++c) {
    const int column = std::min(firstLine / plan.cellLines + c, plan.nodeColumns - 1);
    const Ray& ray = in.probeColumns[column];
    const Vec3 seen = ray.origin_mm + ray.direction * (range_mm + in.columnGap_mm[column] * in.contactDecay[nodeRow]);
    shifts[c] = in.patientFromProbe * shiftAt(*in.displacement, seen.x, seen.z);
  }
}

HWY_INLINE void sampleRow(const KernelInput& in, int firstLine, int plane, int nodeRow, KernelBuffers& b) {
  const FramePlan& plan = *in.plan;
  const TissueField& field = in.scene->field;
  KernelBuffers::NodeRow& row = b.nodes[plane][nodeRow % 3];
  Vec3* shifts = b.shifts[nodeRow % 3];
  if (in.displacement && plane == 0) shiftRow(in, firstLine, nodeRow, shifts);
  const double range_mm = plan.range_mm(nodeRow * plan.cellGates);
  const Vec3 elevation = in.elevationAxis * in.elevation_mm[std::size_t(plane) * plan.nodeRows + nodeRow];
  const int firstColumn = firstLine / plan.cellLines;
  for (int c = 0; c < columnsOf(plan); ++c) {
    const int column = std::min(firstColumn + c, plan.nodeColumns - 1);
    const double r = range_mm + in.columnGap_mm[column] * in.contactDecay[nodeRow];
    const Ray& ray = in.columns[column];
    const Vec3 seen = ray.origin_mm + ray.direction * r + elevation;
    sampleNode(field, in.displacement ? seen + shifts[c] : seen, c, row);
    // Tissue from beyond the scene reads as the outermost tissue of the scene.
    if (in.displacement && row.beyond[c] > 0)
      row.beyond[c] = std::min(row.beyond[c], static_cast<float>(beyondLattice(field, field.nodeFromPatient * seen)));
  }
}

HWY_INLINE Vec fadeOf(Vec t) {
  const Tag d;
  const auto poly = hn::MulAdd(t, hn::MulAdd(t, hn::Set(d, 6.0F), hn::Set(d, -15.0F)), hn::Set(d, 10.0F));
  return hn::Mul(hn::Mul(t, hn::Mul(t, t)), poly);
}

HWY_INLINE Vec fadeSlopeOf(Vec t) {
  const Tag d;
  const auto bump = hn::Mul(t, hn::Sub(hn::Set(d, 1.0F), t));
  return hn::Mul(hn::Set(d, 30.0F), hn::Mul(bump, bump));
}

HWY_INLINE Vec clampedToUnit(Vec t) {
  const Tag d;
  return hn::Min(hn::Max(t, hn::Zero(d)), hn::Set(d, 1.0F));
}

/// Rows of nodes from which a map row is computed: a map row lies on a row of nodes or midway between two. The value is
/// the mean of `here` and `next`, the slope the difference of `above` and `below`.
struct NodeRows {
  const KernelBuffers::NodeRow *here, *next, *above, *below;
  float perMm;  ///< factor that converts the difference between above and below to a slope per mm

  HWY_INLINE static Vec mean(const float* a, const float* b) {
    const Tag d;
    return hn::Mul(hn::Set(d, 0.5F), hn::Add(hn::Load(d, a), hn::Load(d, b)));
  }
  HWY_INLINE Vec slope(const float* aboveValue, const float* belowValue) const {
    const Tag d;
    return hn::Mul(hn::Sub(hn::Load(d, belowValue), hn::Load(d, aboveValue)), hn::Set(d, perMm));
  }
  HWY_INLINE Vec distance(int channel, int column) const {
    return mean(here->distance_mm[channel] + column, next->distance_mm[channel] + column);
  }
  HWY_INLINE Vec distanceSlope(int channel, int column) const {
    return slope(above->distance_mm[channel] + column, below->distance_mm[channel] + column);
  }
};

/// Mean of the two smallest signed distances at a node, and its slope along the beam.
struct Middle {
  Vec value, slope;
};

HWY_INLINE Middle middleOf(const NodeRows& rows, int column, int channels, int without) {
  const Tag d;
  auto first = hn::Set(d, 1e3F), second = first, firstSlope = hn::Zero(d), secondSlope = firstSlope;
  for (int c = 0; c < channels; ++c) {
    if (c == without) continue;
    const auto here = rows.distance(c, column), slope = rows.distanceSlope(c, column);
    const auto nearest = hn::Lt(here, first), near = hn::Lt(here, second);
    second = hn::IfThenElse(nearest, first, hn::Min(here, second));
    secondSlope = hn::IfThenElse(nearest, firstSlope, hn::IfThenElse(near, slope, secondSlope));
    first = hn::Min(here, first);
    firstSlope = hn::IfThenElse(nearest, slope, firstSlope);
  }
  const auto half = hn::Set(d, 0.5F);
  return {hn::Mul(half, hn::Add(first, second)), hn::Mul(half, hn::Add(firstSlope, secondSlope))};
}

/// Acoustic properties of the medium at a SIMD vector of nodes.
struct MediumLanes {
  Vec lnImpedanceSlope, loss_dBpmm, echo_dB;
};

HWY_INLINE MediumLanes mediumAt(const KernelInput& in, const NodeRows& rows, int column, int without) {
  const Tag d;
  const int channels = in.scene->field.channels;
  const Middle middle = middleOf(rows, column, channels, without);
  const auto perInterface = hn::Set(d, static_cast<float>(1 / in.thesis->interface_mm));
  const auto zero = hn::Zero(d);
  auto weight = zero, weightSlope = zero, lnZ = zero, lnZSlope = zero, perHU = zero, perHUSlope = zero;
  auto loss = zero, echo = zero, echoPerHU = zero;
  for (int c = 0; c < channels; ++c) {
    if (c == without) continue;
    const auto t =
        clampedToUnit(hn::NegMulAdd(hn::Sub(rows.distance(c, column), middle.value), perInterface, hn::Set(d, 0.5F)));
    if (hn::AllTrue(d, hn::Le(t, zero))) continue;
    const auto w = fadeOf(t);
    const auto ws =
        hn::Mul(hn::Mul(fadeSlopeOf(t), perInterface), hn::Sub(middle.slope, rows.distanceSlope(c, column)));
    const ChannelAcoustics& a = in.channels[c];
    const auto add = [&](Vec& sum, Vec factor, double constant) {
      sum = hn::MulAdd(factor, hn::Set(d, static_cast<float>(constant)), sum);
    };
    weight = hn::Add(weight, w), weightSlope = hn::Add(weightSlope, ws);
    add(lnZ, w, a.lnImpedance), add(lnZSlope, ws, a.lnImpedance);
    add(perHU, w, a.lnImpedancePerHU), add(perHUSlope, ws, a.lnImpedancePerHU);
    add(loss, w, a.loss_dBpmm), add(echo, w, a.echo_dB), add(echoPerHU, w, a.echo_dBperHU);
  }
  const auto scale = hn::Div(hn::Set(d, 1.0F), weight);
  const auto ct = NodeRows::mean(rows.here->ct_HU + column, rows.next->ct_HU + column);
  const auto ctSlope = rows.slope(rows.above->ct_HU + column, rows.below->ct_HU + column);
  const auto slopeOf = [&](Vec value, Vec slope) {
    return hn::Mul(hn::NegMulAdd(hn::Mul(value, scale), weightSlope, slope), scale);
  };
  auto slope = hn::MulAdd(slopeOf(perHU, perHUSlope), ct, slopeOf(lnZ, lnZSlope));
  slope = hn::MulAdd(hn::Mul(perHU, scale), ctSlope, slope);
  return {slope, hn::Mul(loss, scale), hn::Mul(hn::MulAdd(echoPerHU, ct, echo), scale)};
}

HWY_INLINE void mapRow(const KernelInput& in, const NodeRows& rows, double range_mm, KernelBuffers::MapRow& out) {
  const Tag d;
  const FramePlan& plan = *in.plan;
  const Effects& effects = plan.settings.effects;
  const TissueField& field = in.scene->field;
  const int gel = mayBeGel(range_mm) ? field.backgroundChannel : -1;
  const int without = field.channels > 1 ? gel : -1;
  const auto one = hn::Set(d, 1.0F);
  for (int column = 0; column < columnsOf(plan); column += static_cast<int>(hn::Lanes(d))) {
    const MediumLanes m = mediumAt(in, rows, column, without);
    const auto tissue = gel < 0 ? one
                                : fadeOf(clampedToUnit(hn::MulAdd(
                                      rows.distance(gel, column),
                                      hn::Set(d, static_cast<float>(1 / in.thesis->interface_mm)), hn::Set(d, 0.5F))));
    const auto beyond = NodeRows::mean(rows.here->beyond + column, rows.next->beyond + column);
    const auto seen = hn::Mul(tissue, hn::Sub(one, beyond));
    const auto artanh =
        hn::Mul(hn::Abs(m.lnImpedanceSlope), hn::Set(d, static_cast<float>(in.thesis->steepness_mm / 2)));
    const auto e = hn::Exp(d, hn::Mul(artanh, hn::Set(d, -2.0F)));
    auto loss = hn::MulAdd(beyond, hn::Set(d, static_cast<float>(kBeyondLoss_dBpmm)), hn::Mul(tissue, m.loss_dBpmm));
    if (effects.transmission) {
      const auto lnCosh = hn::Add(hn::Sub(artanh, hn::Set(d, std::numbers::ln2_v<float>)), hn::Log1p(d, e));
      const auto perLnCosh = static_cast<float>(40 / std::numbers::ln10 / in.thesis->lossLength_mm);
      loss = hn::MulAdd(hn::Mul(tissue, hn::Set(d, perLnCosh)), lnCosh, loss);
    }
    const auto reflection = hn::Div(hn::Sub(one, e), hn::Add(one, e));
    const auto echo = hn::Exp(d, hn::Mul(m.echo_dB, hn::Set(d, kLnPerDecibel)));
    hn::Store(loss, d, out.loss_dBpmm + column);
    hn::Store(hn::Mul(seen, hn::Mul(reflection, hn::Set(d, effects.reflection ? kReflectorGain : 0.0F))), d,
              out.reflection + column);
    hn::Store(effects.scattering ? hn::Mul(seen, echo) : hn::Zero(d), d, out.echo + column);
  }
}

/// Expands a map row from node columns to scanlines.
HWY_INLINE void spreadRow(const FramePlan& plan, const KernelBuffers::MapRow& columns, KernelBuffers::MapRow& lines) {
  const auto spread = [&](const float* from, float* to) {
    if (plan.cellLines == 1) {
      std::copy_n(from, kBlockLines, to);
    } else {
      for (int c = 0; c < kBlockLines / 2; ++c) to[2 * c] = from[c], to[2 * c + 1] = 0.5F * (from[c] + from[c + 1]);
    }
  };
  spread(columns.reflection, lines.reflection);
  spread(columns.loss_dBpmm, lines.loss_dBpmm);
  spread(columns.echo, lines.echo);
}

}  // namespace insonate::thesis::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
