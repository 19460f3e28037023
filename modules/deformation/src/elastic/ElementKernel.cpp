// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "elastic/ElementKernel.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "elastic/Elements.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace insonate::elastic::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::CappedTag<float, 16>;
using V = hn::Vec<Tag>;

struct Corners {
  V x[4], z[4];
};

HWY_INLINE Corners cornersOf(const Nodes& nodes, std::size_t n, int columns) {
  const Tag d;
  Corners c;
  const std::size_t at[4] = {n, n + 1, n + 1 + columns, n + columns};
  for (int a = 0; a < 4; ++a) {
    c.x[a] = hn::LoadU(d, nodes.x.data() + at[a]);
    c.z[a] = hn::LoadU(d, nodes.z.data() + at[a]);
  }
  return c;
}

/// Converts a vector of corners given as x z x z ...
HWY_INLINE Corners cornersOf(const float* pairs, std::size_t n, int columns) {
  const Tag d;
  Corners c;
  const std::size_t at[4] = {n, n + 1, n + 1 + columns, n + columns};
  for (int a = 0; a < 4; ++a) hn::LoadInterleaved2(d, pairs + 2 * at[a], c.x[a], c.z[a]);
  return c;
}

/// Twice the area, from the diagonals.
HWY_INLINE V twiceArea(const Corners& c) {
  const V d1x = hn::Sub(c.x[2], c.x[0]), d1z = hn::Sub(c.z[2], c.z[0]);
  const V d2x = hn::Sub(c.x[3], c.x[1]), d2z = hn::Sub(c.z[3], c.z[1]);
  return hn::NegMulAdd(d1z, d2x, hn::Mul(d1x, d2z));
}

/// Derivative of the area with respect to the corners.
HWY_INLINE Corners areaGradient(const Corners& c) {
  const V half = hn::Set(Tag(), 0.5f);
  const V d1x = hn::Mul(half, hn::Sub(c.x[2], c.x[0])), d1z = hn::Mul(half, hn::Sub(c.z[2], c.z[0]));
  const V d2x = hn::Mul(half, hn::Sub(c.x[3], c.x[1])), d2z = hn::Mul(half, hn::Sub(c.z[3], c.z[1]));
  Corners g;
  g.x[0] = hn::Neg(d2z), g.z[0] = d2x;
  g.x[1] = d1z, g.z[1] = hn::Neg(d1x);
  g.x[2] = d2z, g.z[2] = hn::Neg(d2x);
  g.x[3] = hn::Neg(d1z), g.z[3] = d1x;
  return g;
}

HWY_INLINE V dotCorners(const Corners& a, const Corners& b) {
  V sum = hn::Mul(a.x[0], b.x[0]);
  sum = hn::MulAdd(a.z[0], b.z[0], sum);
  for (int k = 1; k < 4; ++k) sum = hn::MulAdd(a.z[k], b.z[k], hn::MulAdd(a.x[k], b.x[k], sum));
  return sum;
}

/// Pressure coefficient, and its derivative with respect to J.
struct Pressure {
  V value, slope;
};

HWY_INLINE Pressure pressureOf(const Elements& e, std::size_t n, V twice, V area) {
  const Tag d;
  const V j =
      hn::IfThenElse(hn::Gt(area, hn::Zero(d)), hn::Div(hn::Mul(hn::Set(d, 0.5f), twice), area), hn::Set(d, 1.0f));
  const V bulk = hn::LoadU(d, e.bulk.data() + n), shut = hn::LoadU(d, e.shut.data() + n);
  const V below = hn::Sub(j, hn::Set(d, Elements::kShutBelow));
  const auto closed = hn::Lt(below, hn::Zero(d));
  Pressure p;
  const V wider = hn::Sub(j, hn::Set(d, 1.0f));
  const V slope = hn::Add(bulk, hn::IfThenElseZero(hn::Gt(wider, hn::Zero(d)), hn::LoadU(d, e.hoop.data() + n)));
  p.value = hn::MulAdd(slope, wider, hn::LoadU(d, e.base.data() + n));
  p.value = hn::IfThenElse(closed, hn::MulAdd(shut, below, p.value), p.value);
  p.slope = hn::Add(slope, hn::IfThenElseZero(closed, shut));
  const V above = hn::Max(hn::Sub(j, hn::LoadU(d, e.fullAbove.data() + n)), hn::Zero(d));
  const V taut = hn::Mul(hn::LoadU(d, e.full.data() + n), above);
  p.value = hn::MulAdd(taut, above, p.value);
  p.slope = hn::MulAdd(hn::Set(d, 2.0f), taut, p.slope);
  return p;
}

HWY_INLINE V inverseArea(V area) {
  const Tag d;
  return hn::IfThenElseZero(hn::Gt(area, hn::Zero(d)), hn::Div(hn::Set(d, 1.0f), area));
}

HWY_INLINE void addTo(std::vector<float>& array, std::size_t n, V value) {
  const Tag d;
  hn::StoreU(hn::Add(hn::LoadU(d, array.data() + n), value), d, array.data() + n);
}

