#include <gmock/gmock.h>
#include <support/FovCapture.h>

namespace insonate {
namespace {

using test::FovCapture;
using testing::Contains;
using testing::HasSubstr;

GrayImage evenly(int width, int height, std::uint8_t gray) {
  return {width, height, std::vector<std::uint8_t>(std::size_t(width) * height, gray)};
}

/// Lines of letters, dark on light paper.
GrayImage textPage() {
  GrayImage page = evenly(800, 1000, 250);
  unsigned state = 7;
  for (int line = 0; line < 45; ++line)
    for (int x = 80; x < 720; x += 11) {
      state = state * 1664525U + 1013904223U;
      if (state >> 29 == 0) continue;
      for (int k = 0; k < 12; ++k) {
        const int dx = (state >> 8) % 7, dy = (state >> 16) % 9;
        page.gray[std::size_t(80 + line * 19 + k) * 800 + x + dx] = 30;
        page.gray[std::size_t(80 + line * 19 + k) * 800 + x + dx + 1] = 30;
        if (k < 8) page.gray[std::size_t(80 + line * 19 + dy) * 800 + x + k] = 30;
      }
    }
  return page;
}

/// A body's oval with bone, airway and noise.
GrayImage ctSlice(double high) {
  GrayImage slice = evenly(512, 512, 0);
  unsigned state = 3;
  for (int y = 0; y < 512; ++y)
    for (int x = 0; x < 512; ++x) {
      state = state * 1664525U + 1013904223U;
      const double u = (x - 256) / 190.0, v = (y - 250) / high, noise = (state >> 24) / 16.0;
      double gray = 0;
      if (std::hypot(u, v) < 1) gray = 100 + noise;
      if (std::hypot(u, v - 0.3) < 0.22) gray = 230;
      if (std::hypot(u * 1.3, v + 0.3) < 0.14) gray = 5;
      slice.gray[std::size_t(y) * 512 + x] = std::uint8_t(gray);
    }
  return slice;
}

FovCapture sector() {
  FovCapture capture;
  capture.shape.shape = ProbeShape::Curvilinear;
  capture.shape.origin = {480, -20}, capture.shape.alpha_deg = 60, capture.shape.r1_px = 160, capture.shape.r2_px = 680;
  return capture;
}

TEST(FitFov, RefusesWhatShowsNoFieldOfView) {
  GrayImage noise = evenly(600, 500, 0);
  unsigned state = 1;
  for (std::uint8_t& gray : noise.gray) gray = std::uint8_t((state = state * 1664525U + 1013904223U) >> 24);
  for (const GrayImage& picture :
       {evenly(640, 480, 0), evenly(640, 480, 128), textPage(), ctSlice(150), ctSlice(190), noise}) {
    const auto fit = fitFov(picture);
    ASSERT_FALSE(fit) << picture.width << ' ' << fit->confidence;
    EXPECT_THAT(fit.error().message, HasSubstr("No field of view was found"));
  }
}

TEST(FitFov, RefusesPicturesOfNoUse) {
  EXPECT_THAT(fitFov(evenly(63, 400, 0)).error().message, HasSubstr("63 x 400"));
  GrayImage half = evenly(400, 400, 0);
  half.gray.resize(1000);
  EXPECT_THAT(fitFov(half).error().message, HasSubstr("not complete"));
}

TEST(FitFov, SaysWhatItDoubts) {
  FovCapture capture = sector();
  capture.darkOnLight = true;
  const auto fit = fitFov(test::paint(capture));
  ASSERT_TRUE(fit) << fit.error().message;
  EXPECT_GT(fit->confidence, 0.8);
  EXPECT_THAT(fit->warnings, Contains(HasSubstr("dark echoes on a light background")));
  EXPECT_THAT(fit->warnings, Contains(HasSubstr("type the depth")));
}

TEST(FitFov, RepeatsItself) {
  FovCapture capture = sector();
  capture.text = capture.shadows = true;
  const GrayImage picture = test::paint(capture);
  const auto one = fitFov(picture), two = fitFov(picture);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(one->shape.alpha_deg, two->shape.alpha_deg);
  EXPECT_EQ(one->shape.r1_px, two->shape.r1_px);
}

TEST(FitFov, ReadsLongAndShortMarks) {
  FovCapture capture = sector();
  capture.mark_px = 26, capture.longEvery = 2;
  const auto fit = fitFov(test::paint(capture));
  ASSERT_TRUE(fit && fit->ruler);
  EXPECT_NEAR(fit->ruler->spacing_px, 26, 0.1);
  EXPECT_EQ(fit->ruler->longEvery, 2);
  EXPECT_EQ(fit->ruler->mmPerMark, 5);
  EXPECT_EQ(fit->ruler->marks, 21) << "520 px at 26";
  capture.mark_px = 52, capture.longEvery = 0;
  const auto plain = fitFov(test::paint(capture));
  ASSERT_TRUE(plain && plain->ruler);
  EXPECT_EQ(plain->ruler->mmPerMark, 10);
}

TEST(FovShape, PointsFollowTheGeometry) {
  FovShape shape = sector().shape;
  shape.rotation_deg = 5;
  const PixelPoint end = pointAtFraction(shape, 0, 1);
  EXPECT_GT(end.x, shape.origin.x) << "leans to the right";
  EXPECT_NEAR(std::hypot(end.x - shape.origin.x, end.y - shape.origin.y), 680, 1e-9);
  EXPECT_LT(pointAtFraction(shape, -1, 1).x, end.x);
  shape.upsideDown = true;
  EXPECT_LT(pointAtFraction(shape, 0, 1).y, shape.origin.y);
  EXPECT_EQ(depthOf_px(shape), 520);
  EXPECT_GT(outlineOf(shape).size(), 60u);
  EXPECT_EQ(outlineOf(FovShape{}).size(), 4u);
}

TEST(ProbeFromFit, TakesWhatThePictureShows) {
  const Probe base = loadProbe("curvilinear").value();
  const auto probe = probeFromFit(sector().shape, 0.25, base, "ward 3");
  ASSERT_TRUE(probe) << probe.error().message;
  EXPECT_EQ(probe->name, "ward 3");
  EXPECT_EQ(probe->faceRadius_mm, 40);
  EXPECT_EQ(probe->fovAngle_deg, 60);
  EXPECT_EQ(probe->defaultDepth_mm, 130);
  EXPECT_EQ(probe->elevationFocus_mm, base.elevationFocus_mm);
  EXPECT_THAT(probeFromFit(sector().shape, 0, base, "x").error().message, HasSubstr("above 0"));
  EXPECT_THAT(probeFromFit(sector().shape, 2, base, "x").error().message, HasSubstr("faceRadius_mm"));
  FovShape flat;
  flat.width_px = 400, flat.depth_px = 500;
  const auto wide = probeFromFit(flat, 0.1, loadProbe("linear").value(), "flat");
  ASSERT_TRUE(wide);
  EXPECT_DOUBLE_EQ(wide->width_mm, 40);
  EXPECT_DOUBLE_EQ(wide->defaultDepth_mm, 50);
}

}  // namespace
}  // namespace insonate
