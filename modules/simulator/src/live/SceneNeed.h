#pragma once

#include <insonate/simulator/Imager.h>

namespace insonate::live {

/// Region that a setup's frames need of a scene. The size is computed once, so that at() is cheap.
class SceneNeed {
 public:
  SceneNeed(const ImagingSetup& setup, const VolumeGeometry& volume);

  /// Region of a frame at this pose, with `room_mm` added on all sides, limited to the patient's volume plus a
  /// millimeter, which is as far as a scene reaches.
  Region at(const Transform& patientFromProbe, double room_mm = 0) const;
  /// Tells whether a frame at this pose would lie entirely outside the volume.
  bool misses(const Transform& patientFromProbe) const;
  double detail_mm() const { return detail_mm_; }

 private:
  Region whole(const Transform& patientFromProbe) const;

  Region probe_mm_;   ///< probe frame
  Region volume_mm_;  ///< patient frame
  Transform indexFromPatient_;
  std::array<int, 3> size_;
  double detail_mm_;
};

bool covers(const Region& outer, const Region& inner);

}  // namespace insonate::live
