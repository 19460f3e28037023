#include "Neck.h"
#include "ui/support/Screen.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/views/UltrasoundView.h>

#include <gtest/gtest.h>

#include <numeric>

namespace insonate::views {
namespace {

using test::Picture;
using test::Screen;

ImageBounds boundsOf(const Probe& probe, const ImagingSettings& settings) {
  const BeamGrid grid(probe, settings);
  return {grid.minLateral_mm(), grid.maxLateral_mm(), grid.minAxial_mm(), grid.maxAxial_mm()};
}

/// Bright around one pixel.
BModeImage dot(int width, int height, int x, int y) {
  BModeImage image{
      width, height, 0.1, -0.05 * (width - 1), 0.05, std::vector<std::uint8_t>(std::size_t(width) * height)};
  for (int row = std::max(0, y - 2); row <= y + 2; ++row)
    for (int column = std::max(0, x - 2); column <= x + 2; ++column)
      image.gray[std::size_t(row) * width + column] = 255;
  return image;
}

TEST(UltrasoundView, PictureAndDisplayAreInverse) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 0, 0));
  view.resize(900, 700);
  for (const bool mirrored : {false, true}) {
    view.setMirrored(mirrored);
    const ImagePoint point = view.imageFromDisplay(view.displayFromImage({7.5, 12.25}));
    EXPECT_NEAR(point.lateral_mm, 7.5, 1e-9);
    EXPECT_NEAR(point.axial_mm, 12.25, 1e-9);
  }
  EXPECT_TRUE(view.isOnImage(view.displayFromImage({0, 10})));
  EXPECT_FALSE(view.isOnImage(view.displayFromImage({25, 10})));
}

TEST(UltrasoundView, TheMarkerStandsAtThePictureAlsoWithRoomAroundIt) {
  UltrasoundView view;
  const BModeImage image = dot(400, 300, 0, 0);
  view.setImage(image);
  view.setBounds(ImageBounds{-30, 30, 0, 40});
  Screen screen(view, 900, 700);
  const auto expectMarkerAt = [&](double lateral_mm) {
    for (const bool mirrored : {false, true}) {
      view.setMirrored(mirrored);
      const Picture picture = screen.picture();
      const DisplayPoint corner = view.displayFromImage({lateral_mm, 0});
      const auto at = picture.at(int(corner.x) + (mirrored ? 5 : -5), int(corner.y) - 12);
      EXPECT_GT(at[2], at[0] + 60) << lateral_mm << " mm, mirrored " << mirrored;
    }
  };
  expectMarkerAt(20);
  // The image is wider than the field of view that is being edited.
  view.setGuide({{{-12, 2}, {12, 2}, {12, 28}, {-12, 28}}, {}, {}});
  expectMarkerAt(12);
}

/// Number of light pixels above a corner of the image, where its side of the patient is marked.
int inkAbove(const Picture& picture, DisplayPoint corner, bool isRight) {
  int ink = 0;
  for (int y = int(corner.y) - 20; y < int(corner.y) - 4; ++y)
    for (int x = 12; x < 60; ++x) ink += picture.at(int(corner.x) + (isRight ? -x : x), y)[0] > 150;
  return ink;
}

TEST(UltrasoundView, ItsSidesAreMarkedByTheDirectionOfTheProbe) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 0, 0));
  Screen screen(view, 900, 700);
  const auto inkAt = [&](bool left) {
    return inkAbove(screen.picture(), view.displayFromImage({left ? -20.0 : 20.0, 0}), !left);
  };
  // Beside the corner's own letter: words are longer than letters.
  EXPECT_EQ(inkAt(true) + inkAt(false), 0) << "no pose, no marks";
  view.setLateral(Vec3{0, 0, 1});
  const int foot = inkAt(true), head = inkAt(false);
  EXPECT_GT(foot, 20);
  EXPECT_GT(head, 20);
  EXPECT_NE(foot, head);
  view.setMirrored(true);
  EXPECT_NEAR(inkAbove(screen.picture(), view.displayFromImage({20, 0}), false), head, 12);
  view.setMirrored(false);
  view.setLateral(std::nullopt);
  EXPECT_EQ(inkAt(true) + inkAt(false), 0);
}

