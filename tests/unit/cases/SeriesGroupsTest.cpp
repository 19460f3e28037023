#include "import/SeriesGroups.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using testing::HasSubstr;

DicomSlice slice(const std::string& uid, double z_mm) {
  DicomSlice s;
  s.file = "slice";
  s.studyUid = "1.2";
  s.seriesUid = uid;
  s.sopUid = uid + "." + std::to_string(z_mm);
  s.modality = "CT";
  s.columns = 16;
  s.rows = 12;
  s.position_mm = Vec3{0, 0, z_mm};
  s.orientation = {Vec3{1, 0, 0}, Vec3{0, 1, 0}};
  s.pixelSpacing_mm = {0.8, 0.5};
  s.slope = 1;
  s.intercept = -1024;
  return s;
}

std::vector<DicomSlice> stackOf(const std::string& uid, int count, double step_mm = 2) {
  std::vector<DicomSlice> slices;
  for (int n = 0; n < count; ++n) {
    slices.push_back(slice(uid, n * step_mm));
    slices.back().instance = n + 1;
  }
  return slices;
}

std::vector<DicomSlice> operator+(std::vector<DicomSlice> a, const std::vector<DicomSlice>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST(SeriesGroups, PixelSpacingIsRowsThenColumns) {
  const auto series = groupSlices(stackOf("1", 3));
  ASSERT_EQ(series.size(), 1U);
  EXPECT_EQ(series[0].plan.grid.spacing_mm, (Vec3{0.5, 0.8, 2}));
  EXPECT_EQ(series[0].plan.grid.size, (std::array{16, 12, 3}));
}

TEST(SeriesGroups, OneUidWithTwoOrientationsIsTwoStacks) {
  auto coronal = stackOf("1", 3);
  for (DicomSlice& s : coronal) {
    s.sopUid += "c";
    s.orientation = {Vec3{1, 0, 0}, Vec3{0, 0, -1}};
    s.position_mm = Vec3{0, s.position_mm->z, 0};
  }
  const auto series = groupSlices(stackOf("1", 5) + coronal);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].uid, "1");
  EXPECT_EQ(series[0].slices.size(), 5U);
  EXPECT_EQ(series[1].uid, "1#2");
  EXPECT_EQ(series[1].slices.size(), 3U);
  EXPECT_THAT(series[0].warnings, testing::Contains(HasSubstr("2 different stacks")));
}

TEST(SeriesGroups, OrientationNoiseIsOneStack) {
  auto slices = stackOf("1", 8);
  for (std::size_t n = 0; n < slices.size(); ++n) (*slices[n].orientation)[0].y = n % 2 ? 1e-4 : -1e-4;
  EXPECT_EQ(groupSlices(slices).size(), 1U);
}

TEST(SeriesGroups, ReconstructionsUnderOneUidAreKeptApart) {
  auto soft = stackOf("1", 6), sharp = stackOf("1", 6);
  std::vector<DicomSlice> all;
  for (std::size_t n = 0; n < soft.size(); ++n) {
    soft[n].kernel = "B30f";
    sharp[n].kernel = "B70f";
    sharp[n].sopUid += "s";
    // The order of a folder must not decide.
    all.push_back(n % 2 ? soft[n] : sharp[n]);
    all.push_back(n % 2 ? sharp[n] : soft[n]);
  }
  const auto series = groupSlices(all);
  ASSERT_EQ(series.size(), 2U);
  for (const DicomSeries& s : series) {
    EXPECT_EQ(s.slices.size(), 6U);
    EXPECT_TRUE(std::ranges::all_of(s.slices, [&](const DicomSlice& x) { return x.kernel == s.slices[0].kernel; }));
  }
}

TEST(SeriesGroups, SlicesThatAreNotQuiteParallelAreSaid) {
  auto slices = stackOf("1", 8);
  for (std::size_t n = 0; n < slices.size(); ++n) {
    const double angle = n % 2 ? 0.006 : 0;  // too little for another stack
    slices[n].columns = slices[n].rows = 512;
    (*slices[n].orientation)[1] = {0, std::cos(angle), std::sin(angle)};
  }
  const auto series = groupSlices(slices);
  ASSERT_EQ(series.size(), 1U);
  // 512 rows of 0.8 mm, a mean of 0.003 beside each: 1.2 mm.
  EXPECT_THAT(series[0].warnings,
              testing::Contains(HasSubstr("not quite parallel, but are treated as parallel. Their corners are "
                                          "up to 2 mm")));
}