constexpr int kM[4][4] = {{0, 1, 2, 3}, {1, 4, 5, 6}, {2, 5, 7, 8}, {3, 6, 8, 9}};
/// 2 d2A / dx_a dz_b; the derivative by dz_a dx_b is its negative.
constexpr float kTwist[4][4] = {{0, 1, 0, -1}, {-1, 0, 1, 0}, {0, -1, 0, 1}, {1, 0, -1, 0}};

/// Storage place of the coupling of two corners: row node, block.
struct Place {
  int a, b, block;
};
constexpr Place kPlaces[] = {{0, 1, GridMatrix::East},  {3, 2, GridMatrix::East},      {0, 3, GridMatrix::South},
                             {1, 2, GridMatrix::South}, {0, 2, GridMatrix::SouthEast}, {1, 3, GridMatrix::SouthWest}};

void assembleTarget(const Elements& e, const Nodes& at, float caution, GridMatrix& matrix, std::vector<float>& force) {
  const Tag d;
  const std::size_t lanes = hn::Lanes(d);
  const std::size_t step[4] = {0, 1, std::size_t(e.columns) + 1, std::size_t(e.columns)};
  for (std::size_t n = 0; n < e.count(); n += lanes) {
    const Corners c = cornersOf(at, n, e.columns);
    const Corners g = areaGradient(c);
    const V area = hn::LoadU(d, e.area.data() + n);
    const Pressure p = pressureOf(e, n, twiceArea(c), area);
    const V kappa = hn::Mul(p.slope, inverseArea(area));
    V m[10];
    for (int k = 0; k < 10; ++k) m[k] = hn::LoadU(d, e.m[k].data() + n);
    const V most = caution > 0 ? hn::LoadU(d, e.mu.data() + n) : hn::Set(d, 1e30f);
    const V twist =
        hn::Mul(hn::Set(d, 0.5f), hn::Max(hn::Min(hn::LoadU(d, e.carried.data() + n), most), hn::Neg(most)));
    const V damped = hn::Set(d, 1 + caution);
    for (int a = 0; a < 4; ++a) {
      V fx = hn::Mul(p.value, g.x[a]), fz = hn::Mul(p.value, g.z[a]);
      for (int b = 0; b < 4; ++b) {
        fx = hn::MulAdd(m[kM[a][b]], c.x[b], fx);
        fz = hn::MulAdd(m[kM[a][b]], c.z[b], fz);
      }
      V oldX, oldZ;
      float* f = force.data() + 2 * (n + step[a]);
      hn::LoadInterleaved2(d, f, oldX, oldZ);
      hn::StoreInterleaved2(hn::Sub(oldX, fx), hn::Sub(oldZ, fz), d, f);
      const V kx = hn::Mul(kappa, g.x[a]);
      addTo(matrix.value[0], n + step[a], hn::MulAdd(kx, g.x[a], hn::Mul(damped, m[kM[a][a]])));
      addTo(matrix.value[1], n + step[a], hn::Mul(kx, g.z[a]));
      addTo(matrix.value[2], n + step[a], hn::MulAdd(hn::Mul(kappa, g.z[a]), g.z[a], hn::Mul(damped, m[kM[a][a]])));
    }
    for (const Place& place : kPlaces) {
      const V kx = hn::Mul(kappa, g.x[place.a]), kz = hn::Mul(kappa, g.z[place.a]);
      const V mm = hn::Mul(damped, m[kM[place.a][place.b]]);
      const V t = hn::Mul(twist, hn::Set(d, kTwist[place.a][place.b]));
      auto* v = &matrix.value[GridMatrix::first(place.block)];
      const std::size_t row = n + step[place.a];
      addTo(v[0], row, hn::MulAdd(kx, g.x[place.b], mm));
      addTo(v[1], row, hn::MulAdd(kx, g.z[place.b], t));
      addTo(v[2], row, hn::Sub(hn::Mul(kz, g.x[place.b]), t));
      addTo(v[3], row, hn::MulAdd(kz, g.z[place.b], mm));
    }
  }
}

