#include <insonate/procedure/PictureField.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

/// The built-in linear probe at 7.5 MHz: 5.4 wavelengths of 0.2053 mm, 1.1088 mm, at 20 mm; 0.085 mm more per mm off
/// it.
constexpr PictureField kLinear{
    .width_mm = 38, .sliceHalf_mm = 0.5544, .elevationFocus_mm = 20, .elevationDivergence = 0.085};

TEST(PictureField, TheSliceIsThickestFarFromItsFocus) {
  EXPECT_NEAR(shownOffPlane_mm(kLinear, 20), 1.1088, 1e-9);
  EXPECT_NEAR(shownOffPlane_mm(kLinear, 10), 1.3971, 1e-4) << "hypot(1.1088, 0.85)";
  EXPECT_NEAR(shownOffPlane_mm(kLinear, 0), 2.0297, 1e-4) << "hypot(1.1088, 1.7)";
  EXPECT_NEAR(shownOffPlane_mm(kLinear, 40), 2.0297, 1e-4);
}

TEST(PictureField, WithoutADivergenceItIsThickAsAtTheFocus) {
  const PictureField old{.width_mm = 38, .sliceHalf_mm = 0.5544};
  EXPECT_NEAR(shownOffPlane_mm(old, 0), 1.1088, 1e-9);
  EXPECT_NEAR(shownOffPlane_mm(old, 40), 1.1088, 1e-9);
}

TEST(PictureField, ATipAtTenMillimetersIsShownInThePlaneAndHalfAMillimeterOffIt) {
  EXPECT_TRUE(shows(kLinear, 40, {0, 0, 10}));
  EXPECT_TRUE(shows(kLinear, 40, {0, 0.5, 10}));
  EXPECT_TRUE(shows(kLinear, 40, {0, -1.39, 10}));
  EXPECT_FALSE(shows(kLinear, 40, {0, 1.41, 10}));
  EXPECT_FALSE(shows(kLinear, 40, {19.1, 0, 10})) << "beside the image";
  EXPECT_FALSE(shows(kLinear, 40, {0, 0, 40.1})) << "below it";
  EXPECT_FALSE(shows(kLinear, 40, {0, 0, -0.1})) << "above it";
}

}  // namespace
}  // namespace insonate
