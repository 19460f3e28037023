#include "HandScene.h"
#include "support/TestData.h"

#include <insonate/camera/CameraSource.h>
#include <insonate/camera/HandsSheet.h>
#include <insonate/camera/LensCalibration.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <set>

namespace insonate::test {
namespace {

double distance_mm(SheetPoint a, SheetPoint b) {
  return std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm);
}

class HandsSheetOnPaper : public testing::TestWithParam<PaperSize> {};

TEST_P(HandsSheetOnPaper, ContainsEveryTagInTrueSizeWithinTheMargins) {
  const auto pages = handsSheet(GetParam());
  ASSERT_TRUE(pages) << pages.error().message;
  std::map<int, double> sizes;
  for (const char* name : {"needle", "probe"})
    for (const BodyTag& tag : bodyNamed(name).tags) sizes[tag.id] = tag.size_mm;
  for (const BodyTag& tag : lensBoard()) sizes[tag.id] = tag.size_mm;
  std::set<int> printed;
  for (const SheetPage& page : *pages) {
    for (const SheetTag& tag : page.tags) {
      EXPECT_TRUE(printed.insert(tag.id).second) << tag.id;
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_NEAR(distance_mm(tag.corners[i], tag.corners[(i + 1) % 4]), sizes.at(tag.id), 1e-6);
    }
    for (const SheetLine& line : page.lines)
      for (const SheetPoint& p : {line.from, line.to}) {
        EXPECT_GE(std::min(p.x_mm, p.y_mm), 5);
        EXPECT_LE(p.x_mm, page.width_mm - 5);
        EXPECT_LE(p.y_mm, page.height_mm - 5);
      }
  }
  EXPECT_EQ(printed.size(), sizes.size());
}

TEST_P(HandsSheetOnPaper, NetsUnfoldTheBodyWithoutOverlap) {
  const TagBody body = bodyNamed("probe");
  const auto page = netPage(body, GetParam());
  ASSERT_TRUE(page) << page.error().message;
  const auto count = [&](SheetLineKind kind) {
    return std::ranges::count_if(page->lines, [&](const SheetLine& l) { return l.kind == kind; });
  };
  // 12 faces are joined by 11 folds; of the other 19 edges, each has a tab (3 cuts and a fold) on one of its two sides.
  EXPECT_EQ(count(SheetLineKind::kFold), 11 + 19);
  EXPECT_EQ(count(SheetLineKind::kCut), 19 * 4);
  for (const SheetLine& line : page->lines)
    EXPECT_TRUE(line.kind != SheetLineKind::kFold || std::abs(distance_mm(line.from, line.to) - 28) < 0.01);
  // Tags of different faces lie at least an inscribed diameter apart.
  const auto middle = [](const SheetTag& tag) {
    return SheetPoint{(tag.corners[0].x_mm + tag.corners[2].x_mm) / 2, (tag.corners[0].y_mm + tag.corners[2].y_mm) / 2};
  };
  for (const SheetTag& a : page->tags)
    for (const SheetTag& b : page->tags)
      EXPECT_TRUE(a.id == b.id || distance_mm(middle(a), middle(b)) > 2 * 0.688 * 28 - 0.1) << a.id << " " << b.id;
}

TEST_P(HandsSheetOnPaper, TagsInThePdfAreInTheirPlaces) {
  if (std::system("gs --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "Ghostscript (gs) is not installed.";
  const TemporaryFolder folder;
  const auto pages = handsSheet(GetParam());
  ASSERT_TRUE(pages);
  const std::string pdf = folder / "hands.pdf";
  ASSERT_TRUE(writeHandsSheet(*pages, pdf));
  constexpr double kPixelPerMm = 200 / 25.4;
  const std::string command =
      "gs -q -dSAFER -dBATCH -dNOPAUSE -sDEVICE=pgmraw -r200 -dGraphicsAlphaBits=4 -sOutputFile='" +
      (folder.path() / "page%d.pgm").string() + "' '" + pdf + "'";
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto source = openRecordedFrames(folder.path());
  ASSERT_TRUE(source) << source.error().message;
  for (const SheetPage& page : *pages) {
    CameraFrame frame;
    const auto status = (*source)->next(frame, std::chrono::milliseconds(0));
    ASSERT_TRUE(status) << status.error().message;
    EXPECT_NEAR(frame.width, page.width_mm * kPixelPerMm, 1.5);
    EXPECT_NEAR(frame.height, page.height_mm * kPixelPerMm, 1.5);
    std::vector<TagDetection> found;
    TagDetector().detect(frame.view(), {0, 0, frame.width, frame.height}, 1, found);
    ASSERT_EQ(found.size(), page.tags.size());
    for (const TagDetection& detection : found) {
      const auto tag = std::ranges::find(page.tags, detection.id, &SheetTag::id);
      ASSERT_NE(tag, page.tags.end());
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(detection.corners[i].x / kPixelPerMm, tag->corners[i].x_mm, 0.1) << detection.id;
        // Pages end at whole pixels; PDF counts from the bottom.
        EXPECT_NEAR((frame.height - detection.corners[i].y) / kPixelPerMm, page.height_mm - tag->corners[i].y_mm, 0.1)
            << detection.id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Papers, HandsSheetOnPaper, testing::Values(PaperSize::kA4, PaperSize::kLetter));

TEST(HandsSheet, ErrorsSayWhatToDo) {
  const auto pages = handsSheet(PaperSize::kA4);
  ASSERT_TRUE(pages);
  EXPECT_THAT(writeHandsSheet(*pages, "/nowhere/hands.pdf").error().message, testing::HasSubstr("/nowhere"));
  TagBody large = bodyNamed("probe");
  for (Vec3& vertex : large.vertices_mm) vertex = vertex * 1.5;
  EXPECT_THAT(netPage(large, PaperSize::kA4).error().message, testing::HasSubstr("larger than the page"));
}

}  // namespace
}  // namespace insonate::test
