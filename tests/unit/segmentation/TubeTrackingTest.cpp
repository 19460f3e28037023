#include "ToolGrids.h"

#include <insonate/core/Hash.h>
#include <insonate/segmentation/TubeTracking.h>

#include <gmock/gmock.h>
#include <tbb/global_control.h>

namespace insonate {
namespace {

using test::difference;
using testing::HasSubstr;

/// A flat tube as dark as muscle that bends through the grid: fat on three sides, a brighter muscle behind a fascia of
/// 2 mm on the fourth.
class TubesOnGrids : public test::OnGrids {
 protected:
  static Vec3 middle(double z) { return {3 * std::sin(z / 14), 2 * std::cos(z / 11) - 1, z}; }
  /// 1 on the wall of the tube.
  static double level(Vec3 p, double halfWidth_mm, double halfHeight_mm) {
    const Vec3 off = p - middle(p.z);
    return std::hypot(off.x / halfWidth_mm, off.y / halfHeight_mm);
  }
  Selection tube(double halfWidth_mm, double halfHeight_mm) const {
    return shape([=](Vec3 p) { return std::abs(p.z) <= 14 && level(p, halfWidth_mm, halfHeight_mm) <= 1; });
  }
  CtVolume ct(double halfWidth_mm, double halfHeight_mm, double noise_HU) const {
    CtVolume ct(grid());
    const Selection blood = shape([=](Vec3 p) { return level(p, halfWidth_mm, halfHeight_mm) <= 1; });
    const Selection muscle = shape([=](Vec3 p) { return p.y - middle(p.z).y > halfHeight_mm + 2; });
    for (std::size_t v = 0; v < ct.voxels.size(); ++v) {
      const double u = unitInterval(hashNode(int(v), 1, 2, 3)) + unitInterval(hashNode(int(v), 5, 6, 7)) - 1;
      const double hu = blood.mask.voxels[v] ? 42 : muscle.mask.voxels[v] ? 57 : -20;
      ct.voxels[v] = static_cast<std::int16_t>(std::lround(hu + noise_HU * 2.45 * u));
    }
    return ct;
  }
  double dice(const Selection& a, const Selection& b) const {
    return 1 - double(difference(a, b)) / double(a.count() + b.count());
  }
  bool isCoarse() const {
    const Vec3& s = grid().spacing_mm;
    return std::max({s.x, s.y, s.z}) > 1.5;
  }
};
INSONATE_ON_GRIDS(TubesOnGrids);

TEST_P(TubesOnGrids, ThreeClicksAsideOfTheMiddleFindARoundVesselWithoutContrast) {
  const Vec3 aside{1, -0.7, 0};
  const auto tracked = trackTube(ct(5, 5, 10), std::array{middle(-14) + aside, middle(0) - aside, middle(14) + aside});
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_GT(dice(tracked->lumen, tube(5, 5)), isCoarse() ? 0.85 : 0.9);
  ASSERT_EQ(tracked->line.size(), tracked->outlines.size());
  for (const Vec3& p : tracked->line) EXPECT_LT(norm(p - middle(p.z)), 1.2);
  EXPECT_NEAR(tracked->outlines[tracked->outlines.size() / 2].area_mm2(), 78.5, isCoarse() ? 25 : 16) << "pi 5^2";
}

TEST_P(TubesOnGrids, AFlatOneIsFoundToItsEdges) {
  const auto tracked = trackTube(ct(9, 3.5, 10), std::array{middle(-14), middle(0), middle(14)});
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_GT(dice(tracked->lumen, tube(9, 3.5)), isCoarse() ? 0.8 : 0.88);
}

TEST_P(TubesOnGrids, StrongNoiseCostsLittle) {
  const auto tracked = trackTube(ct(5, 5, 20), std::array{middle(-14), middle(0), middle(14)});
  ASSERT_TRUE(tracked) << tracked.error().message;
  EXPECT_GT(dice(tracked->lumen, tube(5, 5)), isCoarse() ? 0.8 : 0.85) << "few slices to average where they are thick";
}

TEST(TubeTracking, IsTheSameOnOneThread) {
  CtVolume ct(test::toolGrids()[0].geometry, -50);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    if (v % 41 > 14 && v % 41 < 26) ct.voxels[v] = static_cast<std::int16_t>(40 + v % 7);
  const std::array clicks{Vec3{0, 0, -12}, Vec3{0, 0, 12}};
  const auto many = trackTube(ct, clicks);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const auto single = trackTube(ct, clicks);
  ASSERT_TRUE(many && single);
  EXPECT_EQ(many->lumen.mask.voxels, single->lumen.mask.voxels);
}

TEST(TubeTracking, SurvivesAnEvenCtAndClicksAtTheEdge) {
  const CtVolume ct(test::toolGrids()[1].geometry, 40);
  const auto tracked = trackTube(ct, std::array{Vec3{0, 0, -20}, Vec3{0, 0, 20}});
  ASSERT_TRUE(tracked) << tracked.error().message;
  for (const VesselOutline& outline : tracked->outlines) {
    EXPECT_TRUE(std::isfinite(norm(outline.center_mm)));
    for (const double radius_mm : outline.radius_mm) EXPECT_TRUE(std::isfinite(radius_mm));
  }
}

TEST(TubeTracking, RefusesOneClickClicksBesideTheCtAndStopsWhenAsked) {
  const CtVolume ct(test::toolGrids()[0].geometry);
  EXPECT_THAT(trackTube(ct, std::array{Vec3{}}).error().message, HasSubstr("at least two clicks"));
  EXPECT_THAT(trackTube(ct, std::array{Vec3{}, Vec3{0, 0, 500}}).error().message, HasSubstr("outside the CT"));
  const auto stopped =
      trackTube(ct, std::array{Vec3{}, Vec3{0, 0, 12}}, {}, [](std::string_view, double) { return false; });
  EXPECT_EQ(stopped.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
