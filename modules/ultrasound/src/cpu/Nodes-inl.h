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

/// Where the nodes of a row lie: the low corner of their cell of the field, and how far into it.
struct NodePlaces {
  alignas(64) std::int32_t corner[3][kMaxColumns];
  alignas(64) float fraction[3][kMaxColumns];
  alignas(64) std::int32_t patch[kMaxColumns];  ///< voxel of the patch tile
};

HWY_INLINE void placeNodes(const TraceInput& in, int firstColumn, int columns, float range, float decay,
                           float elevation, NodePlaces& places, TraceBuffers::NodeRow& row) {
  const hn::CappedTag<float, 16> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const FloatMatrix& m = in.nodeFromPatient;
  const TextureTile& tile = patchTile();
  const auto e = hn::Set(d, elevation), toVoxel = hn::Set(d, static_cast<float>(1 / tile.voxel_mm.x));
  for (int c = 0; c < columns; c += static_cast<int>(hn::Lanes(d))) {
    const std::size_t at = firstColumn + c;
    const auto r = hn::MulAdd(hn::LoadU(d, in.columnGap_mm.data() + at), hn::Set(d, decay), hn::Set(d, range));
    const auto along = [&](const std::vector<float>& origin, const std::vector<float>& direction, float axis) {
      return hn::MulAdd(hn::Set(d, axis), e,
                        hn::MulAdd(hn::LoadU(d, direction.data() + at), r, hn::LoadU(d, origin.data() + at)));
    };
    const auto x = along(in.columns.x, in.columns.dx, in.elevationX),
               y = along(in.columns.y, in.columns.dy, in.elevationY),
               z = along(in.columns.z, in.columns.dz, in.elevationZ);
    const auto node = [&](float mx, float my, float mz, float offset) {
      return hn::MulAdd(hn::Set(d, mx), x,
                        hn::MulAdd(hn::Set(d, my), y, hn::MulAdd(hn::Set(d, mz), z, hn::Set(d, offset))));
    };
    const decltype(x) index[3] = {node(m.xx, m.xy, m.xz, in.nodeOffsetX), node(m.yx, m.yy, m.yz, in.nodeOffsetY),
                                  node(m.zx, m.zy, m.zz, in.nodeOffsetZ)};
    auto inside = hn::Set(d, 1.0F);
    for (int a = 0; a < 3; ++a) {
      const int size = in.scene->field.size[a];
      const auto last = hn::Set(d, static_cast<float>(size - 1));
      const auto half = hn::Set(d, 0.5F);
      const auto within = hn::And(hn::Ge(index[a], hn::Neg(half)), hn::Le(index[a], hn::Add(last, half)));
      inside = hn::IfThenElseZero(within, inside);
      const auto clamped = hn::Max(hn::Zero(d), hn::Min(index[a], last));
      const auto low = hn::Min(hn::ConvertTo(di, clamped), hn::Set(di, std::max(size - 2, 0)));
      hn::Store(low, di, places.corner[a] + c);
      hn::Store(hn::Sub(clamped, hn::ConvertTo(d, low)), d, places.fraction[a] + c);
    }
    hn::Store(inside, d, row.inside + c);
    const auto voxel = [&](decltype(x) p, int size) {
      return hn::And(hn::ConvertTo(di, hn::Floor(hn::Mul(p, toVoxel))), hn::Set(di, size - 1));
    };
    const auto vu = hn::Add(hn::Mul(voxel(y, tile.size[1]), hn::Set(di, tile.size[0])), voxel(x, tile.size[0]));
    hn::Store(hn::Add(hn::Mul(vu, hn::Set(di, tile.size[2])), voxel(z, tile.size[2])), di, places.patch + c);
  }
}