TEST(SeriesGroups, StudiesUnderOneUidAreKeptApart) {
  auto other = stackOf("1", 4);
  for (DicomSlice& s : other) s.studyUid = "9", s.sopUid += "x", s.position_mm->z += 1;
  const auto series = groupSlices(stackOf("1", 6) + other);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_EQ(series[0].slices.size(), 6U);
  EXPECT_EQ(series[1].slices.size(), 4U);
}

/// Gives each slice a frame of reference of its own.
std::vector<DicomSlice> withOwnFrames(std::vector<DicomSlice> slices) {
  static int frame = 0;
  for (DicomSlice& s : slices) s.frameOfReferenceUid = "9." + std::to_string(++frame);
  return slices;
}

std::vector<std::size_t> sizesOf(const std::vector<DicomSeries>& series) {
  std::vector<std::size_t> sizes;
  for (const DicomSeries& s : series) sizes.push_back(s.slices.size());
  return sizes;
}

TEST(SeriesGroups, RegularSlicesOfDifferentFramesAreOneStack) {
  const auto series = groupSlices(withOwnFrames(stackOf("1", 275)));
  ASSERT_EQ(series.size(), 1U);
  EXPECT_EQ(series[0].slices.size(), 275U);
  EXPECT_EQ(series[0].refusal, "");
  EXPECT_THAT(series[0].warnings, testing::ElementsAre(HasSubstr("275 different frames of reference")));
}

TEST(SeriesGroups, CopiesOfSlicesWithTheirOwnFramesAreDropped) {
  const auto slices = withOwnFrames(stackOf("1", 20));
  EXPECT_THAT(sizesOf(groupSlices(slices + slices)), testing::ElementsAre(20));
}

TEST(SeriesGroups, MissingSliceBetweenDifferentFramesIsInterpolated) {
  auto slices = withOwnFrames(stackOf("1", 20));
  slices.erase(slices.begin() + 7);
  const auto series = groupSlices(slices);
  ASSERT_EQ(series.size(), 1U);
  EXPECT_EQ(series[0].plan.grid.size[2], 20);
  EXPECT_THAT(series[0].warnings, testing::Contains(HasSubstr("1 slice is missing")));
}

TEST(SeriesGroups, OneFrameBetweenSlicesWithTheirOwnFramesStaysApart) {
  auto second = stackOf("1", 10);
  for (DicomSlice& s : second) s.sopUid += "b", s.position_mm->z += 0.7, s.frameOfReferenceUid = "8";
  EXPECT_THAT(sizesOf(groupSlices(withOwnFrames(stackOf("1", 30)) + second)), testing::ElementsAre(30, 10));
}

/// The positions of both scans together are regular, too.
TEST(SeriesGroups, InterleavedScansOfDifferentFramesAreKeptApart) {
  const auto scansApart = [](auto change, bool ownFrames) {
    auto second = stackOf("1", 20);
    for (DicomSlice& s : second) s.sopUid += "b", s.position_mm->z += 1, change(s);
    auto first = stackOf("1", 20);
    if (ownFrames) first = withOwnFrames(first), second = withOwnFrames(second);
    const auto series = groupSlices(first + second);
    return sizesOf(series) == std::vector<std::size_t>{20, 20} && series[0].plan.grid.spacing_mm.z == 2 &&
           series[1].plan.grid.spacing_mm.z == 2;
  };
  EXPECT_TRUE(scansApart([](DicomSlice& s) { s.frameOfReferenceUid = "7"; }, false)) << "one frame each";
  EXPECT_TRUE(scansApart([](DicomSlice& s) { s.acquisition = 2; }, true));
  EXPECT_TRUE(scansApart([](DicomSlice& s) { s.kernel = "B70f"; }, true));
  EXPECT_TRUE(scansApart([](DicomSlice& s) { s.instance = *s.instance + 20; }, true));
  EXPECT_TRUE(scansApart([](DicomSlice& s) { s.instance = 41 - *s.instance; }, true)) << "numbered downward";
}

