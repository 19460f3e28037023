// Looks up signed distances to every structure at one row of lattice nodes.
#if defined(INSONATE_CPU_NODES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef INSONATE_CPU_NODES_INL_H_
#undef INSONATE_CPU_NODES_INL_H_
#else
#define INSONATE_CPU_NODES_INL_H_
#endif

#include "cpu/Lanes-inl.h"
#include "cpu/Shifts-inl.h"
#include "cpu/TraceInput.h"
#include "model/Boundary.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Positions of a row of lattice nodes in the tissue field: the low corner of the field's cell around each node, and
/// the weights of the cell's eight corners.
struct NodePlaces {
  alignas(64) std::int32_t corner[kMaxColumns];
  alignas(64) float weight[8][kMaxColumns];
};

/// Index steps from the low corner of a cell of the tissue field to each of its corners; zero along an axis with a
/// single node.
struct CornerSteps {
  std::int32_t step[8];
  explicit CornerSteps(const TissueField& field) {
    const std::int32_t x = field.size[0] > 1 ? 1 : 0, y = field.size[1] > 1 ? field.size[0] : 0,
                       z = field.size[2] > 1 ? field.size[0] * field.size[1] : 0;
    for (int k = 0; k < 8; ++k) step[k] = (k & 1 ? x : 0) + (k & 2 ? y : 0) + (k & 4 ? z : 0);
  }
};

/// Clamps a continuous index along one axis to the tissue field. Returns the low node and, in `fraction`, the distance
/// from the low node. Sets `inside` to zero outside the field.
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Vec<hn::Rebind<std::int32_t, D>> lowNode(D d, V index, int size, V& fraction, V& inside) {
  const hn::Rebind<std::int32_t, D> di;
  const auto last = hn::Set(d, static_cast<float>(size - 1)), half = hn::Set(d, 0.5F);
  const auto within = hn::And(hn::Ge(index, hn::Neg(half)), hn::Le(index, hn::Add(last, half)));
  inside = hn::IfThenElseZero(within, inside);
  const auto clamped = hn::Max(hn::Zero(d), hn::Min(index, last));
  const auto low = hn::Min(hn::ConvertTo(di, clamped), hn::Set(di, std::max(size - 2, 0)));
  fraction = hn::Sub(clamped, hn::ConvertTo(d, low));
  return low;
}

/// Stores in `places`, from column `c` on, the low corners of cells and the weights of their eight corners. The cells
/// are given by their low nodes i, j, k and by the points' fractions from these nodes. Returns the low corners, and the
/// weights also in `weight`.
template <class D, class VI, class V = hn::Vec<D>>
HWY_INLINE VI storeCells(D d, const TissueField& field, VI i, VI j, VI k, V fx, V fy, V fz, int c, NodePlaces& places,
                         V* weight) {
  const hn::Rebind<std::int32_t, D> di;
  const auto kj = hn::Add(hn::Mul(k, hn::Set(di, field.size[1])), j);
  const auto corner = hn::Add(hn::Mul(kj, hn::Set(di, field.size[0])), i);
  const auto one = hn::Set(d, 1.0F);
  const auto gx = hn::Sub(one, fx), gy = hn::Sub(one, fy), gz = hn::Sub(one, fz);
  const V yz[4] = {hn::Mul(gy, gz), hn::Mul(fy, gz), hn::Mul(gy, fz), hn::Mul(fy, fz)};
  for (int n = 0; n < 8; ++n) {
    weight[n] = hn::Mul(n & 1 ? fx : gx, yz[n / 2]);
    hn::Store(weight[n], d, places.weight[n] + c);
  }
  hn::Store(corner, di, places.corner + c);
  return corner;
}

