#pragma once

#include <insonate/cases/CaseView.h>

#include <algorithm>

namespace insonate {

/// Tests whether a patient position lies in the body. The body consists of every labeled voxel or, if nothing is
/// labeled, of every voxel denser than air. Refers to the volumes, which must outlive the object.
class PatientBody {
 public:
  explicit PatientBody(const CaseView& patient)
      : patient_(patient),
        indexFromPatient_(patient.ct.geometry.indexFromPatient()),
        labeled_(std::ranges::any_of(patient.labels.voxels, [](std::uint8_t v) { return v != 0; })) {}

  bool contains(Vec3 p_mm) const {
    const Vec3 index = indexFromPatient_ * p_mm;
    if (labeled_) return sampleNearest(patient_.labels, index) != 0;
    constexpr int kBody_HU = -300;  // threshold between air and fat
    return inGrid(p_mm) && sampleLinear(patient_.ct, index) > kBody_HU;
  }
  bool inGrid(Vec3 p_mm) const {
    const Vec3 index = indexFromPatient_ * p_mm;
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= -0.5 && index[a] <= patient_.ct.geometry.size[a] - 0.5)) return false;
    return true;
  }
  /// Returns the width above which a gap of air along a ray counts as outside the patient. Without labels the width is
  /// larger, since the windpipe, up to 25 mm wide, cannot be distinguished from outside air.
  double outsideWidth_mm() const { return labeled_ ? 5 : 30; }

 private:
  const CaseView& patient_;
  Transform indexFromPatient_;
  bool labeled_;
};

}  // namespace insonate
