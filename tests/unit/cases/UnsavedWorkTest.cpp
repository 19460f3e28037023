#include <insonate/cases/UnsavedWork.h>
#include <insonate/tissue/Labels.h>

#include <gtest/gtest.h>
#include <support/FullDisk.h>
#include <support/SmallCase.h>
#include <support/TestData.h>

#include <algorithm>
#include <fstream>
#include <random>

namespace insonate {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary) << bytes;
}

/// The block with changes of every kind.
PatientCase changed(PatientCase patient) {
  for (int i = 10; i < 20; ++i) patient.labels.at(i, 20, 5) = kArtery;
  patient.labels.at(0, 0, 0) = patient.labels.at(48, 40, 16) = kNerve;
  patient.manifest.title = "Another name";
  patient.manifest.targets.push_back({"artery", kArtery, {1, 2, 3}});
  patient.manifest.ownLabels[200] = {"rib", kBone};
  patient.manifest.states[kVein] = LabelState::Completed;
  patient.manifest.shown[kBone] = {0.5, false};
  patient.colors[kVein] = {1, 2, 3};
  return patient;
}

UnsavedWork workBetween(const PatientCase& before, const PatientCase& after) {
  UnsavedWork work;
  work.folder = "/cases/block";
  work.time_s = 1'790'000'000;
  work.strokes = 3, work.steps = 1;
  work.recipe = "{\"steps\": []}";
  work.sums = sumsOf(before);
  work.runs = runsBetween(before.labels.voxels, after.labels.voxels);
  work.before = before.manifest, work.after = after.manifest;
  work.colorsBefore = before.colors, work.colorsAfter = after.colors;
  return work;
}

class UnsavedWorkFile : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  fs::path file_ = folder_ / "unsaved.work";
  PatientCase before_ = test::smallCase(), after_ = changed(test::smallCase());
  UnsavedWork work_ = workBetween(before_, after_);
};

TEST_F(UnsavedWorkFile, GivesBackTheSameCase) {
  ASSERT_TRUE(writeUnsavedWork(work_, file_));
  const auto read = readUnsavedWork(file_);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->folder, work_.folder);
  EXPECT_EQ(read->time_s, work_.time_s);
  EXPECT_EQ(read->strokes, 3);
  EXPECT_EQ(read->steps, 1);
  EXPECT_EQ(read->recipe, work_.recipe);
  EXPECT_EQ(read->sums, sumsOf(before_));
  EXPECT_TRUE(isUnchanged(*read, before_.manifest, before_.colors));
  EXPECT_FALSE(isUnchanged(*read, after_.manifest, after_.colors));
  PatientCase restored = before_;
  const auto labels = withUnsavedLabels(*read, before_.labels);
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->voxels, after_.labels.voxels);
  applyValues(*read, restored.manifest, restored.colors);
  EXPECT_EQ(restored.manifest.title, after_.manifest.title);
  EXPECT_EQ(restored.manifest.targets, after_.manifest.targets);
  EXPECT_EQ(restored.manifest.ownLabels, after_.manifest.ownLabels);
  EXPECT_EQ(restored.manifest.states, after_.manifest.states);
  EXPECT_EQ(restored.manifest.shown, after_.manifest.shown);
  EXPECT_EQ(restored.colors, after_.colors);
  const UnsavedParts parts = partsOf(*read);
  EXPECT_TRUE(parts.labels && parts.title && parts.places && parts.terms && parts.colors && parts.shown);
}

TEST_F(UnsavedWorkFile, ContainsOnlyThePartsThatChanged) {
  PatientCase after = before_;
  after.manifest.title = "Another name";
  ASSERT_TRUE(writeUnsavedWork(workBetween(before_, after), file_));
  const auto read = readUnsavedWork(file_);
  ASSERT_TRUE(read);
  const UnsavedParts parts = partsOf(*read);
  EXPECT_TRUE(parts.title);
  EXPECT_FALSE(parts.labels || parts.places || parts.terms || parts.colors || parts.shown);
}

TEST_F(UnsavedWorkFile, LeavesFieldsThatWereSavedMeanwhile) {
  PatientCase theirs = before_;
  theirs.manifest.startPoses.clear();
  theirs.manifest.states[kBone] = LabelState::Flagged;
  theirs.manifest.title = "Their name";
  theirs.labels.at(30, 30, 3) = kMuscle;
  const auto labels = withUnsavedLabels(work_, theirs.labels);
  ASSERT_TRUE(labels);
  EXPECT_EQ(labels->at(30, 30, 3), kMuscle);
  EXPECT_EQ(labels->at(12, 20, 5), kArtery);
  applyValues(work_, theirs.manifest, theirs.colors);
  EXPECT_TRUE(theirs.manifest.startPoses.empty());
  EXPECT_EQ(theirs.manifest.states.at(kBone), LabelState::Flagged);
  EXPECT_EQ(theirs.manifest.states.at(kVein), LabelState::Completed);
  EXPECT_EQ(theirs.manifest.title, "Another name");
  EXPECT_NE(sumsOf(theirs), work_.sums);
  EXPECT_FALSE(isUnchanged(work_, theirs.manifest, theirs.colors));
  EXPECT_TRUE(sumsOf(theirs).hasSameCt(work_.sums));
  theirs.ct.voxels[7] += 1;
  EXPECT_FALSE(sumsOf(theirs).hasSameCt(work_.sums));
}