/// SIMD version of TextureTile::between() for patchTile(), the tile of the variation along boundaries, in units of the
/// tile's SD.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V patchAt(D d, V x, V y, V z, Vec3 origin_mm, int step) {
  const hn::Rebind<std::int32_t, D> di;
  const TextureTile& tile = patchTile();
  const auto toVoxel = hn::Set(d, static_cast<float>(1 / tile.voxel_mm.x));
  const auto one = hn::Set(d, 1.0F);
  struct Axis {
    hn::Vec<decltype(di)> low, high;
    V share;
  };
  const auto along = [&](V p, double from_mm, int size) {
    const auto at = hn::Mul(hn::Sub(p, hn::Set(d, static_cast<float>(from_mm))), toVoxel);
    const auto floor = hn::Floor(at);
    const auto low = hn::Add(hn::ConvertTo(di, floor), hn::Set(di, step)), mask = hn::Set(di, size - 1);
    return Axis{hn::And(low, mask), hn::And(hn::Add(low, hn::Set(di, 1)), mask), hn::Sub(at, floor)};
  };
  const Axis u = along(x, origin_mm.x, tile.size[0]), v = along(y, origin_mm.y, tile.size[1]),
             w = along(z, origin_mm.z, tile.size[2]);
  const auto stepU = hn::Set(di, tile.stepU()), stepV = hn::Set(di, tile.stepV());
  auto sum = hn::Zero(d);
  for (int corner = 0; corner < 4; ++corner) {
    const auto row = hn::Add(hn::Mul(corner & 2 ? v.high : v.low, stepV), hn::Mul(corner & 1 ? u.high : u.low, stepU));
    const auto words = tileWords(tile, hn::Add(row, w.low));
    const auto low = hn::ConvertTo(d, byteOf<0>(words)), high = hn::ConvertTo(d, byteOf<1>(words));
    const auto weight =
        hn::Mul(corner & 1 ? u.share : hn::Sub(one, u.share), corner & 2 ? v.share : hn::Sub(one, v.share));
    sum = hn::MulAdd(weight, hn::MulAdd(w.share, hn::Sub(high, low), low), sum);
  }
  return hn::Mul(sum, hn::Set(d, 1.0F / 32));
}

/// Returns the interpolated deviation of the CT from the mean of each structure, HU.
template <class D, class VI>
HWY_INLINE hn::Vec<D> ctAt(D d, const TissueField& field, const CornerSteps& steps, VI corner,
                           const hn::Vec<D>* weight) {
  const hn::Rebind<std::int32_t, D> di;
  auto ct = hn::Zero(d);
  for (int k = 0; k < 8; ++k) {
    // The value has two bytes at an even offset. Loads four bytes, and shifts the lower two up and down again to extend
    // the sign.
    const auto offset = hn::ShiftLeft<1>(hn::Add(corner, hn::Set(di, steps.step[k])));
    const auto word = hn::GatherOffset(di, reinterpret_cast<const std::int32_t*>(field.ctDeviation.data()), offset);
    ct = hn::MulAdd(weight[k], hn::ConvertTo(d, hn::ShiftRight<16>(hn::ShiftLeft<16>(word))), ct);
  }
  return ct;
}

/// Place of a row of lattice nodes: its first column, its range from the face, and its distance from the central plane.
struct NodeRowPlace {
  int firstColumn;
  float range_mm, contactDecay, elevation_mm;
};

