#include "CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/cases/StructureFiles.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::shellWord;
using testing::HasSubstr;

/// export and import-labels, run as a user would.
class ExchangeCommands : public testing::Test {
 protected:
  void SetUp() override {
    const auto written = writeCase(test::smallCase(), folder_ / "case");
    ASSERT_TRUE(written) << written.error().message;
  }
  test::CommandResult run(const std::string& arguments) const {
    return test::runCommand(arguments, folder_ / "errors");
  }
  std::string at(const std::string& name) const { return shellWord(folder_ / name); }
  void expectRefusal(const std::string& arguments, const std::string& words, int status = 1) const {
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << arguments << '\n' << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words)) << arguments;
  }
  test::TemporaryFolder folder_;
};

TEST_F(ExchangeCommands, ACaseGoesOutAsDicomAndComesBack) {
  const auto written = run("export " + at("case") + " --dicom " + at("ct") + " --seg " + at("seg.dcm") + " --labels " +
                           at("l.seg.nrrd") + " --json");
  ASSERT_EQ(written.status, 0) << written.errors;
  EXPECT_EQ(json::parse(written.output)["written"]["seg"], (folder_ / "seg.dcm").string());
  ASSERT_EQ(run("import " + at("ct") + " " + at("back")).status, 0);
  const auto labeled = run("import-labels " + at("back") + " " + at("seg.dcm") + " --json");
  ASSERT_EQ(labeled.status, 0) << labeled.errors;
  const auto back = readCase(folder_ / "back");
  ASSERT_TRUE(back) << back.error().message;
  const PatientCase original = test::smallCase();
  EXPECT_EQ(back->patient.labels.voxels, original.labels.voxels);
  EXPECT_EQ(back->patient.ct.voxels, original.ct.voxels);
  EXPECT_EQ(back->patient.ct.geometry, original.ct.geometry);
  const json report = json::parse(labeled.output);
  const auto veins = std::ranges::count(original.labels.voxels, kVein);
  bool found = false;
  for (const json& row : report["structures"]) found = found || (row["name"] == "vein" && row["voxels"] == veins);
  EXPECT_TRUE(found) << labeled.output;
  EXPECT_TRUE(fs::exists(folder_ / "l.label.txt"));
}

TEST_F(ExchangeCommands, ContoursBecomeLabels) {
  using test::circle;
  test::writeStructureSet(folder_ / "RS.dcm", {{"Jugular vein", {circle({6, 0, 0}, 4), circle({6, 0, 1}, 4)}},
                                               {"Carotid, left", {circle({-6, 0, 0}, 3)}}});
  const auto listed = run("import-labels " + at("case") + " " + at("RS.dcm") + " --list --json");
  ASSERT_EQ(listed.status, 0) << listed.errors;
  const json rows = json::parse(listed.output)["structures"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["name"], "Jugular vein");
  EXPECT_EQ(rows[0]["contours"], 2);
  EXPECT_EQ(rows[1]["algorithm"], "MANUAL");
  EXPECT_EQ(rows[1]["type"], "ORGAN");
  EXPECT_THAT(run("import-labels " + at("case") + " " + at("RS.dcm") + " --list").output, HasSubstr("Carotid, left"));

  const std::string replace = "import-labels " + at("case") + " " + at("RS.dcm") + " --replace ";
  expectRefusal(replace + "--only Carotid", "contains no structure \"Carotid\"");
  const auto one = run(replace + "--only 'Jugular vein' --json");
  ASSERT_EQ(one.status, 0) << one.errors;
  const json structures = json::parse(one.output)["structures"];
  ASSERT_EQ(structures.size(), 1U);
  EXPECT_EQ(structures[0]["name"], "vein");
  EXPECT_EQ(json::parse(run(replace + "--only 2 --json").output)["structures"][0]["name"], "artery");
  EXPECT_EQ(run(replace).status, 0);
  ASSERT_EQ(run("export " + at("case") + " --seg " + at("seg.dcm")).status, 0);
  expectRefusal("import-labels " + at("case") + " " + at("seg.dcm") + " --list", "is not a complete RT Structure Set");
}

TEST_F(ExchangeCommands, LabelsAreNotReplacedSilently) {
  ASSERT_EQ(run("export " + at("case") + " --labels " + at("l.seg.nrrd")).status, 0);
  expectRefusal("import-labels " + at("case") + " " + at("l.seg.nrrd"), "Add --replace");
  EXPECT_EQ(run("import-labels " + at("case") + " " + at("l.seg.nrrd") + " --replace").status, 0);
}

TEST_F(ExchangeCommands, APartOfACaseOnAnotherSpacing) {
  const auto done =
      run("crop " + at("case") + " " + at("part") + " --from -10 -6 -8 --to 10 20 8 --spacing 0.5 --json");
  ASSERT_EQ(done.status, 0) << done.errors;
  EXPECT_EQ(json::parse(done.output)["size"], json({42, 54, 34}));
  const auto part = readCase(folder_ / "part");
  ASSERT_TRUE(part) << part.error().message;
  EXPECT_EQ(part->patient.manifest.targets.size(), 1U);
  EXPECT_EQ(part->patient.manifest.startPoses.size(), 1U);
  const auto& g = part->patient.ct.geometry;
  EXPECT_EQ(sampleNearest(part->patient.labels, g.indexFromPatient() * Vec3{0, 12, 0}), kVein);
  expectRefusal("crop " + at("case") + " " + at("part") + " --spacing 1", "already holds a case");
  expectRefusal("crop " + at("case") + " " + at("other"), "--from and --to, or --spacing", 2);
  expectRefusal("crop " + at("case") + " " + at("other") + " --from 900 0 0 --to 950 1 1", "contains no voxel");
  expectRefusal("crop " + at("case") + " " + at("other") + " --spacing 0.001", "mm");
}

TEST_F(ExchangeCommands, WhatCannotBeIsRefused) {
  expectRefusal("export " + at("case"), "--dicom, --seg or --labels", 2);
  expectRefusal("export " + at("none") + " --seg " + at("s.dcm"), "no case folder");
  expectRefusal("export " + at("case") + " --labels " + at("case/labels.seg.nrrd"), "file of the case itself");
  expectRefusal("export " + at("case") + " --labels " + at("l.nrrd"), ".seg.nrrd");
  expectRefusal("export " + at("case") + " --dicom " + at("case"), "not empty");
  expectRefusal("export " + at("case") + " --seg " + at("no/such/s.dcm"), "no/such");
  expectRefusal("import-labels " + at("case") + " " + at("none.dcm") + " --replace", "There is no file");
  expectRefusal("import-labels " + at("case") + " " + at("case/case.json") + " --replace", "contains no labels");
}

}  // namespace
}  // namespace insonate
