#include "CaseSamples.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/TissueLabels.h>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <thread>

namespace insonate {
namespace {

namespace fs = std::filesystem;

class CaseVersions : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("insonate-versions-" + std::to_string(::getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_);
    folder_ = root_ / "case";
  }
  void TearDown() override { fs::remove_all(root_); }

  CaseVersion save(const PatientCase& patient, const std::string& date = "2026-11-22") {
    const auto version = saveCaseVersion(patient, folder_, date, "");
    EXPECT_TRUE(version) << version.error().message;
    return version.value_or(CaseVersion{});
  }
  PatientCase read(const fs::path& folder) {
    auto result = readCase(folder);
    EXPECT_TRUE(result) << result.error().message;
    return result ? std::move(result->patient) : PatientCase{};
  }
  /// By who has looked at what is there.
  Result<CaseVersion> publish() { return publishCase(read(folder_), folder_, "2026-11-23"); }
  static PatientCase relabeled(std::uint8_t label) {
    PatientCase patient = test::noiseCase(test::grid({12, 11, 10}));
    patient.labels.voxels[5] = label;
    return patient;
  }

  fs::path root_, folder_;
};

TEST_F(CaseVersions, FirstSaveIsTheFirstVersion) {
  const CaseVersion version = save(relabeled(kVein));
  EXPECT_EQ(version.number, 1);
  EXPECT_EQ(version.date, "2026-11-22");
  EXPECT_EQ(version.content, contentHashOf(relabeled(kVein)));
  EXPECT_EQ(read(folder_).manifest.version.number, 1);
  EXPECT_FALSE(fs::exists(folder_ / "versions"));
}

TEST_F(CaseVersions, OtherLabelsAreAnotherVersionAndTheEarlierOneStays) {
  save(relabeled(kVein));
  EXPECT_EQ(save(relabeled(kArtery)).number, 2);
  EXPECT_EQ(save(relabeled(kBone)).number, 3);
  EXPECT_EQ(read(folder_).labels.voxels, relabeled(kBone).labels.voxels);
  for (const auto& [label, number] : {std::pair{kVein, 1}, {kArtery, 2}, {kBone, 3}}) {
    const auto place = findVersion(folder_, voxelHashOf(relabeled(label)));
    ASSERT_TRUE(place) << number;
    const PatientCase found = read(*place);
    EXPECT_EQ(found.labels.voxels, relabeled(label).labels.voxels) << number;
    EXPECT_EQ(found.ct.voxels, relabeled(label).ct.voxels) << number;
    EXPECT_EQ(found.manifest.version.number, number);
  }
  const auto versions = versionsOf(folder_);
  ASSERT_EQ(versions.size(), 3u);
  EXPECT_EQ(versions.front().number, 3);
  EXPECT_FALSE(findVersion(folder_, voxelHashOf(relabeled(kFat))));
}

TEST_F(CaseVersions, WhatDoesNotMatterForATraineeKeepsTheVersion) {
  PatientCase patient = relabeled(kVein);
  save(patient, "2026-11-20");
  patient.manifest.title = "Another title";
  patient.colors[kVein] = {1, 2, 3};
  patient.manifest.shown[kSkin] = {0.5, false};
  const CaseVersion version = save(patient, "2026-11-22");
  EXPECT_EQ(version.number, 1);
  EXPECT_EQ(version.date, "2026-11-20");
  EXPECT_EQ(read(folder_).manifest.title, "Another title");
}

TEST_F(CaseVersions, WhatALabelIsMadeOfIsContentAndItsNameIsNot) {
  PatientCase patient = test::noiseCase(test::grid({6, 5, 4}));
  patient.labels.voxels[0] = 20;
  const std::string before = voxelHashOf(patient);
  patient.manifest.ownLabels = {{20, {"a", kBone}}};
  EXPECT_NE(voxelHashOf(patient), before);
  const std::string bone = voxelHashOf(patient);
  patient.manifest.ownLabels[20].name = "b";
  EXPECT_EQ(voxelHashOf(patient), bone);
  replaceOwnLabels(patient);
  EXPECT_EQ(patient.labels.voxels[0], kBone);
  EXPECT_EQ(voxelHashOf(patient), bone) << "as a trainee has it";
}

TEST_F(CaseVersions, TargetsAndStartPosesAreContent) {
  PatientCase patient = relabeled(kVein);
  save(patient);
  patient.manifest.targets = {{"vein", kVein, {1, 2, 3}}};
  EXPECT_EQ(save(patient).number, 2);
  patient.manifest.startPoses = {{"front", {1, 2, 3}, {0, 1, 0}, {1, 0, 0}}};
  EXPECT_EQ(save(patient).number, 3);
  // Saved as it was read, it is the same.
  EXPECT_EQ(save(read(folder_)).number, 3);
}

TEST_F(CaseVersions, CaseOfAnotherToolBecomesAVersionBeforeItIsReplaced) {
  ASSERT_TRUE(writeCase(relabeled(kVein), folder_));
  ASSERT_EQ(read(folder_).manifest.version.number, 0);
  EXPECT_EQ(save(relabeled(kArtery)).number, 2);
  const auto first = findVersion(folder_, voxelHashOf(relabeled(kVein)));
  ASSERT_TRUE(first);
  EXPECT_EQ(read(*first).manifest.version.number, 1);
}

TEST_F(CaseVersions, LabelsChangedByAnotherToolAreAVersionOfTheirOwn) {
  save(relabeled(kVein));
  // 3D Slicer saves its labels and leaves case.json alone.
  ASSERT_TRUE(writeCase(relabeled(kArtery), root_ / "slicer"));
  fs::copy_file(root_ / "slicer/labels.seg.nrrd", folder_ / "labels.seg.nrrd", fs::copy_options::overwrite_existing);
  EXPECT_EQ(save(relabeled(kBone)).number, 3);
  EXPECT_TRUE(findVersion(folder_, voxelHashOf(relabeled(kArtery))));
}

TEST_F(CaseVersions, OtherFilesAndTheCtOfAnEarlierVersionStay) {
  save(relabeled(kVein));
  test::writeText(folder_ / "notes.txt", "mine");
  save(relabeled(kArtery));
  save(relabeled(kBone));
  EXPECT_EQ(test::contentOf(folder_ / "notes.txt"), "mine");
  // One CT for all: it costs the disk nothing to keep versions of labels.
  EXPECT_EQ(fs::hard_link_count(folder_ / "ct.nrrd"), 3u);
}

TEST_F(CaseVersions, WhoHasTheCaseOpenKeepsItsFiles) {
  save(relabeled(kVein));
  std::ifstream open(folder_ / "labels.seg.nrrd", std::ios::binary);
  const std::string before = test::contentOf(folder_ / "labels.seg.nrrd");
  save(relabeled(kArtery));
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(open), {}), before);
}

