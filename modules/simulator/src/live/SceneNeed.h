#pragma once

#include <insonate/simulator/Imager.h>

namespace insonate::live {

/// Computes the region that an acoustic scene must cover for images with a setup. Its size is computed once, so that
/// at() is fast.
class SceneNeed {
 public:
  SceneNeed(const ImagingSetup& setup, const VolumeGeometry& volume);

  /// Returns the region for an image at this pose, extended by `room_mm` on all sides and limited to the patient's
  /// volume plus a millimeter.
  Region at(const Transform& patientFromProbe, double room_mm = 0) const;
  /// Tells whether an image at this pose would lie entirely outside the patient's volume.
  bool misses(const Transform& patientFromProbe) const;
  double detail_mm() const { return detail_mm_; }

 private:
  Region whole(const Transform& patientFromProbe) const;

  Region probe_mm_;   ///< region of an image in the probe frame
  Region volume_mm_;  ///< bounds of the patient's volume, patient space
  Transform indexFromPatient_;
  std::array<int, 3> size_;
  double detail_mm_;
};

bool covers(const Region& outer, const Region& inner);

}  // namespace insonate::live