TEST_F(UnsavedWorkFile, RemovesWhatTheAuthorRemoved) {
  const UnsavedWork back = workBetween(after_, before_);
  PatientCase restored = after_;
  applyValues(back, restored.manifest, restored.colors);
  EXPECT_TRUE(restored.manifest.ownLabels.empty());
  EXPECT_TRUE(restored.colors.empty());
  EXPECT_EQ(withUnsavedLabels(back, after_.labels)->voxels, before_.labels.voxels);
}

TEST_F(UnsavedWorkFile, AllLabelsNeedNoFormerLabels) {
  work_.runs = runsBetween({}, after_.labels.voxels);
  work_.hasAllLabels = true;
  ASSERT_TRUE(writeUnsavedWork(work_, file_));
  const auto read = readUnsavedWork(file_);
  ASSERT_TRUE(read);
  LabelMap other(before_.labels.geometry, kBone);
  EXPECT_EQ(withUnsavedLabels(*read, other)->voxels, after_.labels.voxels);
}

TEST_F(UnsavedWorkFile, CutAtAnyByteItIsRefused) {
  ASSERT_TRUE(writeUnsavedWork(work_, file_));
  const std::string bytes = test::bytesOf(file_);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    write(file_, bytes.substr(0, size));
    const auto read = readUnsavedWork(file_);
    ASSERT_FALSE(read) << size;
    ASSERT_TRUE(read.error().message.ends_with("cannot be restored.")) << read.error().message;
  }
}

TEST_F(UnsavedWorkFile, WithAnyByteFlippedItIsRefused) {
  ASSERT_TRUE(writeUnsavedWork(work_, file_));
  std::string bytes = test::bytesOf(file_);
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    const char bit = char(1 << at % 8);
    bytes[at] = char(bytes[at] ^ bit);
    write(file_, bytes);
    EXPECT_FALSE(readUnsavedWork(file_)) << at;
    bytes[at] = char(bytes[at] ^ bit);
  }
  write(file_, bytes + '\0');
  EXPECT_FALSE(readUnsavedWork(file_));
}

TEST_F(UnsavedWorkFile, OfANewerProgramSaysSo) {
  write(file_, "INSONATE UNSAVED 2\nsomething else");
  const auto read = readUnsavedWork(file_);
  ASSERT_FALSE(read);
  EXPECT_TRUE(read.error().message.ends_with("was kept by a newer version of Insonate.")) << read.error().message;
}

TEST_F(UnsavedWorkFile, AFullDiskKeepsTheFormerFile) {
  ASSERT_TRUE(writeUnsavedWork(work_, file_));
  const std::string bytes = test::bytesOf(file_);
  work_.runs.clear();
  {
    const test::FullDisk full(100);
    EXPECT_FALSE(writeUnsavedWork(work_, file_));
  }
  EXPECT_EQ(test::bytesOf(file_), bytes);
}

TEST(LabelRuns, RestoreAnyDifference) {
  std::mt19937 random(7);
  for (const std::size_t size : {0UL, 1UL, 4096UL, 4097UL, 50'000UL})
    for (const int share : {0, 1, 50, 100}) {
      std::vector<std::uint8_t> from(size), to(size);
      for (std::size_t n = 0; n < size; ++n) {
        from[n] = std::uint8_t(random() % 3);
        to[n] = int(random() % 100) < share ? std::uint8_t(random() % 256) : from[n];
      }
      std::vector<std::uint8_t> applied = from;
      ASSERT_TRUE(applyRuns(runsBetween(from, to), applied));
      EXPECT_EQ(applied, to) << size << ' ' << share;
    }
  const std::vector<std::uint8_t> same(50'000, 3);
  EXPECT_TRUE(runsBetween(same, same).empty());
}

TEST(LabelRuns, ThatDoNotFitAreRefused) {
  const std::vector<std::uint8_t> from(100), to(100, 1);
  const LabelRuns runs = runsBetween(from, to);
  std::vector<std::uint8_t> small(99);
  EXPECT_FALSE(applyRuns(runs, small));
  for (std::size_t size = 1; size < runs.size(); ++size) {
    std::vector<std::uint8_t> labels(100);
    EXPECT_FALSE(applyRuns(LabelRuns(runs.begin(), runs.begin() + std::ptrdiff_t(size)), labels)) << size;
  }
  std::vector<std::uint8_t> labels(100);
  EXPECT_FALSE(applyRuns(LabelRuns(12, 0xff), labels));
}

}  // namespace
}  // namespace insonate
