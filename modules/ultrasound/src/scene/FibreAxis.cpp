#include "scene/FibreAxis.h"

#include <insonate/core/Transform.h>

#include <vector>

namespace insonate {

Vec3 fibreAxis(const LabelMap& labels, std::uint8_t label, double midline_mm, bool rightSide) {
  const Transform patientFromIndex = labels.geometry.patientFromIndex();
  const auto& size = labels.geometry.size;
  std::vector<Vec3> points;
  Vec3 mean;
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; j += 2)
      for (int i = 0; i < size[0]; i += 2) {
        if (labels.at(i, j, k) != label) continue;
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if ((p.x < midline_mm) != rightSide) continue;
        points.push_back(p);
        mean = mean + p;
      }
  if (points.size() < 20) return {0, 0, 1};
  mean = mean / static_cast<double>(points.size());
  Mat3 covariance{{Vec3{}, Vec3{}, Vec3{}}};
  for (const Vec3& p : points) {
    const Vec3 d = p - mean;
    for (int a = 0; a < 3; ++a) covariance.column[a] = covariance.column[a] + d * d[a];
  }
  // Power iteration: the long axis of a muscle is dominant, so that a few steps converge.
  Vec3 axis = normalized({0.1, 0.1, 1});
  for (int step = 0; step < 60; ++step) axis = normalized(covariance * axis);
  return axis.z < 0 ? -axis : axis;
}

}  // namespace insonate