TEST_F(CaseVersions, CancelledSaveChangesNothing) {
  save(relabeled(kVein));
  const auto cancelled =
      saveCaseVersion(relabeled(kArtery), folder_, "2026-11-22", "", [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(read(folder_).labels.voxels, relabeled(kVein).labels.voxels);
  EXPECT_FALSE(fs::exists(folder_ / "versions"));
}

TEST_F(CaseVersions, OfTwoProgramsThatSaveAtOnceNoVersionIsLost) {
  save(relabeled(1));
  constexpr int kSaves = 6;
  const pid_t other = ::fork();
  if (other == 0) {
    bool all = true;
    for (int n = 0; n < kSaves; ++n)
      all = saveCaseVersion(relabeled(std::uint8_t(2 + n)), folder_, "2026-11-22", "").has_value() && all;
    ::_exit(all ? 0 : 1);
  }
  ASSERT_GT(other, 0);
  for (int n = 0; n < kSaves; ++n) save(relabeled(std::uint8_t(8 + n)));
  int status = -1;
  ::waitpid(other, &status, 0);
  EXPECT_EQ(status, 0);
  EXPECT_EQ(versionsOf(folder_).size(), 2u * kSaves + 1);
  for (int n = 0; n < kSaves; ++n) {
    EXPECT_TRUE(findVersion(folder_, voxelHashOf(relabeled(std::uint8_t(2 + n))))) << n;
    EXPECT_TRUE(findVersion(folder_, voxelHashOf(relabeled(std::uint8_t(8 + n))))) << n;
  }
}

TEST_F(CaseVersions, WhatIsPublishedStaysWhatTraineesGet) {
  save(relabeled(kVein));
  EXPECT_EQ(publishedVersion(folder_), 0);
  EXPECT_EQ(caseForTraining(folder_), folder_) << "nothing is published: the case as it is";
  const auto first = publish();
  ASSERT_TRUE(first) << first.error().message;
  EXPECT_EQ(first->number, 1);
  EXPECT_EQ(first->date, "2026-11-22") << "of the day on which it was saved";
  EXPECT_EQ(versionsOf(folder_).size(), 1u);

  save(relabeled(kArtery));
  save(relabeled(kBone));
  EXPECT_EQ(publishedVersion(folder_), 1);
  EXPECT_EQ(read(caseForTraining(folder_)).labels.voxels, relabeled(kVein).labels.voxels);
  EXPECT_EQ(caseOfVersion(caseForTraining(folder_)), folder_);
  EXPECT_EQ(caseOfVersion(folder_), std::nullopt);
  // Another program writes over the labels of the folder.
  const auto second = publish();
  ASSERT_TRUE(second && writeCase(relabeled(kThyroid), folder_));
  EXPECT_EQ(second->number, 3);
  EXPECT_EQ(read(caseForTraining(folder_)).labels.voxels, relabeled(kBone).labels.voxels);
  EXPECT_EQ(versionsOf(folder_).size(), 3u);
  EXPECT_EQ(save(relabeled(kSkin)).number, 5) << "the other program's is the fourth";
  EXPECT_EQ(read(caseForTraining(folder_)).labels.voxels, relabeled(kBone).labels.voxels);
}

TEST_F(CaseVersions, WhatAnotherProgramSavedMeanwhileIsNotPublishedUnseen) {
  save(relabeled(kVein));
  ASSERT_TRUE(publish());
  save(relabeled(kArtery));
  const PatientCase seen = read(folder_);
  save(relabeled(kBone));
  const auto published = publishCase(seen, folder_, "2026-11-23");
  ASSERT_FALSE(published);
  EXPECT_THAT(published.error().message,
              testing::AllOf(testing::HasSubstr("Another program has saved"), testing::HasSubstr("publish it again")));
  EXPECT_EQ(publishedVersion(folder_), 1) << "trainees keep what they had";
  EXPECT_EQ(read(folder_).labels.voxels, relabeled(kBone).labels.voxels) << "and nobody's work is undone";
  ASSERT_TRUE(publish());
  EXPECT_EQ(read(caseForTraining(folder_)).labels.voxels, relabeled(kBone).labels.voxels);
}

TEST_F(CaseVersions, WhatAnInterruptedPublishingLeftIsMadeWhole) {
  const int number = save(relabeled(kVein)).number;
  fs::create_directories(folder_ / "versions" / "001");
  ASSERT_EQ(number, 1);
  ASSERT_TRUE(publish());
  EXPECT_EQ(publishedVersion(folder_), 1);
  EXPECT_EQ(read(caseForTraining(folder_)).labels.voxels, relabeled(kVein).labels.voxels);
}

TEST_F(CaseVersions, AVersionThatCannotBeKeptIsNotPublished) {
  save(relabeled(kVein));
  test::writeText(folder_ / "versions", "a file in its place");
  EXPECT_FALSE(publish());
  EXPECT_EQ(publishedVersion(folder_), 0);
}

TEST_F(CaseVersions, APointerToNothingPublishesNothing) {
  save(relabeled(kVein));
  ASSERT_TRUE(publish());
  for (const char* text : {"", "{", "{\"version\": 7}", "{\"version\": \"../..\"}", "[]"}) {
    std::ofstream(folder_ / "versions" / "published.json") << text;
    EXPECT_EQ(caseForTraining(folder_), folder_) << text;
  }
  const auto none = publishCase(PatientCase{}, root_ / "nowhere", "2026-11-23");
  ASSERT_FALSE(none);
}

TEST_F(CaseVersions, DamagedVersionEntryIsRefusedWithItsPlace) {
  save(relabeled(kVein));
  test::writeText(folder_ / "case.json", R"({"schema_version": 1, "version": {"number": "three"}})");
  const auto result = readCase(folder_);
  ASSERT_FALSE(result);
  EXPECT_THAT(result.error().message, testing::HasSubstr("case.json, version, needs a number"));
}

TEST_F(CaseVersions, ANewTitleIsPublishedAsANewVersion) {
  PatientCase patient = relabeled(kVein);
  save(patient);
  ASSERT_TRUE(publish());
  patient.manifest.title = "Renamed";
  save(patient);
  const auto version = publish();
  ASSERT_TRUE(version) << version.error().message;
  EXPECT_EQ(version->number, 2);
  EXPECT_EQ(read(caseForTraining(folder_)).manifest.title, "Renamed");
  EXPECT_NE(read(folder_ / "versions" / "001").manifest.title, "Renamed") << "a version never changes";
  EXPECT_EQ(publish()->number, 2) << "nothing new";
}

TEST_F(CaseVersions, OnlyPublishedVersionsAreFoundAsPublished) {
  const std::string first = save(relabeled(kVein)).voxels;
  EXPECT_FALSE(findPublishedVersion(folder_, first)) << "never published";
  ASSERT_TRUE(publish());
  const std::string draft = save(relabeled(kArtery)).voxels;
  EXPECT_FALSE(findPublishedVersion(folder_, draft));
  const std::string third = save(relabeled(kBone)).voxels;
  EXPECT_FALSE(findPublishedVersion(folder_, draft)) << "kept as an earlier version, but never published";
  ASSERT_TRUE(publish());
  EXPECT_EQ(findPublishedVersion(folder_, first), folder_ / "versions" / "001") << "published before";
  EXPECT_EQ(findPublishedVersion(folder_, third), folder_ / "versions" / "003");
  EXPECT_FALSE(findPublishedVersion(folder_, ""));
}

}  // namespace
}  // namespace insonate
