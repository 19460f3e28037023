#include "integration/CommandLine.h"
#include "support/TestData.h"
#include "unit/cases/MaskFiles.h"

#include <insonate/cases/PatientCase.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::CommandResult;
using test::shellWord;
using testing::HasSubstr;
using testing::Not;

/// A round body with fat, airway and spine; `radius_mm` makes each patient another one.
CtVolume roundNeck(double radius_mm) {
  VolumeGeometry grid;
  grid.size = {72, 72, 36};
  grid.spacing_mm = {2, 2, 2};
  grid.origin_mm = {-71, -71, -35};
  CtVolume ct(grid, -1000);
  for (int k = 0; k < 36; ++k)
    for (int j = 0; j < 72; ++j)
      for (int i = 0; i < 72; ++i) {
        const double x = -71 + 2 * i, y = -71 + 2 * j, fromAxis = std::hypot(x, y);
        if (fromAxis > radius_mm) continue;
        std::int16_t value = fromAxis > radius_mm - 8 && fromAxis < radius_mm - 3 ? -100 : 50;
        if (std::hypot(x, y + 10) < 9) value = -1000;
        if (const double fromSpine = std::hypot(x, y - 25); fromSpine < 14) value = fromSpine < 9 ? 250 : 1300;
        ct.at(i, j, k) = value;
      }
  return ct;
}

std::string bytesOf(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class PrepareCommand : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    studies_ = new test::TemporaryFolder;
    for (int n = 1; n <= 3; ++n) {
      PatientCase patient;
      patient.ct = roundNeck(50 + 4 * n);
      patient.labels = LabelMap(patient.ct.geometry);
      const fs::path folder = *studies_ / ("patient " + std::to_string(n));
      fs::create_directories(folder);
      ASSERT_TRUE(writeCase(patient, folder / "case"));
      fs::rename(folder / "case" / "ct.nrrd", folder / "scan.nrrd");
      fs::remove_all(folder / "case");
    }
  }
  static void TearDownTestSuite() { delete studies_; }
  static std::string study(int n) { return (*studies_ / ("patient " + std::to_string(n)) / "scan.nrrd").string(); }
  CommandResult prepare(const std::string& library, const std::string& options = {}) {
    std::string arguments = "prepare";
    for (int n = 1; n <= 3; ++n) arguments += " " + shellWord(study(n));
    return test::runCommand(arguments + " --out " + shellWord((folder_ / library).string()) + " " + options,
                            (folder_ / "errors.txt").string());
  }
  std::set<std::string> casesIn(const std::string& library) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_ / library))
      if (fs::exists(entry.path() / "case.json")) names.insert(entry.path().filename().string());
    return names;
  }
  std::string page(const std::string& library) { return bytesOf(folder_ / library / "report" / "index.html"); }

  static inline test::TemporaryFolder* studies_ = nullptr;
  test::TemporaryFolder folder_;
};

TEST_F(PrepareCommand, EachStudyBecomesALabeledCaseOnThePage) {
  const CommandResult done = prepare("library", "--json");
  ASSERT_EQ(done.status, 0) << done.errors;
  EXPECT_EQ(json::parse(done.output)["prepared"], 3);
  const auto cases = casesIn("library");
  ASSERT_EQ(cases.size(), 3U);
  for (const std::string& name : cases) {
    const auto read = readCase(folder_ / "library" / name);
    ASSERT_TRUE(read) << read.error().message;
    for (const Label label : {kSkin, kFat, kBone, kAirway})
      EXPECT_TRUE(std::ranges::count(read->patient.labels.voxels, std::uint8_t(label)) > 100)
          << name << " " << int(label);
  }
  EXPECT_THAT(page("library"), HasSubstr("3 prepared, 0 not prepared"));
  EXPECT_THAT(page("library"), HasSubstr("No voxel is labeled vein")) << "the author reads what is left to do";
  EXPECT_THAT(page("library"), Not(HasSubstr("patient 1"))) << "a folder may have a patient's name";
  for (const std::string& name : cases)
    for (const char* image : {"slice1.png", "coronal.png", "front.png", "ultrasound1.png"})
      EXPECT_TRUE(bytesOf(folder_ / "library" / "report" / name.substr(5) / image).starts_with("\x89PNG")) << image;
}

