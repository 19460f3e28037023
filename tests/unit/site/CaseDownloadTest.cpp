#include <insonate/cases/CaseVersions.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/site/PublishedCases.h>
#include <insonate/tissue/Labels.h>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <random>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

/// A server's folder with cases, and a workstation's folder for downloads.
class CaseDownload : public ::testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::temp_directory_path() / ("insonate-download-" + std::to_string(::getpid()));
    fs::remove_all(root_);
    fs::create_directories(cases_ = root_ / "server");
    here_ = root_ / "here";
    link_.place = "https://server";
    link_.ask = [this](const std::string& path, const std::string&) -> Result<SiteAnswer> {
      ++asked_;
      if (asked_ > failsAfter_) return fail("The network is down.");
      const auto answer = answerCaseRequest(cases_, path);
      return answer ? SiteAnswer{false, *answer} : SiteAnswer{true, answer.error().message};
    };
  }
  void TearDown() override { fs::remove_all(root_); }

  /// Values that hardly can be compressed, so that the CT has several parts.
  static PatientCase caseTitled(const std::string& title, std::uint32_t seed) {
    VolumeGeometry grid;
    grid.size = {128, 128, 120};
    PatientCase patient{{}, CtVolume(grid, 0), LabelMap(grid)};
    patient.manifest.title = title;
    std::mt19937 random(seed);
    for (auto& hu : patient.ct.voxels) hu = static_cast<std::int16_t>(random() % 2000);
    return patient;
  }
  CaseVersion publish(const std::string& folder, const PatientCase& patient, const std::string& date = "2026-11-22") {
    const auto saved = saveCaseVersion(patient, cases_ / folder, date, "");
    EXPECT_TRUE(saved) << saved.error().message;
    const auto version = publishCase(patient, cases_ / folder, date);
    EXPECT_TRUE(version) << version.error().message;
    return version.value_or(CaseVersion{});
  }
  CaseDownloadReport download(const std::vector<std::string>& titles = {"Broad neck"}) {
    const auto report = downloadCases(link_, titles, here_);
    EXPECT_TRUE(report) << report.error().message;
    return report.value_or(CaseDownloadReport{});
  }
  std::string contentHere(const std::string& title) const {
    const auto place = downloadedCase(here_, title);
    const auto read = place ? readCase(*place) : Result<CaseReadResult>(fail("none"));
    return read ? contentHashOf(read->patient) : std::string();
  }

  fs::path root_, cases_, here_;
  SiteLink link_;
  int asked_ = 0, failsAfter_ = 1'000'000;
};

TEST_F(CaseDownload, BringsThePublishedVersionOfEachCaseThatIsNeeded) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  publish("other", caseTitled("Other neck", 2));
  const CaseDownloadReport report = download({"Broad neck", "textbook"});
  EXPECT_THAT(report.titles, ElementsAre("Broad neck"));
  EXPECT_THAT(report.troubles, IsEmpty());
  EXPECT_EQ(contentHere("Broad neck"), version.content);
  EXPECT_THAT(downloadedTitles(here_), ElementsAre("Broad neck"));
  EXPECT_FALSE(downloadedCase(here_, "Other neck"));
  EXPECT_EQ(fs::status(here_).permissions(), fs::perms::owner_all) << "the CT of a patient";
  asked_ = 0;
  EXPECT_THAT(download().titles, IsEmpty());
  EXPECT_EQ(asked_, 1) << "the list only";
}

TEST_F(CaseDownload, LeavesOutWhatTheAuthorHasNotPublished) {
  PatientCase draft = caseTitled("Broad neck", 1);
  ASSERT_TRUE(saveCaseVersion(draft, cases_ / "broad", "2026-11-22", ""));
  EXPECT_THAT(download().titles, IsEmpty());
  const CaseVersion version = publish("broad", draft);
  draft.labels.voxels[0] = kVein;
  ASSERT_TRUE(saveCaseVersion(draft, cases_ / "broad", "2026-11-23", ""));
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
  EXPECT_EQ(contentHere("Broad neck"), version.content);
}

TEST_F(CaseDownload, ANewVersionReplacesTheFormerOneWhichStaysForReplays) {
  PatientCase patient = caseTitled("Broad neck", 1);
  const CaseVersion first = publish("broad", patient);
  download();
  patient.labels.voxels[0] = kVein;
  const CaseVersion second = publish("broad", patient, "2026-11-23");
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
  EXPECT_EQ(contentHere("Broad neck"), second.content);
  const auto former = downloadedVersion(here_, first.voxels);
  ASSERT_TRUE(former);
  EXPECT_EQ(contentHashOf(readCase(*former)->patient), first.content);
  EXPECT_FALSE(downloadedVersion(here_, "0123456789abcdef"));
}

TEST_F(CaseDownload, AnInterruptedDownloadContinues) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  failsAfter_ = 3;
  const auto failed = downloadCases(link_, {"Broad neck"}, here_);
  ASSERT_FALSE(failed);
  EXPECT_THAT(failed.error().message, HasSubstr("network is down"));
  EXPECT_FALSE(downloadedCase(here_, "Broad neck"));
  failsAfter_ = 1'000'000, asked_ = 0;
  download();
  const int again = asked_;
  EXPECT_EQ(contentHere("Broad neck"), version.content);
  fs::remove_all(here_);
  asked_ = 0;
  download();
  EXPECT_EQ(again, asked_ - 2) << "two parts were there";
}

