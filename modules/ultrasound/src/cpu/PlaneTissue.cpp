// Compiled once for every instruction set (see foreach_target.h).
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cpu/PlaneTissue.cpp"
#include <hwy/foreach_target.h>
// Must follow foreach_target:
#include "cpu/Nodes-inl.h"
#include "scene/SceneData.h"

#include <insonate/tissue/Labels.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <hwy/highway.h>

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace insonate::cpu::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

inline constexpr int kBatch = 32;  ///< points at a time, whole vectors

/// Position of a batch of points in the field; beyond the last point, the last is repeated.
void placePoints(const TissueField& field, const FloatMatrix& m, Vec3 offset, std::span<const PlanePoint> points,
                 NodePlaces& places) {
  const GateTag d;
  alignas(64) float xs[kBatch], zs[kBatch];
  for (std::size_t n = 0; n < kBatch; ++n) {
    const PlanePoint& p = points[std::min(n, points.size() - 1)];
    xs[n] = p.x_mm, zs[n] = p.z_mm;
  }
  for (int c = 0; c < kBatch; c += static_cast<int>(hn::Lanes(d))) {
    const auto x = hn::Load(d, xs + c), z = hn::Load(d, zs + c);
    const auto node = [&](float mx, float mz, double o) {
      return hn::MulAdd(hn::Set(d, mx), x, hn::MulAdd(hn::Set(d, mz), z, hn::Set(d, static_cast<float>(o))));
    };
    auto fx = x, fy = x, fz = x, inside = x;
    const auto i = lowNode(d, node(m.xx, m.xz, offset.x), field.size[0], fx, inside);
    const auto j = lowNode(d, node(m.yx, m.yz, offset.y), field.size[1], fy, inside);
    const auto k = lowNode(d, node(m.zx, m.zz, offset.z), field.size[2], fz, inside);
    GateVec weight[8];
    storeCells(d, field, i, j, k, fx, fy, fz, c, places, weight);
  }
}

void samplePlaneTarget(const TissueField& field, const Transform& patientFromProbe, std::span<const PlanePoint> points,
                       PlaneSamples& tissue) {
  const Transform nodeFromProbe = field.nodeFromPatient * patientFromProbe;
  const FloatMatrix matrix(nodeFromProbe.linear);
  const CornerSteps steps(field);
  int artery = -1, vein = -1, bone = -1;
  for (int c = 0; c < field.channels; ++c) {
    if (field.label[c] == kArtery) artery = c;
    if (field.label[c] == kVein) vein = c;
    if (field.label[c] == kBone) bone = c;
  }
  alignas(64) float distance[TissueField::kStride];
  const auto to = [&](int channel) {
    return channel < 0 ? kPlaneReach_mm : std::clamp(distance[channel], -kPlaneReach_mm, kPlaneReach_mm);
  };
  NodePlaces places;
  for (std::size_t first = 0; first < points.size(); first += kBatch) {
    const auto batch = points.subspan(first, std::min<std::size_t>(kBatch, points.size() - first));
    placePoints(field, matrix, nodeFromProbe.offset, batch, places);
    for (std::size_t n = 0; n < batch.size(); ++n) {
      lookUpNode(field, steps, places, static_cast<int>(n), distance);
      const auto nearest = std::min_element(distance, distance + field.channels) - distance;
      const std::size_t at = first + n;
      tissue.label[at] = field.label[nearest];
      tissue.toArtery_mm[at] = to(artery), tissue.toVein_mm[at] = to(vein), tissue.toBone_mm[at] = to(bone);
      tissue.toSkin_mm[at] = -to(field.backgroundChannel);
    }
  }
}

}  // namespace insonate::cpu::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace insonate {
namespace cpu {
HWY_EXPORT(samplePlaneTarget);
}  // namespace cpu

static_assert(kPlaneReach_mm == TissueField::kReach_mm);

void samplePlane(const AcousticScene& scene, const Transform& patientFromProbe, std::span<const PlanePoint> points,
                 PlaneSamples& tissue) {
  tissue.label.resize(points.size());
  for (auto* distances : {&tissue.toArtery_mm, &tissue.toVein_mm, &tissue.toBone_mm, &tissue.toSkin_mm})
    distances->resize(points.size());
  using namespace cpu;
  HWY_DYNAMIC_DISPATCH(samplePlaneTarget)(scene.impl().field, patientFromProbe, points, tissue);
}

}  // namespace insonate
#endif