/// The results of another program beside the CT: the case is ready but for the author's look.
TEST_F(PrepareCommand, SegmentationsBesideTheCtNameVesselsAndPlaceTargets) {
  const fs::path study = folder_ / "study";
  fs::create_directories(study / "labels" / "headneck_bones_vessels");
  fs::create_directories(study / "labels" / "total");
  fs::copy(this->study(1), study / "scan.nrrd");
  LabelMap vein(roundNeck(54).geometry), artery(vein.geometry);
  for (int k = 0; k < 36; ++k)
    for (int j = 0; j < 72; ++j)
      for (int i = 0; i < 72; ++i) {
        const double x = -71 + 2 * i, y = -71 + 2 * j;
        vein.at(i, j, k) = std::hypot(x + 26, y + 22) < 7;
        artery.at(i, j, k) = std::hypot(x + 14, y + 4) < 4;
      }
  test::writeNiftiMask(study / "labels/headneck_bones_vessels/internal_jugular_vein_right.nii", vein);
  test::writeNiftiMask(study / "labels/total/common_carotid_artery_right.nii", artery);
  const CommandResult done =
      test::runCommand("prepare " + shellWord(study.string()) + " --out " + shellWord((folder_ / "library").string()),
                       (folder_ / "errors.txt").string());
  ASSERT_EQ(done.status, 0) << done.errors;
  ASSERT_EQ(casesIn("library").size(), 1U);
  const auto read = readCase(folder_ / "library" / *casesIn("library").begin());
  ASSERT_TRUE(read) << read.error().message;
  const CaseManifest& manifest = read->patient.manifest;
  EXPECT_EQ(manifest.vessels.size(), 2U);
  ASSERT_EQ(manifest.targets.size(), 1U);
  EXPECT_EQ(manifest.targets[0].name, "right internal jugular vein");
  EXPECT_EQ(manifest.startPoses.size(), 2U);
  EXPECT_GT(std::ranges::count(read->patient.labels.voxels, std::uint8_t(kSkin)), 100);
}

TEST_F(PrepareCommand, AnInterruptedCommandIsRepeatedWithoutDoingItsWorkTwice) {
  ASSERT_EQ(prepare("library").status, 0);
  const auto cases = casesIn("library");
  // One job was killed between the case and its report.
  const std::string killed = cases.begin()->substr(std::string("case-").size());
  fs::remove_all(folder_ / "library" / "report" / killed);
  const std::string kept = *std::next(cases.begin());
  const auto before = fs::last_write_time(folder_ / "library" / kept / "ct.nrrd");
  const CommandResult again = prepare("library", "--json");
  ASSERT_EQ(again.status, 0) << again.errors;
  EXPECT_EQ(json::parse(again.output)["prepared"], 1);
  EXPECT_EQ(json::parse(again.output)["prepared_before"], 2);
  EXPECT_EQ(fs::last_write_time(folder_ / "library" / kept / "ct.nrrd"), before);
  EXPECT_EQ(casesIn("library"), cases);
  EXPECT_THAT(page("library"), HasSubstr("3 prepared"));
}

TEST_F(PrepareCommand, ShardsTogetherMakeTheSameCases) {
  ASSERT_EQ(prepare("whole").status, 0);
  int prepared = 0;
  for (const char* shard : {"1/3", "2/3", "3/3"}) {
    const CommandResult part = prepare("parts", std::string("--json --shard ") + shard);
    ASSERT_EQ(part.status, 0) << part.errors;
    prepared += json::parse(part.output)["prepared"].get<int>();
  }
  EXPECT_EQ(prepared, 3) << "each study by one shard";
  EXPECT_EQ(casesIn("parts"), casesIn("whole"));
  for (const std::string& name : casesIn("whole"))
    for (const char* file : {"ct.nrrd", "labels.seg.nrrd", "case.json"})
      EXPECT_EQ(bytesOf(folder_ / "parts" / name / file), bytesOf(folder_ / "whole" / name / file)) << name << file;
  EXPECT_EQ(page("parts"), page("whole"));
}

TEST_F(PrepareCommand, AStudyThatFailsDoesNotStopTheOthers) {
  std::ofstream(folder_ / "<b>notes.nrrd") << "no volume";
  const CommandResult done =
      test::runCommand("prepare " + shellWord((folder_ / "<b>notes.nrrd").string()) + " " + shellWord(study(1)) +
                           " --out " + shellWord((folder_ / "library").string()),
                       (folder_ / "errors.txt").string());
  EXPECT_EQ(done.status, 1);
  EXPECT_THAT(done.errors, HasSubstr("notes.nrrd"));
  EXPECT_EQ(casesIn("library").size(), 1U);
  EXPECT_THAT(page("library"), HasSubstr("1 prepared, 1 not prepared"));
  EXPECT_THAT(page("library"), Not(HasSubstr("<b>")));
}

TEST_F(PrepareCommand, AShardThatDoesNotExistIsRefused) {
  for (const char* shard : {"0/2", "3/2", "2", "a/b", "1/0", "1/2x"}) {
    const CommandResult refused = prepare("library", std::string("--shard ") + shard);
    EXPECT_EQ(refused.status, 1) << shard;
    EXPECT_THAT(refused.errors, HasSubstr("--shard needs I/N")) << shard;
  }
  EXPECT_FALSE(fs::exists(folder_ / "library"));
}

}  // namespace
}  // namespace insonate
