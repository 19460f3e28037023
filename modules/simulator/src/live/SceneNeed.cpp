#include "live/SceneNeed.h"

#include <insonate/ultrasound/FrameCost.h>

#include <algorithm>
#include <cmath>

namespace insonate::live {
namespace {

constexpr Region kEmptyRegion{{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

/// Bounding box of a box's corners after a transform.
Region boxOf(const Transform& targetFromSource, const Region& source) {
  Region box = kEmptyRegion;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 point;
    for (int a = 0; a < 3; ++a) point[a] = corner >> a & 1 ? source.high_mm[a] : source.low_mm[a];
    point = targetFromSource * point;
    for (int a = 0; a < 3; ++a) {
      box.low_mm[a] = std::min(box.low_mm[a], point[a]);
      box.high_mm[a] = std::max(box.high_mm[a], point[a]);
    }
  }
  return box;
}

Region grown(const Region& region, double margin_mm) {
  const Vec3 margin{margin_mm, margin_mm, margin_mm};
  return {region.low_mm - margin, region.high_mm + margin};
}

Region boundsOf(const VolumeGeometry& volume) {
  Region voxels{{-0.5, -0.5, -0.5}, {}};
  for (int a = 0; a < 3; ++a) voxels.high_mm[a] = volume.size[a] - 0.5;
  return boxOf(volume.patientFromIndex(), voxels);
}

}  // namespace

SceneNeed::SceneNeed(const ImagingSetup& setup, const VolumeGeometry& volume)
    : probe_mm_(sceneRegion(setup, Transform{})),
      volume_mm_(grown(boundsOf(volume), 1)),
      indexFromPatient_(volume.indexFromPatient()),
      size_(volume.size),
      detail_mm_(sceneDetail_mm(setup.probe, setup.settings)) {}

Region SceneNeed::whole(const Transform& patientFromProbe) const {
  return boxOf(patientFromProbe, probe_mm_);
}

Region SceneNeed::at(const Transform& patientFromProbe, double room_mm) const {
  Region need = grown(whole(patientFromProbe), room_mm);
  for (int a = 0; a < 3; ++a) {
    need.low_mm[a] = std::clamp(need.low_mm[a], volume_mm_.low_mm[a], volume_mm_.high_mm[a]);
    need.high_mm[a] = std::clamp(need.high_mm[a], volume_mm_.low_mm[a], volume_mm_.high_mm[a]);
  }
  return need;
}

bool SceneNeed::misses(const Transform& patientFromProbe) const {
  const Region index = boxOf(indexFromPatient_, whole(patientFromProbe));
  for (int a = 0; a < 3; ++a)
    if (!(index.high_mm[a] > -0.5) || !(index.low_mm[a] < size_[a] - 0.5)) return true;
  return false;
}

bool covers(const Region& outer, const Region& inner) {
  for (int a = 0; a < 3; ++a)
    if (inner.low_mm[a] < outer.low_mm[a] || inner.high_mm[a] > outer.high_mm[a]) return false;
  return true;
}

}  // namespace insonate::live
