#include "ToolGrids.h"

#include <insonate/core/Hash.h>
#include <insonate/segmentation/Brush.h>
#include <insonate/segmentation/Logical.h>
#include <insonate/segmentation/Polygon.h>
#include <insonate/segmentation/Threshold.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using test::difference;
using testing::HasSubstr;

class BrushOnGrids : public test::OnGrids {};
class PolygonOnGrids : public test::OnGrids {};
INSONATE_ON_GRIDS(BrushOnGrids);
INSONATE_ON_GRIDS(PolygonOnGrids);

CtVolume noisyCt(const VolumeGeometry& g) {
  CtVolume ct(g);
  for (std::size_t v = 0; v < ct.voxels.size(); ++v)
    ct.voxels[v] = static_cast<std::int16_t>(hashNode(static_cast<int>(v), 0, 0, 3) % 3000 - 1000);
  return ct;
}

TEST(Threshold, TakesBothEndsOfTheRangeAndOnlyTheBox) {
  const CtVolume ct = noisyCt(test::toolGrids()[2].geometry);
  Selection chosen(ct.geometry, {{3, 4, 2}, {20, 30, 15}});
  const HuRange range{-20, 431};
  threshold(ct, range, chosen);
  std::size_t expected = 0;
  for (int k = 2; k < 15; ++k)
    for (int j = 4; j < 30; ++j)
      for (int i = 3; i < 20; ++i) {
        ASSERT_EQ(chosen.isSelected(i, j, k), ct.at(i, j, k) >= -20 && ct.at(i, j, k) <= 431);
        expected += chosen.isSelected(i, j, k);
      }
  EXPECT_GT(expected, 100u);
  EXPECT_EQ(chosen.count(), expected);
}

TEST(Threshold, FollowsASliderInTheSameMemoryAndKnowsRangesBeyondSixteenBits) {
  const CtVolume ct = noisyCt(test::toolGrids()[0].geometry);
  Selection chosen(ct.geometry, boxOf(ct.geometry));
  const std::uint8_t* const memory = chosen.mask.voxels.data();
  threshold(ct, {-100000, 100000}, chosen);
  EXPECT_EQ(chosen.count(), ct.voxels.size());
  threshold(ct, {40000, 50000}, chosen);
  EXPECT_EQ(chosen.count(), 0u) << "not wrapped round";
  threshold(ct, {100, 50}, chosen);
  EXPECT_EQ(chosen.count(), 0u) << "an empty range";
  EXPECT_EQ(chosen.mask.voxels.data(), memory);
}

TEST(Threshold, ProposesWhatTheRulesAllowInOnePassAndInTheSameMemory) {
  const CtVolume ct = noisyCt(test::toolGrids()[2].geometry);
  LabelMap labels(ct.geometry);
  for (std::size_t v = 0; v < labels.voxels.size(); ++v) labels.voxels[v] = std::uint8_t(v % 7);
  EditRules locked, limited;
  locked.locked.set(3), locked.hidden.set(5);
  limited.over = LabelSet().set(2).set(4), limited.editable = HuRange{0, 300};
  EditRules none;
  none.locked.set(2);
  Proposal made;
  const std::uint8_t* memory = nullptr;
  for (const EditRules& rules : {EditRules{}, locked, limited, none})
    for (const HuRange range : {HuRange{-20, 431}, {100, 50}, {-100000, 100000}}) {
      const VoxelBox box{{3, 4, 2}, {20, 30, 15}};
      Selection chosen(ct.geometry, box);
      threshold(ct, range, chosen);
      Proposal expected = proposePainting(std::move(chosen), 2);
      removeForbiddenChanges(rules, ct, labels, expected);
      proposeThreshold(ct, range, 2, rules, labels, box, made);
      EXPECT_EQ(made.box, expected.box);
      EXPECT_EQ(made.labels.geometry, expected.labels.geometry);
      EXPECT_EQ(made.labels.voxels, expected.labels.voxels);
      EXPECT_TRUE(!memory || made.labels.voxels.data() == memory);
      memory = made.labels.voxels.data();
    }
  proposeThreshold(ct, {}, 2, {}, labels, boxOf(ct.geometry), made);
  EXPECT_EQ(made.labels.voxels.size(), ct.voxels.size()) << "of another box";
  proposeThreshold(ct, {}, 2, {}, labels, {}, made);
  EXPECT_TRUE(made.box.empty());
  EXPECT_TRUE(made.labels.voxels.empty());
}

