#include <insonate/ultrasound/Needle.h>

#include <gmock/gmock.h>

#include <cmath>

namespace insonate {
namespace {

using testing::HasSubstr;

std::string refusalOf(const Needle& needle) {
  const auto ok = validate(needle);
  return ok ? std::string() : ok.error().message;
}

TEST(Needle, OfEighteenGaugeIsValid) {
  EXPECT_EQ(refusalOf({}), "");
  EXPECT_EQ(refusalOf({.tip_mm = {3, -50, 7}, .direction = {0.6, 0, 0.8}, .bevelNormal = {0, 0, -1}}), "");
}

TEST(Needle, OutOfRangeIsRefusedWithASentence) {
  EXPECT_THAT(refusalOf({.radius_mm = 3}), HasSubstr("radius is 3.000 mm; allowed is 0.100 to 2.000 mm"));
  EXPECT_THAT(refusalOf({.length_mm = 0}), HasSubstr("length is 0.000 mm"));
  EXPECT_THAT(refusalOf({.direction = {0, 0, 2}}), HasSubstr("direction is 2.000 long; give a vector of length 1"));
  EXPECT_THAT(refusalOf({.direction = {0, 0, 0}}), HasSubstr("length 1"));
  EXPECT_THAT(refusalOf({.bevelNormal = {0, 0, 3}}), HasSubstr("faces along its shaft"));
  EXPECT_THAT(refusalOf({.bevelNormal = {}}), HasSubstr("faces along its shaft"));
  EXPECT_THAT(refusalOf({.tip_mm = {0, std::nan(""), 0}}), HasSubstr("not finite"));
  EXPECT_THAT(refusalOf({.radius_mm = std::nan("")}), HasSubstr("radius"));
}

}  // namespace
}  // namespace insonate
