#include "integration/CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace insonate {
namespace {

using nlohmann::json;
using test::CommandResult;
using test::shellWord;
using testing::HasSubstr;

/// label, run as a user would.
class LabelCommand : public testing::Test {
 protected:
  void SetUp() override {
    PatientCase patient = test::smallCase();
    truth_ = patient.labels;
    std::ranges::fill(patient.labels.voxels, std::uint8_t{kSoftTissue});
    ASSERT_TRUE(writeCase(patient, folder_ / "case"));
    patient.labels = truth_;
    ASSERT_TRUE(writeCase(patient, folder_ / "truth"));
  }
  CommandResult run(const std::string& arguments) {
    return test::runCommand(arguments, (folder_ / "errors.txt").string());
  }
  std::string at(const std::string& name) { return shellWord((folder_ / name).string()); }
  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  LabelMap labelsOf(const std::string& name) {
    const auto read = readCase(folder_ / name);
    EXPECT_TRUE(read) << read.error().message;
    return read->patient.labels;
  }

  test::TemporaryFolder folder_;
  LabelMap truth_;
};

constexpr const char* kBoneRecipe = R"({"steps": [
  {"tool": "threshold", "label": "bone", "range_HU": [500, 2000]},
  {"tool": "paint", "label": "vein", "points_mm": [[0, 12, -8], [0, 12, 8]], "radius_mm": 5, "locked": ["bone"]}]})";

TEST_F(LabelCommand, ReplaysARecipeIntoTheCaseAndScoresIt) {
  write("recipe.json", kBoneRecipe);
  const CommandResult done =
      run("label " + at("case") + " " + at("recipe.json") + " --score " + at("truth") + " --json");
  ASSERT_EQ(done.status, 0) << done.errors;
  const json object = json::parse(done.output);
  ASSERT_EQ(object["steps"].size(), 2u);
  EXPECT_EQ(object["steps"][0]["tool"], "threshold");
  EXPECT_GT(object["steps"][0]["voxels"], 1000);
  double bone = 0, vein = 0;
  for (const json& row : object["scores"]) {
    if (row["label"] == "bone") bone = row["dice"];
    if (row["label"] == "vein") vein = row["dice"];
  }
  EXPECT_EQ(bone, 1);
  EXPECT_GT(vein, 0.9);
  const LabelMap labels = labelsOf("case");
  EXPECT_EQ(std::ranges::count(labels.voxels, std::uint8_t{kBone}),
            std::ranges::count(truth_.voxels, std::uint8_t{kBone}));
}

TEST_F(LabelCommand, WithOutTheCaseStaysAsItIs) {
  write("recipe.json", kBoneRecipe);
  const LabelMap before = labelsOf("case");
  const CommandResult done = run("label " + at("case") + " " + at("recipe.json") + " --out " + at("other"));
  ASSERT_EQ(done.status, 0) << done.errors;
  EXPECT_EQ(labelsOf("case").voxels, before.voxels);
  EXPECT_NE(labelsOf("other").voxels, before.voxels);
  const CommandResult again = run("label " + at("case") + " " + at("recipe.json") + " --out " + at("other"));
  EXPECT_EQ(again.status, 1) << "another case is not written over";
  EXPECT_THAT(again.errors, HasSubstr("already holds a case"));
}

TEST_F(LabelCommand, ARecipeBringsTheNamesOfItsLabels) {
  write("recipe.json", R"({"labels": [{"label": 20, "name": "port", "tissue": "bone"}],
    "steps": [{"tool": "paint", "label": 20, "points_mm": [[0, 12, 0]], "radius_mm": 5}]})");
  const CommandResult done = run("label " + at("case") + " " + at("recipe.json"));
  ASSERT_EQ(done.status, 0) << done.errors;
  const auto read = readCase(folder_ / "case");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->patient.manifest.ownLabels, (OwnLabels{{20, {"port", kBone}}}));
  EXPECT_TRUE(std::ranges::count(read->patient.labels.voxels, 20));
}

TEST_F(LabelCommand, ScoresWithoutARecipeAndWritesNothing) {
  const std::string before = test::bytesOf(folder_ / "case/labels.seg.nrrd");
  const CommandResult done = run("label " + at("case") + " --score " + at("truth/labels.seg.nrrd"));
  ASSERT_EQ(done.status, 0) << done.errors;
  EXPECT_THAT(done.output, HasSubstr("bone"));
  EXPECT_EQ(test::bytesOf(folder_ / "case/labels.seg.nrrd"), before);
}

TEST_F(LabelCommand, BadRecipesAreRefusedAndChangeNothing) {
  const std::string before = test::bytesOf(folder_ / "case/labels.seg.nrrd");
  write("bad.json", R"({"steps": [{"tool": "threshhold", "label": "bone"}]})");
  const CommandResult bad = run("label " + at("case") + " " + at("bad.json"));
  EXPECT_EQ(bad.status, 1);
  EXPECT_THAT(bad.errors, HasSubstr("step 1 has the unknown tool 'threshhold'; did you mean 'threshold'?"));
  write("late.json", R"({"steps": [{"tool": "threshold", "label": "bone", "range_HU": [500, 2000]},
                                   {"tool": "vessel", "label": "vein", "points_mm": [[0, 12, -8], [0, 12, 8]]}]})");
  const CommandResult late = run("label " + at("case") + " " + at("late.json"));
  EXPECT_EQ(late.status, 1);
  EXPECT_THAT(late.errors, HasSubstr("Step 2 (vessel) of the recipe could not be done"));
  EXPECT_EQ(run("label " + at("case") + " no-such-recipe").status, 1);
  EXPECT_EQ(run("label " + at("case")).status, 2);
  EXPECT_EQ(test::bytesOf(folder_ / "case/labels.seg.nrrd"), before);
}

TEST_F(LabelCommand, ListsItsRecipes) {
  const CommandResult listed = run("label --list --json");
  ASSERT_EQ(listed.status, 0) << listed.errors;
  EXPECT_EQ(json::parse(listed.output)["recipes"][0]["name"], "neck-automatic");
}

}  // namespace
}  // namespace insonate