TEST_P(BrushOnGrids, DabOfASphereIsTheBallInThePatient) {
  const Vec3 at{3.3, -2.1, 4.2};
  const Selection dab = strokeVoxels(grid(), std::array{at}, {.radius_mm = 7});
  EXPECT_EQ(difference(dab, ball(at, 7)), 0u);
}

TEST_P(BrushOnGrids, StrokeIsWhatTheBallSweeps) {
  const std::array stroke{Vec3{-9, -3, 0}, Vec3{8, 5, 3}, Vec3{9, -8, -4}};
  const Selection swept = strokeVoxels(grid(), stroke, {.radius_mm = 3});
  const auto near = [&](Vec3 p, Vec3 a, Vec3 b) {
    const double t = std::clamp(dot(p - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    return norm(p - a - (b - a) * t) <= 3;
  };
  const Selection expected =
      shape([&](Vec3 p) { return near(p, stroke[0], stroke[1]) || near(p, stroke[1], stroke[2]); });
  EXPECT_LE(difference(swept, expected), 3u) << "but for the voxels nearest to the corners";
}

TEST_P(BrushOnGrids, CircleStaysInItsSlice) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec3 at{1.3, 2.1, -3.2};
    const Selection dab = strokeVoxels(grid(), std::array{at}, {.radius_mm = 6, .sliceAxis = axis});
    ASSERT_EQ(dab.box.length(axis), 1);
    const double area_mm2 = volume_mm3(dab) / grid().spacing_mm[axis];
    EXPECT_NEAR(area_mm2, 113, 20) << "pi 6^2, in voxels";
  }
}

TEST_P(BrushOnGrids, SmallestBrushPaintsItsVoxelAndNothingIsPaintedBesideTheGrid) {
  EXPECT_EQ(strokeVoxels(grid(), std::array{Vec3{0.31, 0.27, 0.19}}, {.radius_mm = 0.01}).count(), 1u);
  EXPECT_TRUE(strokeVoxels(grid(), std::array{Vec3{500, 0, 0}}, {.radius_mm = 5}).box.empty());
  EXPECT_TRUE(strokeVoxels(grid(), {}, {.radius_mm = 5}).box.empty());
  EXPECT_TRUE(strokeVoxels(grid(), std::array{Vec3{500, 0, 0}}, {.radius_mm = 5, .sliceAxis = 0}).box.empty());
}

TEST(Brush, IntensityLimitedPaintsOnlyWhatIsInRange) {
  const CtVolume ct = noisyCt(test::toolGrids()[1].geometry);
  Selection dab = strokeVoxels(ct.geometry, std::array{Vec3{0, 0, 0}}, {.radius_mm = 9});
  const std::size_t all = dab.count();
  removeOutside(ct, {0, 800}, dab);
  EXPECT_GT(dab.count(), all / 10);
  EXPECT_LT(dab.count(), all / 2);
  for (int k = dab.box.first[2]; k < dab.box.end[2]; ++k)
    for (int j = dab.box.first[1]; j < dab.box.end[1]; ++j)
      for (int i = dab.box.first[0]; i < dab.box.end[0]; ++i)
        ASSERT_LE(dab.isSelected(i, j, k), (HuRange{0, 800}.contains(ct.at(i, j, k))));
}

/// Even-odd rule by winding round with angles, of points in a plane: another way than crossings.
bool inTriangle(Vec3 p, Vec3 a, Vec3 b, Vec3 c, Vec3 normal) {
  const auto side = [&](Vec3 from, Vec3 to) { return dot(cross(to - from, p - from), normal) >= 0; };
  return side(a, b) == side(b, c) && side(b, c) == side(c, a);
}

