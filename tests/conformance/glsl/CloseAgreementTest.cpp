#include "conformance/glsl/CloseAgreement.h"
#include "conformance/glsl/CompactColor.h"
#include "glsl/Device.h"

namespace insonate::test {
namespace {

TEST(GlslCloseAgreement, InEveryBranchOfTheModel) {
  const auto device = glsl::Device::shared();
  if (!device) GTEST_SKIP() << device.error().message;
  const double limit = (*device)->context().device().software ? kCloseError : kCloseErrorOnCard;
  double worst = 0;
  for (const CompactCase& c : compactCases()) {
    const double error =
        errorOf(renderWith("glsl", c.probe, c.settings, *c.scene, c.pose, c.displacement, c.needle),
                renderWith("reference", c.probe, c.settings, *c.scene, c.pose, c.displacement, c.needle));
    EXPECT_LT(error, limit) << c.what;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_relative_error", std::to_string(worst));
}

TEST(GlslCloseAgreement, InEveryBranchOfColor) {
  const auto device = glsl::Device::shared();
  if (!device) GTEST_SKIP() << device.error().message;
  const double limit = (*device)->context().device().software ? kCloseError : kCloseErrorOnCard;
  const auto reference = makeColorDoppler("reference"), card = makeColorDoppler("glsl");
  double worst = 0;
  for (const CompactColor& c : compactColors()) {
    const double error = colorErrorOf(colorWith(**card, c), colorWith(**reference, c));
    EXPECT_LT(error, limit) << c.what;
    worst = std::max(worst, error);
  }
  EXPECT_EQ((*card)->name(), "glsl");
  RecordProperty("worst_relative_error", std::to_string(worst));
}

}  // namespace
}  // namespace insonate::test