void shapeTarget(const Nodes& rest, Elements& e) {
  const Tag d;
  constexpr float g = 0.57735026919f;
  constexpr float kGauss[4][2] = {{-g, -g}, {g, -g}, {g, g}, {-g, g}};
  constexpr float kSign[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  for (std::size_t n = 0; n < e.count(); n += hn::Lanes(d)) {
    const Corners c = cornersOf(rest, n, e.columns);
    const V stiffness = hn::LoadU(d, e.mu.data() + n);
    V m[10];
    for (V& v : m) v = hn::Zero(d);
    for (const auto& point : kGauss) {
      V xr = hn::Zero(d), xs = xr, zr = xr, zs = xr;
      float nr[4], ns[4];
      for (int a = 0; a < 4; ++a) {
        nr[a] = 0.25f * kSign[a][0] * (1 + kSign[a][1] * point[1]);
        ns[a] = 0.25f * kSign[a][1] * (1 + kSign[a][0] * point[0]);
        xr = hn::MulAdd(hn::Set(d, nr[a]), c.x[a], xr);
        xs = hn::MulAdd(hn::Set(d, ns[a]), c.x[a], xs);
        zr = hn::MulAdd(hn::Set(d, nr[a]), c.z[a], zr);
        zs = hn::MulAdd(hn::Set(d, ns[a]), c.z[a], zs);
      }
      const V det = hn::NegMulAdd(xs, zr, hn::Mul(xr, zs));
      const V weight = hn::Mul(stiffness, inverseArea(det));
      V gx[4], gz[4];
      for (int a = 0; a < 4; ++a) {
        gx[a] = hn::NegMulAdd(hn::Set(d, ns[a]), zr, hn::Mul(hn::Set(d, nr[a]), zs));
        gz[a] = hn::NegMulAdd(hn::Set(d, nr[a]), xs, hn::Mul(hn::Set(d, ns[a]), xr));
      }
      for (int a = 0; a < 4; ++a)
        for (int b = a; b < 4; ++b)
          m[kM[a][b]] = hn::MulAdd(weight, hn::MulAdd(gx[a], gx[b], hn::Mul(gz[a], gz[b])), m[kM[a][b]]);
    }
    for (int k = 0; k < 10; ++k) hn::StoreU(m[k], d, e.m[k].data() + n);
    const V area = hn::Mul(hn::Set(d, 0.5f), twiceArea(c));
    hn::StoreU(hn::IfThenElseZero(hn::Gt(stiffness, hn::Zero(d)), area), d, e.area.data() + n);
  }
}

float allowedTarget(const Elements& e, const Nodes& at, const std::vector<float>& step) {
  const Tag d;
  const V most = hn::Set(d, 0.6f);
  V share = hn::Set(d, 1.0f);
  for (std::size_t n = 0; n < e.count(); n += hn::Lanes(d)) {
    const Corners c = cornersOf(at, n, e.columns);
    const Corners u = cornersOf(step.data(), n, e.columns);
    const V before = hn::Mul(hn::Set(d, 0.5f), twiceArea(c));
    const V loss = hn::Neg(hn::MulAdd(hn::Set(d, 0.5f), twiceArea(u), dotCorners(areaGradient(c), u)));
    const V allowed = hn::Mul(most, before);
    const auto solid = hn::Gt(hn::LoadU(d, e.guarded.data() + n), hn::Zero(d));
    const auto tooMuch = hn::And(solid, hn::Gt(loss, allowed));
    share = hn::IfThenElse(tooMuch, hn::Min(share, hn::Div(allowed, loss)), share);
  }
  return hn::GetLane(hn::MinOfLanes(d, share));
}

void advanceTarget(Elements& e, Nodes& at, const std::vector<float>& step, float share) {
  const Tag d;
  const V s = hn::Set(d, share);
  for (std::size_t n = 0; n < e.count(); n += hn::Lanes(d)) {
    const Corners c = cornersOf(at, n, e.columns);
    const V area = hn::LoadU(d, e.area.data() + n);
    const Pressure p = pressureOf(e, n, twiceArea(c), area);
    const V change = dotCorners(areaGradient(c), cornersOf(step.data(), n, e.columns));
    const V slope = hn::Mul(p.slope, inverseArea(area));
    const V carried = hn::LoadU(d, e.carried.data() + n);
    const V whole = hn::MulAdd(slope, change, p.value);
    hn::StoreU(hn::MulAdd(s, hn::Sub(whole, carried), carried), d, e.carried.data() + n);
  }
  const std::size_t nodes = std::size_t(e.columns) * e.rows;
  for (std::size_t n = 0; n < nodes; ++n) {
    at.x[n] += share * step[2 * n];
    at.z[n] += share * step[2 * n + 1];
  }
}

}  // namespace insonate::elastic::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate::elastic {
HWY_EXPORT(shapeTarget);
HWY_EXPORT(assembleTarget);
HWY_EXPORT(allowedTarget);
HWY_EXPORT(advanceTarget);

void Elements::resize(int c, int r) {
  columns = c, rows = r;
  const std::size_t size = std::size_t(c) * r + GridMatrix::kPadding;
  for (auto& v : m) v.assign(size, 0.0f);
  for (auto* v : {&area, &mu, &bulk, &hoop, &shut, &full, &fullAbove, &guarded, &base, &carried}) v->assign(size, 0.0f);
}

void shapeElements(const Nodes& rest, Elements& elements) {
  HWY_DYNAMIC_DISPATCH(shapeTarget)(rest, elements);
}

void assemble(const Elements& elements, const Nodes& at, float caution, GridMatrix& matrix, std::vector<float>& force) {
  HWY_DYNAMIC_DISPATCH(assembleTarget)(elements, at, caution, matrix, force);
}

float allowedShare(const Elements& elements, const Nodes& at, const std::vector<float>& step) {
  return HWY_DYNAMIC_DISPATCH(allowedTarget)(elements, at, step);
}

void advance(Elements& elements, Nodes& at, const std::vector<float>& step, float share) {
  HWY_DYNAMIC_DISPATCH(advanceTarget)(elements, at, step, share);
}

}  // namespace insonate::elastic
#endif
