// Signed distances to every structure at one row of lattice nodes.
#if defined(INSONATE_CPU_NODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_NODES_INL_H_
#undef INSONATE_CPU_NODES_INL_H_
#else
#define INSONATE_CPU_NODES_INL_H_
#endif

#include "cpu/TraceInput.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Corner weights and offsets of the field's cell that holds a point; edge nodes continue outside.
struct FieldCorners {
  std::size_t offset[8];
  float weight[8];
  bool inside;
};

HWY_INLINE FieldCorners cornersAt(const TissueField& field, float x, float y, float z) {
  const float at[3] = {x, y, z};
  FieldCorners c;
  c.inside = true;
  std::size_t base = 0, step[3];
  float f[3];
  const std::size_t stride[3] = {1, std::size_t(field.size[0]), std::size_t(field.size[0]) * field.size[1]};
  for (int a = 0; a < 3; ++a) {
    const float last = static_cast<float>(field.size[a] - 1);
    c.inside &= at[a] >= -0.5F && at[a] <= last + 0.5F;
    const float v = std::clamp(at[a], 0.0F, last);
    const int low = std::min(static_cast<int>(v), std::max(field.size[a] - 2, 0));
    f[a] = v - static_cast<float>(low);
    base += low * stride[a];
    step[a] = field.size[a] > 1 ? stride[a] : 0;
  }
  for (int k = 0; k < 8; ++k) {
    c.offset[k] = base + (k & 1 ? step[0] : 0) + (k & 2 ? step[1] : 0) + (k & 4 ? step[2] : 0);
    c.weight[k] = (k & 1 ? f[0] : 1 - f[0]) * (k & 2 ? f[1] : 1 - f[1]) * (k & 4 ? f[2] : 1 - f[2]);
  }
  return c;
}

HWY_INLINE void computeNode(const TraceInput& in, float px, float py, float pz, int column,
                            TraceBuffers::NodeRow& row) {
  const TissueField& field = in.scene->field;
  const Transform& m = field.nodeFromPatient;
  const auto node = [&](double Vec3::*a) {
    return static_cast<float>(m.linear.column[0].*a) * px + static_cast<float>(m.linear.column[1].*a) * py +
           static_cast<float>(m.linear.column[2].*a) * pz + static_cast<float>(m.offset.*a);
  };
  const FieldCorners c = cornersAt(field, node(&Vec3::x), node(&Vec3::y), node(&Vec3::z));

  const hn::CappedTag<float, 8> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const hn::Rebind<std::int16_t, decltype(d)> d16;
  alignas(64) float sum[TissueField::kStride];
  for (int first = 0; first < field.channels; first += static_cast<int>(hn::Lanes(d))) {
    auto acc = hn::Zero(d);
    for (int k = 0; k < 8; ++k) {
      const auto raw = hn::LoadU(d16, field.distance.data() + c.offset[k] * TissueField::kStride + first);
      acc = hn::MulAdd(hn::ConvertTo(d, hn::PromoteTo(di, raw)), hn::Set(d, c.weight[k]), acc);
    }
    hn::Store(hn::Mul(acc, hn::Set(d, static_cast<float>(1 / TissueField::kUnitsPerMm))), d, sum + first);
  }
  for (int ch = 0; ch < field.channels; ++ch) row.distance[ch][column] = sum[ch];

  float ct = 0;
  if (in.channels.anyCt)
    for (int k = 0; k < 8; ++k) ct += c.weight[k] * static_cast<float>(field.ctDeviation[c.offset[k]]);
  row.ct[column] = ct;
  row.inside[column] = c.inside ? 1.0F : 0.0F;
  const TextureTile& patches = patchTile();
  const auto voxel = [&](float p, double size) { return static_cast<int>(std::floor(p / static_cast<float>(size))); };
  row.patch[column] = static_cast<float>(patches.at(voxel(px, patches.voxel_mm.x), voxel(py, patches.voxel_mm.y),
                                                    voxel(pz, patches.voxel_mm.z))) *
                      (1.0F / 32);
}

HWY_INLINE void computeNodeRow(const TraceInput& in, int firstLine, int plane, int nodeRow,
                               TraceBuffers::NodeRow& row) {
  const FramePlan& plan = *in.plan;
  const int gate = nodeRow * plan.cellGates;
  const int clamped = std::min(gate, plan.gates - 1);
  const auto range = static_cast<float>(plan.range_mm(gate));
  const float decay = in.contactDecay[nodeRow];
  const float e = in.elevation_mm[std::size_t(plane) * plan.gates + clamped];
  const auto ex = static_cast<float>(in.elevationAxis.x), ey = static_cast<float>(in.elevationAxis.y),
             ez = static_cast<float>(in.elevationAxis.z);
  const int firstColumn = firstLine / plan.cellLines;
  const int columns = kBlockLines / plan.cellLines + 1;
  for (int c = 0; c < columns; ++c) {
    const int column = std::min(firstColumn + c, plan.nodeColumns - 1);
    const float r = range + in.columnGap_mm[column] * decay;
    computeNode(in, in.columns.x[column] + in.columns.dx[column] * r + ex * e,
                in.columns.y[column] + in.columns.dy[column] * r + ey * e,
                in.columns.z[column] + in.columns.dz[column] * r + ez * e, c, row);
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
