#include "realism/FanInside.h"
#include "realism/ImagePlan.h"
#include "realism/ReaderSheet.h"
#include "support/FovCapture.h"
#include "support/TestData.h"

#include <insonate/bench/AppearanceFeatures.h>
#include <insonate/bench/RealismBench.h>
#include <insonate/simulator/ImageFiles.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <random>
#include <set>

namespace insonate {
namespace {

using testing::HasSubstr;

GrayImage noisyFrame(unsigned seed, int width = 200, int height = 150) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(100, 25);
  GrayImage picture{width, height, {}};
  for (int n = 0; n < width * height; ++n)
    picture.gray.push_back(std::uint8_t(std::clamp(std::lround(normal(random)), 1L, 255L)));
  return picture;
}

std::vector<GrayImage> noisyClip(unsigned seed) {
  std::vector<GrayImage> frames;
  for (unsigned n = 0; n < unsigned(kClipFrames); ++n) frames.push_back(noisyFrame(seed * 100 + n));
  return frames;
}

void writeFrame(const GrayImage& picture, const std::filesystem::path& file) {
  BModeImage image;
  image.width = picture.width, image.height = picture.height, image.pixel_mm = 0.1, image.gray = picture.gray;
  const auto written = writePng(image, file);
  ASSERT_TRUE(written) << written.error().message;
}

std::string textIn(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(FanInside, FindsTheLargestRectangle) {
  cv::Mat mask = cv::Mat::zeros(40, 60, CV_8U);
  mask(cv::Rect(5, 10, 50, 6)) = 1;
  mask(cv::Rect(20, 4, 18, 30)) = 1;
  EXPECT_EQ(bench::largestRectangle(mask), (PixelBox{20, 4, 18, 30}));
  EXPECT_EQ(bench::boundsOf(mask), (PixelBox{5, 4, 50, 30}));
  EXPECT_EQ(bench::largestRectangle(cv::Mat::zeros(5, 5, CV_8U)).width, 0);
}

FovShape fanShape() {
  FovShape fan;
  fan.shape = ProbeShape::Curvilinear;
  fan.origin = {400, -150}, fan.alpha_deg = 65, fan.r1_px = 200, fan.r2_px = 700;
  return fan;
}

TEST(RealFans, AreFoundAndWhatIsOutsideBecomesBlack) {
  const test::TemporaryFolder folder;
  test::FovCapture capture{.shape = fanShape(), .width = 800, .height = 600, .ground = 30};
  capture.text = true;
  writeFrame(test::CapturePainter(capture).paint(), folder / "fan.png");
  std::ofstream(folder / "list.csv") << "fan.png,8,machine A,probe=curvilinear,plane=oblique\n";
  const auto images = readRealImages(folder / "list.csv");
  ASSERT_TRUE(images) << images.error().message;
  const SourceImage& image = images->front();
  EXPECT_EQ(image.probe, ProbeShape::Curvilinear);
  EXPECT_EQ(image.plane, ScanPlane::Oblique);
  EXPECT_FALSE(image.isClip());
  ASSERT_EQ(image.frames.size(), 1u);
  const GrayImage& shown = image.shown();
  EXPECT_NEAR(shown.height, (700 - 200 * std::cos(32.5 / 57.2958)) / 8 * 5, 12) << "5 pixels per mm";
  EXPECT_EQ(shown.gray.front(), 0) << "the corner lies outside the fan";
  EXPECT_EQ(shown.gray.back(), 0);
  EXPECT_LE(image.image.height, 300);
  EXPECT_GT(image.image.width, 200) << "the largest rectangle in the fan";
}

TEST(RealClips, AreTheMiddleSecondOfAFolder) {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder / "clip");
  for (int n = 0; n < 40; ++n)
    writeFrame({150, 120, std::vector<std::uint8_t>(150 * 120, std::uint8_t(100 + n))},
               folder / ("clip/" + std::to_string(100 + n) + ".png"));
  const auto read = [&](const std::string& options) {
    std::ofstream(folder / "list.csv") << "clip,10,machine A" << options << "\n";
    return readRealImages(folder / "list.csv");
  };
  const auto fast = read("");
  ASSERT_TRUE(fast) << fast.error().message;
  ASSERT_EQ(int(fast->front().frames.size()), kClipFrames);
  EXPECT_EQ(fast->front().frames.front().gray.front(), 105) << "30 of 40 frames";
  EXPECT_EQ(fast->front().frames.back().gray.front(), 134);
  const auto slow = read(",fps=15");
  ASSERT_TRUE(slow) << slow.error().message;
  EXPECT_EQ(slow->front().frames.front().gray.front(), 112) << "15 of 40 frames, each twice";
  EXPECT_EQ(slow->front().frames.back().gray.front(), 127);
  EXPECT_THAT(read(",fps=60").error().message, HasSubstr("holds 40 images; a clip of 1 s needs 60"));
  EXPECT_THAT(read(",fps=0").error().message, HasSubstr("5 to 500"));
  EXPECT_THAT(read(",probe=round").error().message, HasSubstr("linear, curvilinear or phased, not \"round\""));
  EXPECT_THAT(read(",plane=up").error().message, HasSubstr("not \"up\""));
  EXPECT_THAT(read(",speed=3").error().message, HasSubstr("\"speed\" is none of"));
  EXPECT_THAT(read(",probe=phased").error().message, HasSubstr("Line 1"));
}

TEST(MotionFeatures, TellStillnessFromNoise) {
  const auto value = [](const std::vector<GrayImage>& frames, const std::string& name) {
    for (const AppearanceFeature& feature : motionFeatures(frames))
      if (feature.name == "motion: " + name) return feature.value;
    throw std::runtime_error("no feature " + name);
  };
  const std::vector<GrayImage> still(kClipFrames, noisyFrame(1)), noise = noisyClip(2);
  EXPECT_NEAR(value(still, "correlation of detail after 1/30 s"), 1, 1e-4);
  EXPECT_NEAR(value(still, "change from frame to frame / mean"), 0, 1e-9);
  EXPECT_NEAR(value(noise, "correlation of detail after 1/30 s"), 0, 0.02);
  EXPECT_NEAR(value(noise, "correlation of detail after 1/3 s"), 0, 0.02);
  // The mean difference of two normal values is 2 / sqrt(pi) standard deviations.
  EXPECT_NEAR(value(noise, "change from frame to frame / mean"), 0.25 * 2 / std::sqrt(M_PI), 0.01);
  EXPECT_TRUE(std::isnan(value({}, "flicker of the mean gray")));
  std::vector<GrayImage> flickering;
  for (int n = 0; n < kClipFrames; ++n)
    flickering.push_back({50, 50, std::vector<std::uint8_t>(2500, n % 2 ? 90 : 110)});
  EXPECT_NEAR(value(flickering, "flicker of the mean gray"), 0.1, 1e-3);
}

TEST(ScanPlanes, OfStartPosesFollowFromTheirDirection) {
  StartPose pose;
  pose.lateral = {1, 0, 0};
  EXPECT_EQ(bench::planeOf(pose), ScanPlane::Transverse);
  pose.lateral = {0, 0, -1};
  EXPECT_EQ(bench::planeOf(pose), ScanPlane::Longitudinal);
  pose.lateral = {0.7, 0, 0.7};
  EXPECT_EQ(bench::planeOf(pose), ScanPlane::Oblique);
  for (const ScanPlane plane : {ScanPlane::Transverse, ScanPlane::Longitudinal, ScanPlane::Oblique})
    EXPECT_EQ(scanPlaneNamed(nameOf(plane)), plane);
  EXPECT_FALSE(scanPlaneNamed("sagittal"));
}

SourceImage of(const std::string& source, unsigned seed, ProbeShape probe, bool clip) {
  SourceImage image{source, source + " " + std::to_string(seed), noisyFrame(seed), probe, ScanPlane::Transverse};
  if (clip)
    image.frames = noisyClip(seed);
  else if (probe != ProbeShape::Linear)
    image.frames = {noisyFrame(seed)};
  return image;
}

/// Linear stills and phased clips in both sets, and curvilinear stills that are only simulated.
RealismBench mixedBench() {
  RealismBench bench;
  for (unsigned n = 0; n < 3; ++n) {
    bench.real.push_back(of("machine", n, ProbeShape::Linear, false));
    bench.simulated.push_back(of("textbook", n, ProbeShape::Linear, false));
    bench.real.push_back(of("machine", n, ProbeShape::Phased, true));
    bench.simulated.push_back(of("textbook", n, ProbeShape::Phased, true));
    bench.simulated.push_back(of("textbook", n, ProbeShape::Curvilinear, false));
  }
  return bench;
}

TEST(BlindClips, LieInFoldersOfFramesAndNothingTellsWhichIsWhich) {
  const test::TemporaryFolder folder;
  const auto written = writeRealismBench(mixedBench(), folder / "new");
  ASSERT_TRUE(written) << written.error().message;
  int stills = 0, clips = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "new/blind")) {
    stills += entry.path().extension() == ".jpg";
    if (!entry.is_directory()) {
      EXPECT_THAT(textIn(entry.path()), testing::Not(HasSubstr("textbook"))) << entry.path();
      continue;
    }
    ++clips;
    const auto frames = std::distance(std::filesystem::directory_iterator(entry.path()), {});
    EXPECT_EQ(frames, kClipFrames) << entry.path();
  }
  EXPECT_EQ(stills, 6);
  EXPECT_EQ(clips, 6);
  const std::string key = textIn(folder / "new/key.csv"), unmatched = textIn(folder / "new/unmatched.csv");
  EXPECT_EQ(std::ranges::count(key, '\n'), 13);
  EXPECT_THAT(key, HasSubstr(",0,phased,transverse,30,\"machine\""));
  EXPECT_THAT(key, testing::Not(HasSubstr("curvilinear")));
  EXPECT_EQ(std::ranges::count(unmatched, '\n'), 4) << "only one of the sets has curvilinear images";
  EXPECT_TRUE(std::filesystem::exists(folder / "new/unmatched/003.jpg"));
  const std::string sheet = textIn(folder / "new/blind/sheet.html");
  EXPECT_THAT(sheet, HasSubstr("/001.jpg"));
  EXPECT_THAT(sheet, HasSubstr("/030.jpg"));
  EXPECT_THAT(sheet, HasSubstr("A clip lasts 1 s"));
  EXPECT_THAT(textIn(folder / "new/index.html"), HasSubstr("data-frames=\"blind/"));
}