/// Computes position, texture and CT values of as many nodes as the tag has lanes, from the block's column c on.
template <class D>
HWY_INLINE void placeNodes(D d, const TraceInput& in, const CornerSteps& steps, const NodeRowPlace& at, int c,
                           const TraceBuffers::ShiftRow& shifts, NodePlaces& places, TraceBuffers::NodeRow& row) {
  using V = hn::Vec<D>;
  const hn::Rebind<std::int32_t, D> di;
  const FloatMatrix& m = in.nodeFromPatient;
  const TissueField& field = in.scene->field;
  const int column = at.firstColumn + c;
  const auto e = hn::Set(d, at.elevation_mm), one = hn::Set(d, 1.0F);
  const auto r =
      hn::MulAdd(hn::LoadU(d, in.columnGap_mm.data() + column), hn::Set(d, at.contactDecay), hn::Set(d, at.range_mm));
  const auto along = [&](const std::vector<float>& origin, const std::vector<float>& direction, float axis) {
    return hn::MulAdd(hn::Set(d, axis), e,
                      hn::MulAdd(hn::LoadU(d, direction.data() + column), r, hn::LoadU(d, origin.data() + column)));
  };
  auto x = along(in.columns.x, in.columns.dx, in.elevationX), y = along(in.columns.y, in.columns.dy, in.elevationY),
       z = along(in.columns.z, in.columns.dz, in.elevationZ);
  const auto node = [&](float mx, float my, float mz, float offset) {
    return hn::MulAdd(hn::Set(d, mx), x,
                      hn::MulAdd(hn::Set(d, my), y, hn::MulAdd(hn::Set(d, mz), z, hn::Set(d, offset))));
  };
  auto fx = one, fy = one, fz = one;
  hn::Vec<decltype(di)> i, j, k;
  const auto place = [&] {
    auto inside = one;
    i = lowNode(d, node(m.xx, m.xy, m.xz, in.nodeOffsetX), field.size[0], fx, inside);
    j = lowNode(d, node(m.yx, m.yy, m.yz, in.nodeOffsetY), field.size[1], fy, inside);
    k = lowNode(d, node(m.zx, m.zy, m.zz, in.nodeOffsetZ), field.size[2], fz, inside);
    return inside;
  };
  auto inside = place();
  if (in.displacement) {
    const PlaneShifts<V> by{hn::LoadU(d, shifts.columnX + c), hn::LoadU(d, shifts.columnZ + c)};
    const PlaneAxes& axes = in.patientAxes;
    x = carried(d, x, by, axes.lateral.x, axes.axial.x);
    y = carried(d, y, by, axes.lateral.y, axes.axial.y);
    z = carried(d, z, by, axes.lateral.z, axes.axial.z);
    inside = hn::Max(inside, place());  // tissue from beyond the scene reads as the outermost tissue of the scene
  }
  V weight[8];
  const auto corner = storeCells(d, field, i, j, k, fx, fy, fz, c, places, weight);
  hn::Store(inside, d, row.inside + c);
  const Vec3 origin_mm = in.scene->textureOrigin_mm;
  hn::Store(patchAt(d, x, y, z, origin_mm, 0), d, row.patch + c);
  const auto wander = hn::Set(d, static_cast<float>(kLayerWander_mm / BoundaryProfiles::kStep_mm));
  hn::Store(hn::Mul(patchAt(d, x, y, z, origin_mm, kWanderStep_voxels), wander), d, row.wander_steps + c);
  hn::Store(in.anyCt ? ctAt(d, field, steps, corner, weight) : hn::Zero(d), d, row.ct + c);
}

using NodeTag = hn::CappedTag<float, 16>;

/// Writes the distances of all channels at one node to `out`, [channel], in mm.
HWY_INLINE void lookUpNode(const TissueField& field, const CornerSteps& steps, const NodePlaces& places, int column,
                           float* HWY_RESTRICT out) {
  const NodeTag d;
  const hn::Rebind<std::int32_t, NodeTag> di;
  const hn::Rebind<std::int16_t, NodeTag> d16;
  const TissueField::Distances* base = field.distance.data() + places.corner[column];
  for (int first = 0; first < field.channels; first += static_cast<int>(hn::Lanes(d))) {
    const auto weighted = [&](int k, auto sum) {
      const auto raw = hn::LoadU(d16, base[steps.step[k]].to + first);
      return hn::MulAdd(hn::ConvertTo(d, hn::PromoteTo(di, raw)), hn::Set(d, places.weight[k][column]), sum);
    };
    // Two independent chains, so that no multiplication has to wait for the previous one.
    auto low = weighted(0, hn::Zero(d)), high = weighted(4, hn::Zero(d));
    for (int k = 1; k < 4; ++k) low = weighted(k, low), high = weighted(k + 4, high);
    hn::Store(hn::Mul(hn::Add(low, high), hn::Set(d, static_cast<float>(1 / TissueField::kUnitsPerMm))), d,
              out + first);
  }
}