TEST(UltrasoundView, ATurnWithinTheSameMarksIsNoNewLayout) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 0, 0));
  view.setLateral(Vec3{1, 0, 0});
  Screen screen(view, 900, 700);
  screen.picture();
  int wanted = 0;
  view.setRenderRequested([&] { ++wanted; });
  view.setLateral(normalized(Vec3{1, 0.2, 0.9}));
  EXPECT_EQ(wanted, 0);
  view.setLateral(normalized(Vec3{0.9, 0.2, 1}));
  EXPECT_EQ(wanted, 1) << "past 45 degrees";
}

TEST(UltrasoundView, AnEchoAppearsWhereItsMillimetresSay) {
  UltrasoundView view;
  const BModeImage image = dot(400, 300, 290, 71);
  view.setImage(image);
  Screen screen(view, 900, 700);
  for (const bool mirrored : {false, true}) {
    view.setMirrored(mirrored);
    const Picture picture = screen.picture();
    const DisplayPoint at =
        view.displayFromImage({image.left_mm + 290 * image.pixel_mm, image.top_mm + 71 * image.pixel_mm});
    EXPECT_GT(picture.at(int(at.x), int(at.y))[0], 200) << mirrored;
    EXPECT_EQ(at.x > 450, !mirrored);
    const DisplayPoint off =
        view.displayFromImage({image.left_mm + 270 * image.pixel_mm, image.top_mm + 71 * image.pixel_mm});
    EXPECT_LT(picture.at(int(off.x), int(off.y))[0], 30);
  }
}

TEST(UltrasoundView, GrayValuesAreShownAsTheyAre) {
  BModeImage image{256, 128, 0.1, -12.75, 0.05, std::vector<std::uint8_t>(256 * 128)};
  for (int row = 0; row < 128; ++row)
    for (int column = 0; column < 256; ++column) image.gray[row * 256 + column] = static_cast<std::uint8_t>(column);
  UltrasoundView view;
  view.setImage(image);
  Screen screen(view, 700, 400);
  const Picture picture = screen.picture();
  for (const int gray : {0, 1, 40, 128, 200, 254}) {
    const DisplayPoint at = view.displayFromImage({image.left_mm + gray * image.pixel_mm, 6});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(picture.at(int(at.x), int(at.y))[c], gray, 1);
  }
}

TEST(UltrasoundView, AnImageThatDoesNotBelongHereIsDimAndCarriesWords) {
  BModeImage image{400, 300, 0.1, -19.95, 0.05, std::vector<std::uint8_t>(std::size_t(400) * 300, 200)};
  UltrasoundView view;
  view.setImage(image);
  Screen screen(view, 900, 700);
  const DisplayPoint aside = view.displayFromImage({-15, 5}), middle = view.displayFromImage({0, 15});
  const auto wordPixels = [&](const Picture& picture) {
    int count = 0;
    for (int y = int(middle.y) - 15; y < int(middle.y) + 15; ++y)
      for (int x = int(middle.x) - 150; x < int(middle.x) + 150; ++x)
        count += picture.at(x, y)[0] > picture.at(x, y)[2] + 60;
    return count;
  };
  EXPECT_NEAR(screen.picture().at(int(aside.x), int(aside.y))[0], 200, 1);
  EXPECT_EQ(wordPixels(screen.picture()), 0);
  view.setStaleMark("Image of the previous position");
  EXPECT_NEAR(screen.picture().at(int(aside.x), int(aside.y))[0], 70, 2);
  EXPECT_GT(wordPixels(screen.picture()), 300);
  view.setStaleMark({});
  EXPECT_NEAR(screen.picture().at(int(aside.x), int(aside.y))[0], 200, 1);
  EXPECT_EQ(wordPixels(screen.picture()), 0);
}

