#include "CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/cases/MaskFiles.h"
#include "unit/cases/StructureFiles.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

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
  test::writeStructureSet(folder_ / "RS.dcm", {{"Jugular vein left", {circle({6, 0, 0}, 4), circle({6, 0, 1}, 4)}},
                                               {"Carotid, left", {circle({-6, 0, 0}, 3)}}});
  const auto listed = run("import-labels " + at("case") + " " + at("RS.dcm") + " --list --json");
  ASSERT_EQ(listed.status, 0) << listed.errors;
  const json rows = json::parse(listed.output)["mapping"];
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0]["name_in_file"], "Jugular vein left");
  EXPECT_EQ(rows[0]["vessel"], "left jugular vein");
  EXPECT_EQ(rows[0]["label"], "vein");
  EXPECT_EQ(rows[1]["label"], "artery");

  const std::string replace = "import-labels " + at("case") + " " + at("RS.dcm") + " --replace ";
  expectRefusal(replace + "--only Carotid", "There is no structure \"Carotid\"");
  const auto one = run(replace + "--only 'Jugular vein left' --only-imported --json");
  ASSERT_EQ(one.status, 0) << one.errors;
  const json structures = json::parse(one.output)["structures"];
  ASSERT_EQ(structures.size(), 1U);
  EXPECT_EQ(structures[0]["name"], "vein");
  EXPECT_EQ(json::parse(run(replace + "--only 2 --only-imported --json").output)["structures"][0]["name"], "artery");
  EXPECT_EQ(run(replace).status, 0);
  ASSERT_EQ(run("export " + at("case") + " --seg " + at("seg.dcm")).status, 0);
}

TEST_F(ExchangeCommands, LabelsAreNotReplacedSilently) {
  ASSERT_EQ(run("export " + at("case") + " --labels " + at("l.seg.nrrd")).status, 0);
  expectRefusal("import-labels " + at("case") + " " + at("l.seg.nrrd"), "Add --replace");
  EXPECT_EQ(run("import-labels " + at("case") + " " + at("l.seg.nrrd") + " --replace").status, 0);
}

TEST_F(ExchangeCommands, AFolderOfMasksNamesVesselsAndTheRestIsLabeled) {
  PatientCase patient = test::cylinderNeck();
  const LabelMap truth = std::exchange(patient.labels, LabelMap(patient.ct.geometry));
  patient.manifest.vessels.clear();
  ASSERT_TRUE(writeCase(patient, folder_ / "neck"));
  fs::create_directories(folder_ / "seg");
  test::writeNiftiMask(folder_ / "seg/internal_jugular_vein_right.nii", test::maskOf(truth, kVein));
  test::writeNiftiMask(folder_ / "seg/common_carotid_artery_right.nii", test::maskOf(truth, kArtery));
  const std::string command = "import-labels " + at("neck") + " " + at("seg");

  const auto listed = run(command + " --list --json");
  ASSERT_EQ(listed.status, 0) << listed.errors;
  EXPECT_EQ(json::parse(listed.output)["mapping"][1]["vessel"], "right internal jugular vein");
  EXPECT_EQ(std::ranges::count(readCase(folder_ / "neck")->patient.labels.voxels, kVein), 0) << "nothing is changed";

  test::writeNiftiMask(folder_ / "seg/carotid_artery.nii", test::rod(truth.geometry, 4, -20, 3));
  expectRefusal(command, "--side NAME=left, right or both");
  expectRefusal(command + " --side carotid=left", "There is no structure");
  expectRefusal(command + " --side carotid_artery=up", "states no side");
  EXPECT_EQ(std::ranges::count(readCase(folder_ / "neck")->patient.labels.voxels, kVein), 0);

  const auto labeled = run(command + " --leave-out carotid_artery --json");
  ASSERT_EQ(labeled.status, 0) << labeled.errors;
  const json report = json::parse(labeled.output);
  EXPECT_THAT(report["missing"].dump(), HasSubstr("The left internal jugular vein is missing."));
  EXPECT_EQ(report["vessels"], json({"right common carotid artery", "right internal jugular vein"}));
  const auto back = readCase(folder_ / "neck");
  ASSERT_TRUE(back) << back.error().message;
  for (std::size_t v = 0; v < truth.voxels.size(); ++v)
    for (const std::uint8_t label : {kVein, kArtery})
      ASSERT_EQ(back->patient.labels.voxels[v] == label, truth.voxels[v] == label) << v;
  for (const std::uint8_t label : {kSkin, kMuscle, kAirway})
    EXPECT_GT(std::ranges::count(back->patient.labels.voxels, label), 0) << int(label);
  const NamedVessel& vein = back->patient.manifest.vessels.at(1);
  EXPECT_NEAR(vein.course.at(vein.course.size() / 2).position_mm.x, -30, 1);
  EXPECT_NEAR(vein.course.at(vein.course.size() / 2).radius_mm, 7, 0.5);
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
