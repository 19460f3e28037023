#include "model/Contact.h"

#include "model/PlaneShift.h"
#include "scene/FieldSampling.h"

#include <algorithm>
#include <cmath>

namespace insonate {

double tissueRange_mm(double range_mm, double gap_mm) {
  return range_mm + gap_mm * std::exp(-range_mm / acoustics::kContactDepth_mm);
}

double displayedRange_mm(double tissueRange_mm, double gap_mm) {
  double range_mm = tissueRange_mm;
  constexpr int kNewtonSteps = 8;  // the slope is at least 0.2
  for (int n = 0; n < kNewtonSteps; ++n) {
    const double drawn = gap_mm * std::exp(-range_mm / acoustics::kContactDepth_mm);
    range_mm =
        std::max(range_mm - (range_mm + drawn - tissueRange_mm) / (1 - drawn / acoustics::kContactDepth_mm), 0.0);
  }
  return range_mm;
}

Contact contactOf(const TissueField& field, const Transform& patientFromProbe, const PlaneDisplacement& displacement,
                  Vec3 origin_mm, Vec3 direction) {
  if (field.backgroundChannel < 0) return {};
  constexpr double kStep_mm = 0.5;
  const Vec3 patientOrigin_mm = patientFromProbe * origin_mm, patientDirection = patientFromProbe.linear * direction;
  // Distance from the outside; positive in the body.
  const auto depth = [&](double r_mm) {
    Vec3 rest = patientOrigin_mm + patientDirection * r_mm;
    if (!displacement.empty()) {
      const Vec3 seen = origin_mm + direction * r_mm;
      rest = rest + patientFromProbe.linear * shiftAt(displacement, seen.x, seen.z);
    }
    return sampleDistance(field, field.backgroundChannel, field.nodeFromPatient * rest);
  };
  const double atFace = depth(0);
  const double outward = atFace < 0 ? 1 : -1;
  double previous = atFace;
  for (double r = kStep_mm; r <= acoustics::kContactReach_mm; r += kStep_mm) {
    const double here = depth(outward * r);
    if ((here < 0) != (atFace < 0)) {
      const double gap = outward * (r - kStep_mm * here / (here - previous));
      const double far =
          (gap - acoustics::kPoorContact_mm) / (acoustics::kContactReach_mm - acoustics::kPoorContact_mm);
      const double lost = std::clamp(far, 0.0, 1.0);
      // A face deep in the body no longer moves tissue to itself; the motion decreases gradually, since the image would
      // tear otherwise.
      const double into = std::clamp((-gap / acoustics::kContactReach_mm - 2.0 / 3) * 3, 0.0, 1.0);
      return {gap * (1 - into * into * (3 - 2 * into)), 1 - lost * lost * (3 - 2 * lost)};
    }
    previous = here;
  }
  return {0, atFace < 0 ? 0.0 : 1.0};
}

}  // namespace insonate