TEST(SeriesGroups, SlicesOfDifferentFramesWithoutOneRunAreNotCombined) {
  auto sideways = withOwnFrames(stackOf("1", 5));
  sideways[2].position_mm->x += 3;
  EXPECT_EQ(groupSlices(sideways).size(), 5U);
  const auto two = groupSlices(withOwnFrames(stackOf("1", 2)));
  EXPECT_EQ(two.size(), 2U);
  EXPECT_THAT(two[0].warnings, testing::Contains(HasSubstr("2 different stacks")));
}

TEST(SeriesGroups, RunsOfDifferentFramesEndAtLargeGaps) {
  auto above = withOwnFrames(stackOf("1", 12));
  for (std::size_t n = 0; n < above.size(); ++n) {
    above[n].position_mm->z += 100;
    above[n].instance = static_cast<int>(21 + n);
    above[n].sopUid += "b";
  }
  EXPECT_THAT(sizesOf(groupSlices(withOwnFrames(stackOf("1", 20)) + above)), testing::ElementsAre(20, 12));
}

TEST(SeriesGroups, CopiesAreDroppedAndSaid) {
  const auto slices = stackOf("1", 5);
  const auto series = groupSlices(slices + slices);
  ASSERT_EQ(series.size(), 1U);
  EXPECT_EQ(series[0].slices.size(), 5U);
  EXPECT_THAT(series[0].warnings, testing::Contains(HasSubstr("5 slices are in the folder twice")));
}

TEST(SeriesGroups, PhasesUnderOneUidAreSplit) {
  auto second = stackOf("1", 5);
  for (DicomSlice& s : second) s.sopUid += "b", s.instance = *s.instance + 5;
  const auto series = groupSlices(stackOf("1", 5) + second);
  ASSERT_EQ(series.size(), 2U);
  for (const DicomSeries& s : series) {
    EXPECT_EQ(s.refusal, "");
    EXPECT_EQ(s.slices.size(), 5U);
  }
  EXPECT_EQ(*series[0].slices[0].instance, 1);
  EXPECT_EQ(*series[1].slices[0].instance, 6);
}

TEST(SeriesGroups, AcquisitionsOfDifferentSpacingAreSplit) {
  auto coarse = stackOf("1", 5, 5);
  for (DicomSlice& s : coarse) s.sopUid += "b", s.acquisition = 2, s.position_mm->z += 50;
  auto fine = stackOf("1", 10, 1);
  for (DicomSlice& s : fine) s.acquisition = 1;
  const auto series = groupSlices(fine + coarse);
  ASSERT_EQ(series.size(), 2U);
  EXPECT_DOUBLE_EQ(series[0].plan.grid.spacing_mm.z, 1);
  EXPECT_DOUBLE_EQ(series[1].plan.grid.spacing_mm.z, 5);
}

TEST(SeriesGroups, UnexplainedDuplicateIsRefused) {
  auto slices = stackOf("1", 5);
  slices.push_back(slices[2]);
  slices.back().sopUid = "other";
  const auto series = groupSlices(slices);
  ASSERT_EQ(series.size(), 1U);
  EXPECT_THAT(series[0].refusal, HasSubstr("1 slice is at the same position as another"));
}

TEST(SeriesGroups, IncompleteHeadersAreRefusedWithTheReason) {
  const auto refusalOf = [](auto change) {
    auto slices = stackOf("1", 3);
    for (DicomSlice& s : slices) change(s);
    return groupSlices(slices).at(0).refusal;
  };
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.pixelSpacing_mm.reset(); }), HasSubstr("Pixel Spacing"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.pixelSpacing_mm = {0.0, 1.0}; }), HasSubstr("not above 0"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.position_mm.reset(); }), HasSubstr("Image Position"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.orientation.reset(); }), HasSubstr("Orientation"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { (*s.orientation)[0] = {}; }), HasSubstr("unit vectors"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.modality = "MR"; }), HasSubstr("MR, not CT"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.cutOff = true; }), HasSubstr("cut off"));
  EXPECT_THAT(refusalOf([](DicomSlice& s) { s.rows = 0; }), HasSubstr("do not state their size"));
}

}  // namespace
}  // namespace insonate