TEST_F(CaseDownload, CanBeCancelled) {
  publish("broad", caseTitled("Broad neck", 1));
  int calls = 0;
  const auto cancelled =
      downloadCases(link_, {"Broad neck"}, here_, [&](std::string_view, double) { return ++calls < 3; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
}

TEST_F(CaseDownload, DamagedFilesAreNotUsedAndComeAgain) {
  publish("broad", caseTitled("Broad neck", 1));
  failsAfter_ = 3;
  ASSERT_FALSE(downloadCases(link_, {"Broad neck"}, here_));
  const fs::path part = here_ / (publishedCases(cases_).front().id + ".part") / "ct.nrrd";
  ASSERT_TRUE(fs::exists(part));
  std::fstream(part, std::ios::in | std::ios::out | std::ios::binary).seekp(100'000).write("damage", 6);
  failsAfter_ = 1'000'000;
  const CaseDownloadReport damaged = download();
  EXPECT_THAT(damaged.titles, IsEmpty());
  ASSERT_THAT(damaged.troubles, SizeIs(1));
  EXPECT_THAT(damaged.troubles[0], HasSubstr("did not arrive intact"));
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
}

TEST_F(CaseDownload, AWithdrawnCaseIsNoLongerUsed) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  download();
  fs::remove_all(cases_ / "broad");
  download();
  EXPECT_FALSE(downloadedCase(here_, "Broad neck"));
  EXPECT_TRUE(downloadedVersion(here_, version.voxels)) << "attempts on it can still be replayed";
}

TEST_F(CaseDownload, OfTwoCasesWithOneTitleTheLaterOneCounts) {
  publish("a", caseTitled("Broad neck", 1), "2026-11-20");
  const CaseVersion later = publish("b", caseTitled("Broad neck", 2), "2026-11-21");
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
  EXPECT_EQ(contentHere("Broad neck"), later.content);
}

TEST_F(CaseDownload, ACopyWithAnotherTitleIsAnotherCase) {
  publish("a", caseTitled("Broad neck", 1));
  publish("b", caseTitled("Copy of it", 1));
  EXPECT_THAT(download({"Broad neck", "Copy of it"}).titles, ElementsAre("Broad neck", "Copy of it"));
  EXPECT_EQ(readCase(*downloadedCase(here_, "Copy of it"))->patient.manifest.title, "Copy of it");
}

TEST_F(CaseDownload, TwoProgramsDoNotWriteIntoOneFolder) {
  publish("broad", caseTitled("Broad neck", 1));
  fs::create_directories(here_);
  const int other = ::open(here_.c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  const auto refused = downloadCases(link_, {"Broad neck"}, here_);
  ::close(other);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("Another program"));
}

/// The names in the list become names of files, and another server could send them.
TEST_F(CaseDownload, AHostileListIsRefused) {
  const std::string good =
      R"({"id": "0123456789abcdef", "title": "t", "version": 1, "date": "", "content": "", "files": [)";
  for (
      const std::string& list :
      {std::string("no JSON"), std::string("[]"), std::string(R"({"cases": 5})"),
       R"({"cases": [)" + good + R"({"name": "../../x", "bytes": 5}]}]})",
       R"({"cases": [)" + good + R"({"name": "ct.nrrd", "bytes": -5}]}]})", R"({"cases": [)" + good + R"(]}]})",
       std::string(
           R"({"cases": [{"id": "../..", "title": "t", "version": 1, "date": "", "content": "", "files": [{"name": "ct.nrrd", "bytes": 5}]}]})")}) {
    link_.ask = [list](const std::string&, const std::string&) -> Result<SiteAnswer> {
      return SiteAnswer{false, list};
    };
    const auto refused = downloadCases(link_, {"t"}, here_);
    ASSERT_FALSE(refused) << list;
    EXPECT_THAT(refused.error().message, HasSubstr("list of cases cannot be read")) << list;
  }
}

TEST_F(CaseDownload, TheServerGivesNothingButFilesOfPublishedCases) {
  publish("broad", caseTitled("Broad neck", 1));
  std::ofstream(cases_ / "secret") << "secret";
  std::ofstream(cases_ / "broad" / "versions" / "001" / "notes.txt") << "secret";
  const std::string ours = "case-files/" + publishedCases(cases_).front().id + "/";
  EXPECT_TRUE(answerCaseRequest(cases_, ours + "case.json/0"));
  for (const std::string& path :
       {ours + "notes.txt/0", ours + "../../secret/0", ours + "../../../secret/0", ours + "case.json/-1",
        ours + "case.json/99999999999", ours + "case.json/0x", ours + "case.json/", ours + "case.json", ours + "/0",
        std::string("case-files/"), std::string("case-files/../secret/0"), std::string("case-files//case.json/0"),
        std::string("secret"), std::string(), std::string("case-files")}) {
    const auto answer = answerCaseRequest(cases_, path);
    EXPECT_FALSE(answer) << path;
  }
  EXPECT_FALSE(answerCaseRequest({}, ours + "case.json/0")) << "a server without cases";
}

}  // namespace
}  // namespace insonate::test