/// Transposes the distances of four nodes, [node][channel], into the rows of the channels, from `column` on.
HWY_INLINE void storeFourNodes(const float (*nodes)[TissueField::kStride], int channels, int column,
                               TraceBuffers::NodeRow& row) {
#if HWY_TARGET == HWY_SCALAR
  for (int ch = 0; ch < channels; ++ch)
    for (int n = 0; n < 4; ++n) row.distance[ch][column + n] = nodes[n][ch];
#else
  const hn::Full128<float> d;
  for (int ch = 0; ch < channels; ch += 4) {
    const auto a = hn::Load(d, nodes[0] + ch), b = hn::Load(d, nodes[1] + ch), c = hn::Load(d, nodes[2] + ch),
               e = hn::Load(d, nodes[3] + ch);
    const auto ac02 = hn::InterleaveLower(d, a, c), be02 = hn::InterleaveLower(d, b, e);
    const auto ac13 = hn::InterleaveUpper(d, a, c), be13 = hn::InterleaveUpper(d, b, e);
    hn::Store(hn::InterleaveLower(d, ac02, be02), d, row.distance[ch] + column);
    hn::Store(hn::InterleaveUpper(d, ac02, be02), d, row.distance[ch + 1] + column);
    hn::Store(hn::InterleaveLower(d, ac13, be13), d, row.distance[ch + 2] + column);
    hn::Store(hn::InterleaveUpper(d, ac13, be13), d, row.distance[ch + 3] + column);
  }
#endif
}

/// Looks up the distances at all nodes of a row, four nodes at a time, and the minimum and maximum distance of each
/// channel. Beyond the last column, the last column is repeated.
HWY_INLINE void lookUpNodes(const TissueField& field, const CornerSteps& steps, const NodePlaces& places, int columns,
                            TraceBuffers::NodeRow& row) {
  const NodeTag d;
  const int channels = field.channels, lanes = static_cast<int>(hn::Lanes(d));
  alignas(64) float nodes[4][TissueField::kStride];
  for (int ch = 0; ch < channels; ch += lanes) {
    hn::Store(hn::Set(d, 1e30F), d, row.least + ch);
    hn::Store(hn::Set(d, -1e30F), d, row.most + ch);
  }
  for (int c = 0; c < columns; c += 4) {
    for (int n = 0; n < 4; ++n) lookUpNode(field, steps, places, std::min(c + n, columns - 1), nodes[n]);
    for (int ch = 0; ch < channels; ch += lanes) {
      const auto n0 = hn::Load(d, nodes[0] + ch), n1 = hn::Load(d, nodes[1] + ch), n2 = hn::Load(d, nodes[2] + ch),
                 n3 = hn::Load(d, nodes[3] + ch);
      hn::Store(hn::Min(hn::Min(hn::Min(n0, n1), hn::Min(n2, n3)), hn::Load(d, row.least + ch)), d, row.least + ch);
      hn::Store(hn::Max(hn::Max(hn::Max(n0, n1), hn::Max(n2, n3)), hn::Load(d, row.most + ch)), d, row.most + ch);
    }
    storeFourNodes(nodes, channels, c, row);
  }
}

HWY_INLINE void computeNodeRow(const TraceInput& in, int firstLine, int plane, int nodeRow,
                               const TraceBuffers::ShiftRow& shifts, TraceBuffers::NodeRow& row) {
  const FramePlan& plan = *in.plan;
  const TissueField& field = in.scene->field;
  const int gate = nodeRow * plan.cellGates;
  const float elevation = in.elevation_mm[std::size_t(plane) * plan.gates + std::min(gate, plan.gates - 1)];
  const int columns = kBlockLines / plan.cellLines + 1;
  const CornerSteps steps(field);
  const NodeRowPlace at{firstLine / plan.cellLines, static_cast<float>(plan.range_mm(gate)), in.contactDecay[nodeRow],
                        elevation};
  NodePlaces places;
  const NodeTag wide;
  const hn::CappedTag<float, 4> narrow;  // a block has one column more than a multiple of the vector length
  const int lanes = static_cast<int>(hn::Lanes(wide));
  int c = 0;
  for (; c + lanes <= columns; c += lanes) placeNodes(wide, in, steps, at, c, shifts, places, row);
  for (; c < columns; c += static_cast<int>(hn::Lanes(narrow)))
    placeNodes(narrow, in, steps, at, c, shifts, places, row);
  lookUpNodes(field, steps, places, columns, row);
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