TEST_P(PolygonOnGrids, DrawnTriangleHoldsTheCentersInIt) {
  for (int axis = 0; axis < 3; ++axis) {
    const Mat3& d = grid().direction;
    const Vec3 u = d.column[(axis + 1) % 3], v = d.column[(axis + 2) % 3];
    const Vec3 a = u * -11.3 + v * -7.2, b = u * 12.1 + v * -3.3, c = u * -2.2 + v * 13.7;
    const auto drawing = polygonVoxels(grid(), axis, std::array{a, b, c});
    ASSERT_TRUE(drawing) << drawing.error().message;
    EXPECT_EQ(drawing->box.length(axis), 1);
    const int slice = drawing->box.first[axis];
    const Transform indexFromPatient = grid().indexFromPatient();
    const Selection expected = shape([&](Vec3 p) {
      return std::lround((indexFromPatient * p)[axis]) == slice && inTriangle(p, a, b, c, cross(u, v));
    });
    EXPECT_GT(expected.count(), 20u);
    EXPECT_EQ(difference(*drawing, expected), 0u);
  }
}

TEST_P(PolygonOnGrids, OutlineThatCrossesItselfFollowsTheEvenOddRule) {
  const Vec3 u = grid().direction.column[0], v = grid().direction.column[1];
  // A pentagram: its middle is outside.
  std::vector<Vec3> star;
  for (int n = 0; n < 5; ++n) star.push_back(u * (15 * std::cos(n * 2.51327)) + v * (15 * std::sin(n * 2.51327)));
  const auto drawing = polygonVoxels(grid(), 2, star);
  ASSERT_TRUE(drawing);
  const auto at = [&](Vec3 p) {
    const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * p);
    return drawing->isSelected(i, j, k);
  };
  EXPECT_FALSE(at({0, 0, 0}));
  EXPECT_TRUE(at(u * 10));
}

TEST_P(PolygonOnGrids, ScissorsCutStraightThroughInAParallelView) {
  const Vec3 along = normalized(Vec3{0.3, -0.5, 0.8}), u = normalized(cross(along, {1, 0, 0})), v = cross(along, u);
  const Vec3 a = u * -9.1 + along * 50, b = u * 8.3 + v * 2, c = v * 12.4 - along * 30;
  const auto cut = scissorsVoxels(grid(), boxOf(grid()), std::array{a, b, c}, {.along = along});
  ASSERT_TRUE(cut) << cut.error().message;
  const auto flat = [&](Vec3 p) { return p - along * dot(p, along); };
  const Selection expected = shape([&](Vec3 p) { return inTriangle(flat(p), flat(a), flat(b), flat(c), along); });
  EXPECT_GT(expected.count(), 100u);
  EXPECT_EQ(difference(*cut, expected), 0u);
  const auto rest = scissorsVoxels(grid(), boxOf(grid()), std::array{a, b, c}, {.along = along, .outside = true});
  EXPECT_EQ(difference(*rest, inverted(expected)), 0u);
}

TEST_P(PolygonOnGrids, ScissorsCutAPyramidInAPerspectiveView) {
  // The eye is among the voxels, so that some lie behind it.
  const Vec3 eye{2.3, -1.7, -12.9}, along = normalized(Vec3{0.1, 0.2, 1});
  const Vec3 a = eye + Vec3{-6.17, -4.31, 20.03}, b = eye + Vec3{7.29, -3.13, 14.37}, c = eye + Vec3{-1.41, 9.23, 25};
  const auto cut = scissorsVoxels(grid(), boxOf(grid()), std::array{a, b, c}, {.along = along, .eye_mm = eye});
  ASSERT_TRUE(cut) << cut.error().message;
  const auto inside = [&](Vec3 p, Vec3 m, Vec3 n, Vec3 other) {
    const Vec3 face = cross(m - eye, n - eye);
    return dot(face, p - eye) * dot(face, other - eye) >= 0;
  };
  const Selection expected = shape([&](Vec3 p) {
    return dot(p - eye, along) > 0 && inside(p, a, b, c) && inside(p, b, c, a) && inside(p, c, a, b);
  });
  EXPECT_GT(expected.count(), 100u);
  EXPECT_EQ(difference(*cut, expected), 0u);
}

