#include "support/AttemptBlock.h"

#include <insonate/teaching/NeedlePath.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

TrackPoint pointAt(std::int64_t time_us, NeedlePlace place, double depth_mm, double aside_mm = 0) {
  return {.time_us = time_us,
          .needleDepth_mm = depth_mm,
          .tip_mm = Vec3{0, depth_mm, 0},
          .tip_probe = Vec3{1, aside_mm, depth_mm},
          .place = place};
}

/// In and through the vein, behind it, and out of the image plane. In between, the needle was outside once.
std::vector<TrackPoint> track() {
  using enum NeedlePlace;
  std::vector<TrackPoint> points{pointAt(0, UnderSkin, 4), pointAt(20'000, UnderSkin, 9)};
  points.push_back({.time_us = 40'000, .tip_probe = Vec3{1, 0, -3}});
  for (const TrackPoint& one : {pointAt(60'000, UnderSkin, 5), pointAt(80'000, Vein, 13), pointAt(100'000, Vein, 15),
                                pointAt(120'000, WrongPlace, 26), pointAt(140'000, WrongPlace, 27, 8)})
    points.push_back(one);
  return points;
}

ImageField field() {
  return {.width_mm = 40, .sliceHalf_mm = 1};
}

TEST(NeedlePath, APieceHasOnePlaceAndIsEitherInTheSliceOrNot) {
  const auto pieces = pathPieces(track(), field());
  ASSERT_EQ(pieces.size(), 5u);
  EXPECT_EQ(pieces[0].points.size(), 2u);
  EXPECT_EQ(pieces[1].points.size(), 1u) << "the needle was outside in between, so that nothing joins the pieces";
  EXPECT_EQ(pieces[2].place, NeedlePlace::Vein);
  EXPECT_EQ(pieces[2].points.front(), pieces[1].points.back()) << "pieces share their end points";
  EXPECT_EQ(pieces[3].place, NeedlePlace::WrongPlace);
  EXPECT_TRUE(pieces[3].isInSlice);
  EXPECT_FALSE(pieces[4].isInSlice) << "8 mm beside a slice of 2 mm";
  EXPECT_TRUE(pathPieces({}, field()).empty());
}

TEST(NeedlePath, TheSectionIsTakenWhereTheVeinIsReachedElseAtTheDeepestPoint) {
  std::vector<TrackPoint> points = track();
  EXPECT_EQ(sectionPoint(points)->time_us, 80'000);
  for (TrackPoint& one : points) one.place = NeedlePlace::UnderSkin;
  EXPECT_EQ(sectionPoint(points)->time_us, 140'000);
  EXPECT_EQ(sectionPoint({}), nullptr);
}

TEST(NeedlePath, TheSectionHoldsImageAndPath) {
  EXPECT_EQ(sectionArea(track(), field(), 0), (PlaneArea{-20, 20, -5, 30})) << "the tip was 27 mm deep";
  EXPECT_EQ(sectionArea(track(), field(), 45), (PlaneArea{-20, 20, -5, 45}));
  std::vector<TrackPoint> far = track();
  far.front().tip_probe->x = 31;
  EXPECT_EQ(sectionArea(far, field(), 0).right, 34);
}

TEST(NeedlePath, ASectionHasVesselsAndSkinButNoMuscle) {
  const PatientCase block = test::attemptBlock();
  // The probe looks along y from the skin at y = -0.5, with its marker along x.
  const Transform patientFromProbe{{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, {0, -0.5, 0}};
  const PlaneArea area{-20, 20, -5, 40};
  const SectionLabels section = sectionLabels(block, patientFromProbe, area, 0.5);
  ASSERT_EQ(section.columns, 80);
  ASSERT_EQ(section.rows, 90);
  const auto at = [&](double lateral_mm, double depth_mm) {
    return section.at(int((lateral_mm - area.left) / 0.5), int((depth_mm - area.top) / 0.5));
  };
  EXPECT_EQ(at(0, 18), kVein);
  EXPECT_EQ(at(15, 25), kArtery);
  EXPECT_EQ(at(0, 1), kSkin);
  EXPECT_EQ(at(0, 30), 0) << "soft tissue is left out";
  EXPECT_EQ(at(0, -3), 0) << "air";
}

}  // namespace
}  // namespace insonate
