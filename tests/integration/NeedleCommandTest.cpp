#include "RenderTest.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstring>
#include <vector>

namespace insonate {
namespace {

using nlohmann::json;
using test::bytesOf;
using test::shellWord;
using testing::HasSubstr;

/// The small block: a vein under the middle of the probe, its front wall 7 mm deep.
class NeedleCommand : public test::RenderTest {};

TEST_F(NeedleCommand, ShowsInTheSliceAndNotBesideIt) {
  const std::string without = picture("");
  EXPECT_NE(picture("--needle-tip 0,0,7"), without);
  EXPECT_EQ(picture("--needle-tip 0,9,7 --needle-direction 1,0,1"), without);
  EXPECT_NE(picture("--needle-tip=-3,4,11 --needle-direction 0,1,1"), without) << "across";
}

TEST_F(NeedleCommand, EveryOptionHasAnEffect) {
  const std::string usual = picture("--needle-tip 0,0,7");
  EXPECT_EQ(picture("--needle-tip 0,0,7 --needle-direction 2,0,2"), usual) << "of any length";
  for (const char* other : {"--needle-direction 1,0,0.5", "--needle-bevel 0,0,1", "--needle-diameter 0.8",
                            "--needle-length 4", "--tenting 2"})
    EXPECT_NE(picture(std::string("--needle-tip 0,0,7 ") + other), usual) << other;
  EXPECT_NE(picture("--needle-tip 0,0,7 --tenting 2"), picture("--needle-tip 0,0,7 --tenting 2 --tenting-radius 5"));
}

TEST_F(NeedleCommand, IsToldInThePatientAndInItsDisplacement) {
  const auto result =
      render("--json --needle-tip 2,0,7 --needle-direction 0,0,3 --tenting 2 --deformation none --displacement " +
             shellWord(out("u.nrrd")));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json needle = json::parse(result.output)["needle"];
  // The probe lies at the origin, x along the patient's x and into the body along y.
  EXPECT_NEAR(needle["tip_mm"][0], 2, 1e-6);
  EXPECT_NEAR(needle["tip_mm"][1], 7, 1e-6);
  EXPECT_NEAR(needle["direction"][1], 1, 1e-6);
  const std::string field = bytesOf(out("u.nrrd"));
  std::vector<float> shifts((field.size() - field.find("\n\n") - 2) / sizeof(float));
  std::memcpy(shifts.data(), field.data() + field.find("\n\n") + 2, shifts.size() * sizeof(float));
  EXPECT_NEAR(*std::min_element(shifts.begin(), shifts.end()), -2, 0.15) << "along y";
  EXPECT_FALSE(json::parse(render("--json").output).contains("needle"));
}

TEST_F(NeedleCommand, NonsenseIsRefusedWithASentence) {
  const auto expectRefusal = [&](const std::string& arguments, const std::string& words, int status) {
    const auto result = render(arguments);
    EXPECT_EQ(result.status, status) << arguments << '\n' << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words)) << arguments;
  };
  expectRefusal("--needle-tip 0,0,7 --needle-direction 0,0,0", "is 0,0,0", 1);
  expectRefusal("--needle-tip 0,0,7 --needle-diameter 9", "radius is 4.500 mm", 1);
  expectRefusal("--needle-tip 0,0,7 --needle-bevel 1,0,1", "faces along its shaft", 1);
  expectRefusal("--needle-tip 0,0,7 --tenting 40", "--tenting must be 0 to 30 mm", 1);
  expectRefusal("--needle-tip 0,0,7 --tenting 4 --tenting-radius 0", "--tenting-radius must be 1 to 30 mm", 1);
  expectRefusal("--tenting 4", "--needle-tip", 2);
  expectRefusal("--needle-tip 0,0", "--needle-tip", 2);
}

}  // namespace
}  // namespace insonate