HWY_INLINE void lookUpNode(const TraceInput& in, const NodePlaces& places, int column, TraceBuffers::NodeRow& row) {
  const TissueField& field = in.scene->field;
  const float fx = places.fraction[0][column], fy = places.fraction[1][column], fz = places.fraction[2][column];
  const std::size_t base = field.offset(places.corner[0][column], places.corner[1][column], places.corner[2][column]);
  const std::size_t sx = field.size[0] > 1 ? 1 : 0, sy = field.size[1] > 1 ? field.size[0] : 0,
                    sz = field.size[2] > 1 ? std::size_t(field.size[0]) * field.size[1] : 0;
  const std::size_t offset[8] = {base,      base + sx,      base + sy,      base + sx + sy,
                                 base + sz, base + sx + sz, base + sy + sz, base + sx + sy + sz};
  const float y0 = (1 - fy) * (1 - fz), y1 = fy * (1 - fz), y2 = (1 - fy) * fz, y3 = fy * fz;
  const float weight[8] = {(1 - fx) * y0, fx * y0, (1 - fx) * y1, fx * y1,
                           (1 - fx) * y2, fx * y2, (1 - fx) * y3, fx * y3};
  const hn::CappedTag<float, 8> d;
  const hn::Rebind<std::int32_t, decltype(d)> di;
  const hn::Rebind<std::int16_t, decltype(d)> d16;
  alignas(64) float sum[TissueField::kStride];
  for (int first = 0; first < field.channels; first += static_cast<int>(hn::Lanes(d))) {
    auto acc = hn::Zero(d);
    for (int k = 0; k < 8; ++k) {
      const auto raw = hn::LoadU(d16, field.distance.data() + offset[k] * TissueField::kStride + first);
      acc = hn::MulAdd(hn::ConvertTo(d, hn::PromoteTo(di, raw)), hn::Set(d, weight[k]), acc);
    }
    hn::Store(hn::Mul(acc, hn::Set(d, static_cast<float>(1 / TissueField::kUnitsPerMm))), d, sum + first);
  }
  for (int ch = 0; ch < field.channels; ++ch) row.distance[ch][column] = sum[ch];
  float ct = 0;
  if (in.anyCt)
    for (int k = 0; k < 8; ++k) ct += weight[k] * static_cast<float>(field.ctDeviation[offset[k]]);
  row.ct[column] = ct;
  row.patch[column] = static_cast<float>(patchTile().value[places.patch[column]]) * (1.0F / 32);
}

/// Least and most distance of each channel in the row; columns past the end repeat the last.
HWY_INLINE void findExtremes(int channels, int columns, TraceBuffers::NodeRow& row) {
  const hn::CappedTag<float, 16> d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int ch = 0; ch < channels; ++ch) {
    float* at = row.distance[ch];
    for (int c = columns; c % lanes; ++c) at[c] = at[columns - 1];
    auto low = hn::Load(d, at), high = low;
    for (int c = lanes; c < columns; c += lanes) {
      low = hn::Min(low, hn::Load(d, at + c));
      high = hn::Max(high, hn::Load(d, at + c));
    }
    row.least[ch] = hn::GetLane(hn::MinOfLanes(d, low));
    row.most[ch] = hn::GetLane(hn::MaxOfLanes(d, high));
  }
}

HWY_INLINE void computeNodeRow(const TraceInput& in, int firstLine, int plane, int nodeRow,
                               TraceBuffers::NodeRow& row) {
  const FramePlan& plan = *in.plan;
  const int gate = nodeRow * plan.cellGates;
  const float elevation = in.elevation_mm[std::size_t(plane) * plan.gates + std::min(gate, plan.gates - 1)];
  const int columns = kBlockLines / plan.cellLines + 1;
  NodePlaces places;
  placeNodes(in, firstLine / plan.cellLines, columns, static_cast<float>(plan.range_mm(gate)), in.contactDecay[nodeRow],
             elevation, places, row);
  for (int c = 0; c < columns; ++c) lookUpNode(in, places, c, row);
  findExtremes(in.scene->field.channels, columns, row);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
