#include "integration/CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace insonate::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// The small block with a long vein along z, toward the feet.
class WireCommand : public testing::Test {
 protected:
  void SetUp() override {
    PatientCase patient = smallCase();
    NamedVessel vein{"right internal jugular vein", kVein, {}};
    for (double z = 100; z >= -60; z -= 5) vein.course.push_back({{0, 12, z}, 5});
    patient.manifest.vessels = {vein};
    patient.manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
    const auto written = writeCase(patient, folder_ / "case");
    ASSERT_TRUE(written) << written.error().message;
  }
  CommandResult wire(const std::string& arguments) const {
    return runCommand("wire " + shellWord((folder_ / "case").string()) + " " + arguments,
                      (folder_ / "errors.txt").string());
  }
  TemporaryFolder folder_;
};

TEST_F(WireCommand, RunsTowardTheHeartFromTheTarget) {
  const auto result = wire("--length 120 --json --out " + shellWord((folder_ / "wire.json").string()));
  ASSERT_EQ(result.status, 0) << result.errors;
  const json report = json::parse(result.output);
  EXPECT_NEAR(report["inserted_mm"].get<double>(), 120, 1e-6);
  EXPECT_EQ(report["refusal"], "");
  EXPECT_EQ(report["steps"].size(), 12U);
  EXPECT_LT(report["nodes_mm"].back()[2].get<double>(), -90) << "toward the feet";
  std::ifstream file(folder_ / "wire.json");
  const json rod = json::parse(file);
  EXPECT_EQ(rod["kind"], "guidewire");
  EXPECT_EQ(rod["nodes_mm"], report["nodes_mm"]);
}

TEST_F(WireCommand, SteepNeedleAndTissueAreRefusalsOfTheWireNotOfTheCommand) {
  const auto steep = wire("--angle 88 --length 200");
  EXPECT_EQ(steep.status, 0);
  EXPECT_THAT(steep.output, HasSubstr("too steep"));
  const auto tissue = wire("--needle 0,30,0 --direction 0,1,-1 --json");
  ASSERT_EQ(tissue.status, 0) << tissue.errors;
  EXPECT_EQ(json::parse(tissue.output)["refusal"], "through the posterior wall");
  EXPECT_EQ(json::parse(tissue.output)["tip_in"], "tissue");
}

TEST_F(WireCommand, RenderShowsTheWire) {
  const std::string file = shellWord((folder_ / "wire.json").string());
  ASSERT_EQ(wire("--length 10 --out " + file).status, 0);
  const auto render = [&](const std::string& arguments) {
    const std::string image = (folder_ / "image.png").string();
    const auto result = runCommand("render " + shellWord((folder_ / "case").string()) + " --engine cpu --out " +
                                       shellWord(image) + " " + arguments,
                                   (folder_ / "errors.txt").string());
    return std::pair(result, bytesOf(image));
  };
  const auto [plain, without] = render("");
  ASSERT_EQ(plain.status, 0) << plain.errors;
  const auto [shown, with] = render("--wire " + file);
  EXPECT_EQ(shown.status, 0) << shown.errors;
  EXPECT_NE(with, without);
  std::ofstream(folder_ / "bad.json") << R"({"kind":"guidewire","diameter_mm":0.8,"nodes_mm":[[0,0]]})";
  EXPECT_THAT(render("--wire " + shellWord((folder_ / "bad.json").string())).first.errors, HasSubstr("three numbers"));
  EXPECT_THAT(render("--wire none.json").first.errors, HasSubstr("none.json"));
}

TEST_F(WireCommand, NonsenseIsRefusedWithASentence) {
  EXPECT_THAT(wire("--wire rope").errors, HasSubstr("rope"));
  EXPECT_THAT(wire("--length 0").errors, HasSubstr("--length"));
  EXPECT_THAT(wire("--needle 0,12,0 --direction 0,0,0").errors, HasSubstr("--direction"));
  EXPECT_THAT(wire("--needle 0,12,0 --direction 0,0,1 --bevel 0,0,1").errors, HasSubstr("--bevel"));
  EXPECT_EQ(wire("--needle 0,12,0").status, 2);
  EXPECT_EQ(wire("--angle 120").status, 2);
}

}  // namespace
}  // namespace insonate::test