TEST_P(PolygonOnGrids, ScissorsGoAsDeepAsTheyShould) {
  const Vec3 along = normalized(Vec3{0.1, 0.2, 1}), eye = along * -60;
  const std::array corners{Vec3{-30, -30, 0}, Vec3{30, -30, 0}, Vec3{30, 30, 0}, Vec3{-30, 30, 0}};
  const Vec3 surface = along * -3.1;
  ScissorsView view{.along = along, .eye_mm = eye};
  const auto all = scissorsVoxels(grid(), boxOf(grid()), corners, view);
  view.depth_mm = 5.3, view.surface_mm = surface;
  const auto some = scissorsVoxels(grid(), boxOf(grid()), corners, view);
  ASSERT_TRUE(all && some);
  const Selection expected = shape([&](Vec3 p) {
    const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * p);
    return all->isSelected(i, j, k) && dot(along, p - surface) <= 5.3;
  });
  EXPECT_GT(expected.count(), 100u);
  EXPECT_LT(expected.count(), all->count());
  EXPECT_EQ(difference(*some, expected), 0u);
  // Parallel projection to both sides of the first corner.
  const auto slab = scissorsVoxels(grid(), boxOf(grid()), corners, {.along = along, .depth_mm = 4.2});
  ASSERT_TRUE(slab);
  const auto whole = scissorsVoxels(grid(), boxOf(grid()), corners, {.along = along});
  const Selection between = shape([&](Vec3 p) {
    const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * p);
    return whole->isSelected(i, j, k) && std::abs(dot(along, p - corners[0])) <= 4.2;
  });
  EXPECT_EQ(difference(*slab, between), 0u);
}

TEST_P(PolygonOnGrids, ScissorsCutAlongTheRowsOfTheGrid) {
  const Mat3& d = grid().direction;
  const Vec3 a = d.column[1] * -9.13 + d.column[2] * -8.27, b = d.column[1] * 11.31 + d.column[2] * 1.19,
             c = d.column[2] * 12.41;
  const auto cut = scissorsVoxels(grid(), boxOf(grid()), std::array{a, b, c}, {.along = d.column[0]});
  ASSERT_TRUE(cut);
  const Selection expected =
      shape([&](Vec3 p) { return inTriangle(p - d.column[0] * dot(p, d.column[0]), a, b, c, d.column[0]); });
  EXPECT_GT(expected.count(), 50u);
  EXPECT_EQ(difference(*cut, expected), 0u);
}

TEST(Polygon, RefusesWhatIsNoOutline) {
  const VolumeGeometry g = test::toolGrids()[0].geometry;
  const auto line = polygonVoxels(g, 2, std::array{Vec3{0, 0, 0}, Vec3{5, 5, 0}});
  ASSERT_FALSE(line);
  EXPECT_THAT(line.error().message, HasSubstr("at least three corners"));
  const auto beside = polygonVoxels(g, 2, std::array{Vec3{0, 0, 500}, Vec3{5, 5, 0}, Vec3{5, 0, 0}});
  ASSERT_FALSE(beside);
  EXPECT_THAT(beside.error().message, HasSubstr("outside the CT"));
  const auto behind =
      scissorsVoxels(g, boxOf(g), std::array{Vec3{0, 0, -5}, Vec3{5, 5, 5}, Vec3{5, 0, 5}}, {.eye_mm = Vec3{0, 0, 0}});
  ASSERT_FALSE(behind);
  EXPECT_THAT(behind.error().message, HasSubstr("behind the camera"));
}

TEST(Logical, WorksOnBoxesThatOverlapOnlyInPart) {
  const VolumeGeometry g = test::toolGrids()[0].geometry;
  const Selection a = strokeVoxels(g, std::array{Vec3{-3, 0, 0}}, {.radius_mm = 5});
  const Selection b = strokeVoxels(g, std::array{Vec3{3, 0, 0}}, {.radius_mm = 5});
  const auto both = combined(a, LogicalOperation::kIntersect, b, g);
  const auto either = combined(a, LogicalOperation::kAdd, b, g);
  const auto without = combined(a, LogicalOperation::kSubtract, b, g);
  EXPECT_GT(both.count(), 0u);
  EXPECT_EQ(either.count() + both.count(), a.count() + b.count());
  EXPECT_EQ(without.count() + both.count(), a.count());
  EXPECT_EQ(inverted(a).count() + a.count(), a.mask.voxels.size());
}

}  // namespace
}  // namespace insonate
