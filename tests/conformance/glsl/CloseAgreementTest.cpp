#include "conformance/glsl/CloseAgreement.h"

namespace insonate::test {
namespace {

TEST(GlslCloseAgreement, InEveryBranchOfTheModel) {
  if (auto engine = makeEngine("glsl"); !engine) GTEST_SKIP() << engine.error().message;
  double worst = 0;
  for (const CompactCase& c : compactCases()) {
    const double error =
        errorOf(renderWith("glsl", c.probe, c.settings, *c.scene, c.pose, c.displacement, c.needle),
                renderWith("reference", c.probe, c.settings, *c.scene, c.pose, c.displacement, c.needle));
    EXPECT_LT(error, kCloseError) << c.what;
    worst = std::max(worst, error);
  }
  RecordProperty("worst_relative_error", std::to_string(worst));
}

}  // namespace
}  // namespace insonate::test
