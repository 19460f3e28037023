#include <insonate/procedure/TipInView.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

/// An element of 5 mm under a lens at 20 mm, 7.5 MHz, by the slice's law: 0.66 mm at 16 mm, 0.29 mm more per mm toward
/// the face, 0.085 mm behind.
constexpr ImageField kLinear{.width_mm = 38,
                             .sliceHalf_mm = 0.33,
                             .elevationFocus_mm = 16,
                             .elevationDivergence = 0.29,
                             .elevationDivergenceBehind = 0.085};

TEST(TipInView, TheSliceIsThickestNearTheFace) {
  EXPECT_NEAR(maxOffPlane_mm(kLinear, 16), 0.66, 1e-9);
  EXPECT_NEAR(maxOffPlane_mm(kLinear, 10), 1.8610, 1e-4) << "hypot(0.66, 1.74)";
  EXPECT_NEAR(maxOffPlane_mm(kLinear, 0), 4.6868, 1e-4) << "hypot(0.66, 4.64)";
  EXPECT_NEAR(maxOffPlane_mm(kLinear, 36), 1.8236, 1e-4) << "hypot(0.66, 1.7)";
}

TEST(TipInView, WithoutADivergenceItIsThickAsAtTheFocus) {
  const ImageField old{.width_mm = 38, .sliceHalf_mm = 0.5544};
  EXPECT_NEAR(maxOffPlane_mm(old, 0), 1.1088, 1e-9);
  EXPECT_NEAR(maxOffPlane_mm(old, 40), 1.1088, 1e-9);
}

TEST(TipInView, ATipAtTenMillimetersIsShownInThePlaneAndHalfAMillimeterOffIt) {
  EXPECT_TRUE(isTipInView(kLinear, 40, {0, 0, 10}));
  EXPECT_TRUE(isTipInView(kLinear, 40, {0, 0.5, 10}));
  EXPECT_TRUE(isTipInView(kLinear, 40, {0, -1.85, 10}));
  EXPECT_FALSE(isTipInView(kLinear, 40, {0, 1.87, 10}));
  EXPECT_FALSE(isTipInView(kLinear, 40, {19.1, 0, 10})) << "beside the image";
  EXPECT_FALSE(isTipInView(kLinear, 40, {0, 0, 40.1})) << "below it";
  EXPECT_FALSE(isTipInView(kLinear, 40, {0, 0, -0.1})) << "above it";
}

}  // namespace
}  // namespace insonate
