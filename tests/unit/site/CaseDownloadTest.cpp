#include <insonate/cases/CaseVersions.h>
#include <insonate/site/CaseDownload.h>
#include <insonate/site/PublishedCases.h>
#include <insonate/tissue/Labels.h>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <optional>
#include <random>
#include <string_view>

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
    offers_.emplace(cases_);
    link_.place = "https://server";
    link_.send = [this](const std::string& path, const std::string&) -> Result<SiteAnswer> {
      ++asked_;
      if (asked_ > failsAfter_) return fail("The network is down.");
      const auto answer = answerTo(path);
      return answer ? SiteAnswer{false, *answer} : SiteAnswer{true, answer.error().message};
    };
  }
  void TearDown() override { fs::remove_all(root_); }

  /// Answers as the server does.
  Result<std::string> answerTo(const std::string& path) const {
    constexpr std::string_view kFiles = "case-files/";
    if (path == "cases") return offers_->listText();
    if (!path.starts_with(kFiles)) return fail("There is no such address.");
    const auto part = offers_->part(path.substr(kFiles.size()));
    if (!part) return tl::unexpected(part.error());
    std::ifstream in(part->file, std::ios::binary);
    std::string bytes(part->size, '\0');
    in.seekg(static_cast<std::streamoff>(part->begin));
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return bytes;
  }
  std::string firstId() const { return offers_->list()->front().id; }
  std::optional<fs::path> here(const std::string& title) const { return downloadStateOf(here_, title).place; }

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
    const auto place = here(title);
    const auto read = place ? readCase(*place) : Result<CaseReadResult>(fail("none"));
    return read ? contentHashOf(read->patient) : std::string();
  }

  fs::path root_, cases_, here_;
  std::optional<PublishedCases> offers_;
  SiteLink link_;
  int asked_ = 0, failsAfter_ = 1'000'000;
};

TEST_F(CaseDownload, BringsThePublishedVersionOfEachCaseThatIsNeeded) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  publish("other", caseTitled("Other neck", 2));
  const CaseDownloadReport report = download({"Broad neck", "textbook"});
  EXPECT_THAT(report.titles, ElementsAre("Broad neck"));
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_EQ(contentHere("Broad neck"), version.content);
  EXPECT_THAT(downloadedCases(here_), ElementsAre(*here("Broad neck")));
  EXPECT_FALSE(here("Other neck"));
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
  EXPECT_FALSE(here("Broad neck"));
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

TEST_F(CaseDownload, DamagedFilesAreNotUsed) {
  publish("broad", caseTitled("Broad neck", 1));
  failsAfter_ = 3;
  ASSERT_FALSE(downloadCases(link_, {"Broad neck"}, here_));
  const fs::path part = here_ / (firstId() + ".part") / "ct.nrrd";
  ASSERT_TRUE(fs::exists(part));
  std::fstream(part, std::ios::in | std::ios::out | std::ios::binary).seekp(100'000).write("damage", 6);
  failsAfter_ = 1'000'000;
  const CaseDownloadReport damaged = download();
  EXPECT_THAT(damaged.titles, IsEmpty());
  ASSERT_THAT(damaged.errors, SizeIs(1));
  EXPECT_THAT(damaged.errors[0], HasSubstr("does not fit its fingerprint"));
  asked_ = 0;
  EXPECT_THAT(download().errors, SizeIs(1));
  EXPECT_EQ(asked_, 1) << "not again on the same day";
  fs::last_write_time(here_ / (firstId() + ".damaged"), fs::file_time_type::clock::now() - std::chrono::hours(25));
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
}

TEST_F(CaseDownload, FilesThatAPowerFailureCutOffComeAgain) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  download();
  fs::resize_file(*here("Broad neck") / "ct.nrrd", 0);
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
  EXPECT_EQ(contentHere("Broad neck"), version.content);
}

TEST_F(CaseDownload, ACompleteCaseCanBeUsedAlthoughTheNextOneFails) {
  const CaseVersion version = publish("a", caseTitled("Broad neck", 1));
  publish("b", caseTitled("Other neck", 2));
  int parts = 0;
  link_.send = [this, &parts](const std::string& path, const std::string&) -> Result<SiteAnswer> {
    if (path.find("case.json") != std::string::npos && ++parts > 1) return fail("The network is down.");
    return SiteAnswer{false, *answerTo(path)};
  };
  EXPECT_FALSE(downloadCases(link_, {"Broad neck", "Other neck"}, here_));
  EXPECT_EQ(contentHere("Broad neck"), version.content);
  EXPECT_FALSE(here("Other neck"));
  EXPECT_TRUE(downloadStateOf(here_, "Other neck").isExpected);
  EXPECT_FALSE(downloadStateOf(here_, "textbook").isExpected);
}

