#include "elastic/InverseMap.h"
#include "support/NeckScene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace insonate::elastic {
namespace {

/// Height to which a band of tissue below an inclined line is compressed, as the lumen of a vein is under the probe.
constexpr float kBand_mm = 8, kCollapsed_mm = 0.05F, kTop_mm = 10, kSlope = 0.1F;

float topOf(float x_mm) {
  return kTop_mm + kSlope * x_mm;
}

/// In the image, a collapsed lumen is a line. It must not follow the rows of the displacement's lattice in steps.
TEST(InverseMap, ACollapsedLumenKeepsItsSlope) {
  const test::AnalyticPlane plane = test::neckScene();
  Mesh mesh;
  mesh.build(plane, {}, {});
  Nodes now = mesh.rest();
  for (std::size_t n = 0; n < now.z.size(); ++n) {
    const float within = std::clamp((now.z[n] - topOf(now.x[n])) / kBand_mm, 0.0F, 1.0F);
    now.z[n] -= (kBand_mm - kCollapsed_mm) * within;
  }
  std::vector<int> folded;
  PlaneDisplacement displacement;
  ASSERT_TRUE(invertMesh(mesh, now, {}, folded, displacement));
  for (float x_mm = -10; x_mm <= 10; x_mm += 0.3F) {
    double low_mm = topOf(x_mm) - 2, high_mm = topOf(x_mm) + 2;
    while (high_mm - low_mm > 0.001) {
      const double middle_mm = (low_mm + high_mm) / 2;
      const double rest_mm = middle_mm + shiftAt(displacement, x_mm, middle_mm).z;
      (rest_mm < topOf(x_mm) + kBand_mm / 2 ? low_mm : high_mm) = middle_mm;
    }
    EXPECT_NEAR(low_mm, topOf(x_mm) + kCollapsed_mm / 2, 0.13) << x_mm;
  }
}

}  // namespace
}  // namespace insonate::elastic