TEST(UltrasoundView, PixelsAreSquareAndThePictureAsLargeAsFits) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 0, 0));
  for (const auto& [width, height] : {std::pair{1200, 500}, {500, 1200}}) {
    view.resize(width, height);
    const DisplayPoint a = view.displayFromImage({0, 0}), b = view.displayFromImage({10, 10});
    EXPECT_NEAR(b.x - a.x, b.y - a.y, 1e-9);
    const DisplayPoint low = view.displayFromImage({-20, 0}), high = view.displayFromImage({20, 30});
    const bool wide = high.x - low.x > width - 110, tall = high.y - low.y > height - 60;
    EXPECT_TRUE(wide || tall);
    EXPECT_LE(high.x, width);
    EXPECT_LE(high.y, height);
  }
}

TEST(UltrasoundView, ALivePictureReplacesGrayValuesOnly) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 100, 100));
  Screen screen(view, 900, 700);
  screen.picture();
  int wanted = 0;
  view.setRenderRequested([&] { ++wanted; });
  view.setImage(dot(400, 300, 300, 100));
  EXPECT_EQ(wanted, 1);
  const Picture after = screen.picture();
  const DisplayPoint old = view.displayFromImage({-9.95, 10.05}), now = view.displayFromImage({10.05, 10.05});
  EXPECT_LT(after.at(int(old.x), int(old.y))[0], 30);
  EXPECT_GT(after.at(int(now.x), int(now.y))[0], 200);
}

TEST(UltrasoundView, BlackAroundThePictureAndNothingWithoutOne) {
  UltrasoundView view;
  Screen screen(view, 300, 200);
  const Picture empty = screen.picture();
  EXPECT_EQ(std::accumulate(empty.rgb.begin(), empty.rgb.end(), 0), 0);
  BModeImage wrong = dot(40, 30, 0, 0);
  wrong.gray.resize(7);
  view.setImage(wrong);
  EXPECT_EQ(std::accumulate(empty.rgb.begin(), empty.rgb.end(), 0), 0);
}

TEST(UltrasoundView, ANoticeIsReadWholeHoweverNarrowTheView) {
  UltrasoundView view;
  view.setImage(dot(400, 300, 200, 150));
  view.setFrozen(true);
  view.setNotice("ONLY shadows behind boundaries");
  for (const int width : {240, 900}) {
    Screen screen(view, width, 400);
    const Picture picture = screen.picture();
    int yellow = 0, cut = 0;
    for (int y = 0; y < 26; ++y)
      for (int x = 0; x < width; ++x) {
        const std::uint8_t* at = picture.at(x, y);
        const bool letter = at[0] > 120 && at[2] < at[0] / 2;
        yellow += letter;
        cut += letter && (x < 3 || x >= width - 3);
      }
    EXPECT_GT(yellow, 60) << width;
    EXPECT_EQ(cut, 0) << width;
  }
}

TEST(UltrasoundView, WithoutAPictureItSaysWhatToWaitFor) {
  UltrasoundView view;
  view.setNotice("Building the first picture ...");
  Screen screen(view, 400, 200);
  const Picture picture = screen.picture();
  int lit = 0;
  for (int y = 85; y < 115; ++y)
    for (int x = 60; x < 340; ++x) lit += picture.at(x, y)[1] > 90;
  EXPECT_GT(lit, 200);
}

TEST(UltrasoundView, Golden) {
  UltrasoundView view;
  view.setImage(test::neck().image);
  view.setBounds(boundsOf(test::neck().setup.probe, test::neck().setup.settings));
  view.setFocus(test::neck().setup.settings.focus_mm);
  Screen screen(view, 480, 440);
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/ultrasound"));
  view.setFrozen(true);
  view.setTgc(std::vector<double>{-4, -2, 0, 1, 2, 4, 6, 8});
  view.setCalipers({{CaliperKind::Distance, {{{-6, 3}, {8, 9}, {}}}},
                    {CaliperKind::Ellipse, {{{-7, 17}, {7, 16}, {0, 21}}}},
                    {CaliperKind::Angle, {{{-14, 8}, {-12, 20}, {-6, 14}}}}});
  EXPECT_TRUE(test::looksLikeGolden(screen.picture(), "views/ultrasound-frozen"));
}

}  // namespace
}  // namespace insonate::views
