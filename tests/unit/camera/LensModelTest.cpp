#include "HandScene.h"
#include "LensDerivative.h"
#include "support/TestData.h"

#include <gmock/gmock.h>

#include <random>

namespace insonate::test {
namespace {

TEST(LensModel, ARayArrivesAtItsPixel) {
  const LensModel lens = laptopLens();
  for (double y = 0; y <= 720; y += 60)
    for (double x = 0; x <= 1280; x += 64) {
      const auto pixel = project(lens, rayThrough(lens, {x, y}) * 400);
      ASSERT_TRUE(pixel);
      EXPECT_NEAR(pixel->x, x, 1e-6);
      EXPECT_NEAR(pixel->y, y, 1e-6);
    }
}

TEST(LensModel, DerivativesAreThoseOfDifferences) {
  const LensModel lens = laptopLens();
  const Vec3 p{80, -60, 420};
  const auto at = camera::projectWithDerivative(lens, p);
  ASSERT_TRUE(at);
  constexpr double kStep = 1e-3;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 moved = p, back = p;
    moved[axis] += kStep, back[axis] -= kStep;
    const auto a = project(lens, moved), b = project(lens, back);
    EXPECT_NEAR(at->dx[axis], (a->x - b->x) / (2 * kStep), 1e-6);
    EXPECT_NEAR(at->dy[axis], (a->y - b->y) / (2 * kStep), 1e-6);
  }
}

TEST(LensModel, PointsBehindTheCameraAndBeyondTheDistortionHaveNoPixel) {
  LensModel lens = laptopLens();
  EXPECT_FALSE(project(lens, {0, 0, -100}));
  lens.k1 = -0.5, lens.k2 = 0;
  EXPECT_TRUE(project(lens, {10, 0, 100}));
  EXPECT_FALSE(project(lens, {200, 0, 100})) << "the image would turn back";
}

TEST(LensModel, FileKeepsAllValues) {
  const TemporaryFolder folder;
  const LensModel lens = laptopLens();
  ASSERT_TRUE(writeLens(lens, folder / "lens.json"));
  const auto read = readLens(folder / "lens.json");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(lensText(*read), lensText(lens));
  EXPECT_THAT(parseLens("{}").error().message, testing::HasSubstr("width"));
  EXPECT_THAT(readLens(folder / "none.json").error().message, testing::HasSubstr("none.json"));
}

}  // namespace
}  // namespace insonate::test