TEST(BlindClips, AreScoredByGroup) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRealismBench(mixedBench(), folder / "new"));
  std::ifstream key(folder / "new/key.csv");
  std::string line, ratings = "number,rating,seconds\n";
  std::getline(key, line);
  // The reader recognizes all clips and guesses that all stills are real.
  for (int number = 1; std::getline(key, line); ++number) {
    const bool simulated = line.find(",1,") < 5, clip = line.find(",30,") != std::string::npos;
    ratings += std::to_string(number) + "," + (clip && simulated ? "6" : "1") + ",4.2\n";
  }
  std::ofstream(folder / "ratings.csv") << ratings << "# reader: A\n";
  const auto result = scoreBlindTest(folder / "new/key.csv", {folder / "ratings.csv"});
  ASSERT_TRUE(result) << result.error().message;
  EXPECT_DOUBLE_EQ(result->sensitivity, 0.5);
  EXPECT_DOUBLE_EQ(result->separation.area, 0.75);
  std::map<std::string, double> areas;
  for (const BlindGroup& group : result->groups) areas[group.name] = group.separation.area;
  EXPECT_EQ(areas, (std::map<std::string, double>{{"clips", 1}, {"linear", 0.5}, {"phased", 1}, {"stills", 0.5}}));
}

TEST(BlindClips, WithoutAMatchThereIsNoTest) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeRealismBench(mixedBench(), folder / "new"));
  RealismBench bench;
  bench.real.push_back(of("machine", 1, ProbeShape::Linear, false));
  bench.simulated.push_back(of("textbook", 1, ProbeShape::Linear, true));
  ASSERT_TRUE(writeRealismBench(bench, folder / "new"));
  EXPECT_FALSE(std::filesystem::exists(folder / "new/blind")) << "no test of an earlier run is left";
  EXPECT_FALSE(std::filesystem::exists(folder / "new/key.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder / "new/unmatched/002/030.jpg"));
}

TEST(ReaderSheet, CarriesTheProtocolAndEscapesText) {
  const std::string sheet = bench::sheetHtml({{{"001.jpg"}}, {{"002.jpg"}}}, "a\"b");
  for (const char* part : {"Some of the 2 numbered images", "surely simulated", "Do not talk about", "[\"001.jpg\"]",
                           "\"insonate reading test a\\\"b\""})
    EXPECT_THAT(sheet, HasSubstr(part));
  EXPECT_THAT(sheet, testing::Not(HasSubstr("A clip lasts")));
  EXPECT_THAT(bench::readerInstructions(2, true), HasSubstr("A clip lasts"));
}

/// Vessels pulsate while tissue stays where it is: neighboring frames resemble each other, but are not equal.
TEST(SimulatedClips, ShowAFanInThePlaneThatIsAskedFor) {
  const auto images = simulatedImages(
      {.count = 1, .seed = 2, .probes = {ProbeShape::Curvilinear}, .planes = {ScanPlane::Longitudinal}, .clips = true},
      {});
  ASSERT_TRUE(images) << images.error().message;
  const SourceImage& clip = images->front();
  EXPECT_EQ(clip.probe, ProbeShape::Curvilinear);
  EXPECT_EQ(clip.plane, ScanPlane::Longitudinal);
  ASSERT_EQ(int(clip.frames.size()), kClipFrames) << clip.about;
  for (const GrayImage& frame : clip.frames) {
    EXPECT_EQ(frame.width, clip.frames.front().width);
    EXPECT_EQ(frame.gray.front(), 0) << "outside the fan";
  }
  EXPECT_GE(clip.image.width, 100);
  EXPECT_LE(clip.image.height, 300);
  const auto motion = motionFeatures(clip.frames);
  EXPECT_GT(motion[0].value, 0.5) << clip.about;
  EXPECT_GT(motion[2].value, 0);
}

}  // namespace
}  // namespace insonate