TEST_F(CaseDownload, LeavesOtherFilesOfTheFolderAlone) {
  fs::create_directories(here_ / "backup.part");
  std::ofstream(here_ / "thesis.pdf.part") << "mine";
  fs::permissions(here_, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec);
  const auto before = fs::status(here_).permissions();
  fs::create_directories(here_ / "0123456789abcdef.part");
  publish("broad", caseTitled("Broad neck", 1));
  download();
  EXPECT_TRUE(fs::exists(here_ / "backup.part"));
  EXPECT_TRUE(fs::exists(here_ / "thesis.pdf.part"));
  EXPECT_FALSE(fs::exists(here_ / "0123456789abcdef.part")) << "a version that the server no longer offers";
  EXPECT_EQ(fs::status(here_).permissions(), before);
}

TEST_F(CaseDownload, AFolderThatTheServerCannotReadWithdrawsNothing) {
  publish("broad", caseTitled("Broad neck", 1));
  download();
  fs::rename(cases_, root_ / "away");
  EXPECT_FALSE(downloadCases(link_, {"Broad neck"}, here_));
  EXPECT_TRUE(here("Broad neck"));
}

TEST_F(CaseDownload, ACaseWithTheTitleOfABuiltInCaseIsNotOffered) {
  publish("copy", caseTitled("Textbook neck", 1));
  publish("broad", caseTitled("Broad neck", 2));
  EXPECT_THAT(*offers_->offeredTitles(), ElementsAre("Broad neck"));
  ASSERT_THAT(*offers_->list(), SizeIs(2));
  EXPECT_THAT(offers_->list()->back().whyNotOffered, HasSubstr("built-in case"));
}

TEST_F(CaseDownload, AnIncompleteCopyIsNotOffered) {
  publish("broad", caseTitled("Broad neck", 1));
  const fs::path ct = offers_->list()->front().folder / "ct.nrrd";
  const fs::path away = root_ / "ct.nrrd";
  fs::rename(ct, away);
  EXPECT_THAT(*offers_->offeredTitles(), IsEmpty());
  fs::rename(away, ct);
  std::ofstream(ct.parent_path() / "labels.label.txt") << "";  // empty
  EXPECT_THAT(download().titles, ElementsAre("Broad neck"));
}

TEST_F(CaseDownload, AWithdrawnCaseIsNoLongerUsed) {
  const CaseVersion version = publish("broad", caseTitled("Broad neck", 1));
  download();
  fs::remove_all(cases_ / "broad");
  download();
  EXPECT_FALSE(here("Broad neck"));
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
  EXPECT_EQ(readCase(*here("Copy of it"))->patient.manifest.title, "Copy of it");
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

TEST_F(CaseDownload, AnAnswerThatIsNoListIsRefused) {
  for (const std::string list : {"no JSON", "[]", R"({"cases": 5})", R"({"cases": [{"title": 5}]})"}) {
    link_.send = [list](const std::string&, const std::string&) -> Result<SiteAnswer> {
      return SiteAnswer{false, list};
    };
    const auto refused = downloadCases(link_, {"t"}, here_);
    ASSERT_FALSE(refused) << list;
    EXPECT_THAT(refused.error().message, HasSubstr("list of cases cannot be read")) << list;
  }
}

/// The ids and names in the list become names of folders and files.
TEST_F(CaseDownload, HostileEntriesOfTheListAreLeftOut) {
  const std::string good = R"("title": "t", "version": 1, "date": "", "content": "", )";
  for (const std::string& entry :
       {R"({"id": "0123456789abcdef", )" + good + R"("files": [{"name": "../../x", "bytes": 5}]})",
        R"({"id": "0123456789abcdef", )" + good + R"("files": [{"name": "ct.nrrd", "bytes": -5}]})",
        R"({"id": "0123456789abcdef", )" + good + R"("files": []})",
        R"({"id": "../..", )" + good + R"("files": [{"name": "ct.nrrd", "bytes": 5}]})"}) {
    link_.send = [entry](const std::string&, const std::string&) -> Result<SiteAnswer> {
      return SiteAnswer{false, R"({"cases": [)" + entry + "]}"};
    };
    const auto done = downloadCases(link_, {"t"}, here_);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_FALSE(downloadStateOf(here_, "t").isExpected) << entry;
  }
}

TEST_F(CaseDownload, TheServerGivesNothingButFilesOfPublishedCases) {
  publish("broad", caseTitled("Broad neck", 1));
  std::ofstream(cases_ / "secret") << "secret";
  std::ofstream(cases_ / "broad" / "versions" / "001" / "notes.txt") << "secret";
  const std::string ours = "case-files/" + firstId() + "/";
  EXPECT_TRUE(answerTo(ours + "case.json/0"));
  for (const std::string& path :
       {ours + "notes.txt/0", ours + "../../secret/0", ours + "../../../secret/0", ours + "case.json/-1",
        ours + "case.json/99999999999", ours + "case.json/0x", ours + "case.json/", ours + "case.json", ours + "/0",
        std::string("case-files/"), std::string("case-files/../secret/0"), std::string("case-files//case.json/0"),
        std::string("secret"), std::string(), std::string("case-files")}) {
    const auto answer = answerTo(path);
    EXPECT_FALSE(answer) << path;
  }
  EXPECT_THAT(*PublishedCases({}).list(), IsEmpty()) << "a server without cases";
}

}  // namespace
}  // namespace insonate::test
