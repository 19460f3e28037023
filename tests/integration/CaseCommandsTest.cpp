#include "CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/cases/DicomFiles.h"

#include <insonate/cases/DicomWriter.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <iterator>
#include <set>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bytesOf;
using test::shellWord;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// phantom, import and check, run as a user would.
class CaseCommands : public testing::Test {
 protected:
  test::CommandResult run(const std::string& arguments, const std::string& prefix = "") const {
    return test::runCommand(arguments, errors_ / "stderr.txt", prefix);
  }
  std::string at(const std::string& name) const { return shellWord(folder_ / name); }
  std::set<std::string> names() const {
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(folder_.path())) found.insert(entry.path().filename().string());
    return found;
  }
  void makeSeries() const {
    const auto written = writeDicomSeries(test::smallCase().ct, folder_ / "series", {.seed = "s"});
    ASSERT_TRUE(written) << written.error().message;
  }
  void expectRefusal(const std::string& arguments, const std::string& words, int status = 1) const {
    const auto before = names();
    const auto result = run(arguments);
    EXPECT_EQ(result.status, status) << arguments << '\n' << result.errors;
    EXPECT_THAT(result.errors, AllOf(HasSubstr(words), Not(HasSubstr(".part-")))) << arguments;
    EXPECT_EQ(names(), before) << arguments;
  }
  test::TemporaryFolder folder_, errors_;
};

TEST_F(CaseCommands, ImportWritesACaseAndSaysWhatIsNext) {
  makeSeries();
  const auto result = run("import " + at("series") + " " + at("case") + " --auto-label --json");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(result.errors, AllOf(HasSubstr("Wrote "), HasSubstr("next: insonate-cli check ")));
  EXPECT_EQ(json::parse(result.output)["case"], (folder_ / "case").string());
  const auto checked = run("check " + at("case") + " --json");
  EXPECT_EQ(checked.status, 0) << checked.errors;
  EXPECT_TRUE(json::parse(checked.output).contains("fit"));
  EXPECT_EQ(json::parse(bytesOf(folder_ / "case/case.json"))["title"], "case") << "imports are told apart in lists";
}

TEST_F(CaseCommands, ValuesWithoutTheirOffsetAreShiftedWhenAskedFor) {
  INSONATE_NEEDS_DATA("head-ct-dicom-small");
  const std::string series = test::testData("head-ct-dicom-small").string();
  expectRefusal("import " + series + " " + at("case") + " --auto-label", "--shift -1024 corrects this");
  const auto result = run("import " + series + " " + at("case") + " --auto-label --shift -1024 --json");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_THAT(json::parse(result.output)["series"][0]["warnings"].dump(), HasSubstr("-1024 was added to every value"));
  expectRefusal("import " + series + " " + at("other") + " --shift 1e9", "--shift", 2);
}

TEST_F(CaseCommands, WhatIsPublishedStaysWhileTheCaseIsSavedAgain) {
  ASSERT_EQ(run("phantom " + at("case")).status, 0);
  const auto published = run("publish " + at("case") + " --json");
  ASSERT_EQ(published.status, 0) << published.errors;
  const json answer = json::parse(published.output);
  EXPECT_EQ(answer["published"], 1);
  EXPECT_EQ(answer["folder"], (folder_ / "case/versions/001").string());
  const std::string labels = bytesOf(folder_ / "case/versions/001/labels.seg.nrrd");
  ASSERT_EQ(run("phantom " + at("case") + " --variant collapsed-vein --replace").status, 0);
  EXPECT_EQ(bytesOf(folder_ / "case/versions/001/labels.seg.nrrd"), labels);
  EXPECT_NE(bytesOf(folder_ / "case/labels.seg.nrrd"), labels);
  expectRefusal("publish " + at("case/versions/001"), "is an earlier version of");
  EXPECT_THAT(run("publish " + at("case")).output, HasSubstr("Trainees get version 2"));
  EXPECT_EQ(bytesOf(folder_ / "case/versions/001/labels.seg.nrrd"), labels) << "for attempts that were made on it";
}

TEST_F(CaseCommands, WhatIsReplacedStaysAsAVersion) {
  makeSeries();
  ASSERT_EQ(run("import " + at("series") + " " + at("case")).status, 0);
  const std::string imported = bytesOf(folder_ / "case/ct.nrrd");
  ASSERT_EQ(run("phantom " + at("case") + " --replace").status, 0);
  EXPECT_EQ(bytesOf(folder_ / "case/versions/001/ct.nrrd"), imported);
  const std::string made = bytesOf(folder_ / "case/labels.seg.nrrd");
  ASSERT_EQ(run("import " + at("series") + " " + at("case") + " --replace").status, 0);
  EXPECT_EQ(bytesOf(folder_ / "case/versions/001/ct.nrrd"), imported);
  EXPECT_EQ(bytesOf(folder_ / "case/versions/002/labels.seg.nrrd"), made);
  EXPECT_EQ(bytesOf(folder_ / "case/ct.nrrd"), imported);
}

TEST_F(CaseCommands, WhatIsNotFitIsNotPublished) {
  makeSeries();
  ASSERT_EQ(run("import " + at("series") + " " + at("case")).status, 0);
  expectRefusal("publish " + at("case"), "was not published, because it is not fit for training");
  EXPECT_THAT(run("publish " + at("case")).errors, HasSubstr("Nothing is labeled yet"));
  EXPECT_FALSE(fs::exists(folder_ / "case/versions"));
  expectRefusal("publish " + at("nowhere"), "There is no case folder");
  expectRefusal("publish ''", "the name is empty", 2);
}

TEST_F(CaseCommands, ASliceThatIsChosenStandsForItsSeries) {
  makeSeries();
  const auto slice = fs::directory_iterator(folder_ / "series")->path();
  ASSERT_EQ(run("import " + shellWord(slice) + " " + at("one")).status, 0);
  ASSERT_EQ(run("import " + at("series") + " " + at("all")).status, 0);
  EXPECT_EQ(bytesOf(folder_ / "one/ct.nrrd"), bytesOf(folder_ / "all/ct.nrrd"));
}

TEST_F(CaseCommands, ACaseIsNotOverwrittenSilently) {
  makeSeries();
  fs::create_directory(folder_ / "case");
  std::ofstream(folder_ / "case/case.json") << "precious";
  expectRefusal("import " + at("series") + " " + at("case"), "already holds a case");
  expectRefusal("phantom " + at("case"), "add --replace");
  EXPECT_EQ(bytesOf(folder_ / "case/case.json"), "precious");
  const auto replaced = run("import " + at("series") + " " + at("case") + " --replace");
  ASSERT_EQ(replaced.status, 0) << replaced.errors;
  EXPECT_THAT(bytesOf(folder_ / "case/case.json"), HasSubstr("schema_version"));
  EXPECT_EQ(names(), (std::set<std::string>{"case", "series"}));
}

TEST_F(CaseCommands, TargetsAreRefusedBeforeTheWork) {
  makeSeries();
  std::ofstream(folder_ / "file") << "text";
  fs::create_symlink(folder_ / "nothing", folder_ / "link");
  for (const std::string& command : {std::string("phantom "), "import " + at("series") + " "}) {
    expectRefusal(command + at("file"), "is a file");
    expectRefusal(command + at("link"), "link to a folder that does not exist");
    expectRefusal(command + at("none/case"), "does not exist");
    expectRefusal(command + "''", "empty", 2);
  }
  expectRefusal("phantom " + at("case") + " --dicom " + at("file"), "is a file");
  expectRefusal("phantom " + at("case") + " --dicom " + at("series"), "not empty");
  expectRefusal("phantom " + at("case") + " --dicom " + at("case"), "same folder");
  expectRefusal("check " + at("file"), "is a file");
}

TEST_F(CaseCommands, WrongUsageHasStatusTwo) {
  makeSeries();
  expectRefusal("chek " + at("case"), "no command 'chek'; did you mean 'check'", 2);
  expectRefusal("import " + at("series") + " " + at("case") + " --list", "excludes", 2);
  expectRefusal("phantom " + at("case") + " --list", "excludes", 2);
  expectRefusal("import " + at("series"), "CASE", 2);
}

TEST_F(CaseCommands, EveryFailureIsAJsonObjectWhereJsonWasAskedFor) {
  std::ofstream(folder_ / "odd\xff.nrrd") << "rubbish";
  for (const std::string& arguments :
       {"check " + at("none"), "import " + at("none") + " --list", "import " + at("none") + " " + at("case"),
        "phantom " + at("none/case"), "phantom " + at("case") + " --variant nosuch",
        "render " + at("none") + " --out " + at("f.png"), "import " + at("odd\xff.nrrd") + " " + at("case"),
        "import " + folder_.path().string() + " " + at("case"), "bench ultrasound --out " + at("none/bench")}) {
    const auto result = run(arguments + " --json");
    EXPECT_EQ(result.status, 1) << arguments << result.errors;
    const json object = json::parse(result.output, nullptr, false);
    ASSERT_TRUE(object.is_object()) << arguments << '\n' << result.output;
    EXPECT_TRUE(object["error"].is_string()) << arguments;
    EXPECT_TRUE(object.contains("version"));
  }
}

TEST_F(CaseCommands, CheckKeepsItsFieldsWhereACaseCannotBeRead) {
  const json object = json::parse(run("check " + at("none") + " --json").output);
  EXPECT_EQ(object["fit"], false);
  EXPECT_EQ(object["findings"].at(0)["code"], "unreadable");
}

TEST_F(CaseCommands, NamesThatAreNotUtf8DoNotThrow) {
  makeSeries();
  fs::rename(folder_ / "series", folder_ / "s\xff");
  const auto result = run("import " + at("s\xff") + " " + at("c\xff") + " --json");
  ASSERT_EQ(result.status, 0) << result.errors;
  EXPECT_TRUE(json::parse(result.output)["case"].is_string());
}

TEST_F(CaseCommands, AScaleThatSaturatesIsImportedOnlyOnRequest) {
  makeSeries();
  for (const auto& entry : fs::directory_iterator(folder_ / "series"))
    test::editDicom(entry.path(),
                    [](gdcm::DataSet& data) { test::setText(data, gdcm::Tag(0x0028, 0x1053), gdcm::VR::DS, "1000"); });
  const std::string import = "import " + at("series") + " " + at("case");
  expectRefusal(import, "exceed 32767 HU with the scale that the file states");
  expectRefusal(import, "add --saturate to import it as it is");
  const auto imported = run(import + " --saturate");
  EXPECT_EQ(imported.status, 0) << imported.errors;
  EXPECT_THAT(imported.errors, HasSubstr("were above 32767 HU and became 32767 HU"));
}

TEST_F(CaseCommands, TheListNamesWhatTheScannerCallsASeries) {
  makeSeries();
  for (const auto& entry : fs::directory_iterator(folder_ / "series"))
    test::editDicom(entry.path(), [](gdcm::DataSet& data) {
      test::setText(data, gdcm::Tag(0x0008, 0x103e), gdcm::VR::LO, "Neck 1.0 soft");
      test::setText(data, gdcm::Tag(0x0008, 0x0021), gdcm::VR::DA, "20261124");
    });
  const json series = json::parse(run("import " + at("series") + " --list --json").output)["series"].at(0);
  EXPECT_EQ(series["description"], "Neck 1.0 soft");
  EXPECT_EQ(series["date"], "2026-11-24");
  EXPECT_TRUE(series["body_part"].is_null()) << series;
}

TEST_F(CaseCommands, ARefusedSeriesShowsNoMadeUpGeometry) {
  ASSERT_TRUE(writeDicomSeries(test::smallCase().ct, folder_ / "series", {.seed = "s"}));
  fs::remove(folder_ / "series/slice00004.dcm");
  for (int n = 5; n < 17; ++n) {
    std::array<char, 24> name;
    std::snprintf(name.data(), name.size(), "slice%05d.dcm", n);
    fs::remove(folder_ / "series" / name.data());
  }
  const auto result = run("import " + at("series") + " --list --json");
  ASSERT_EQ(result.status, 0) << result.errors;
  const json series = json::parse(result.output)["series"].at(0);
  EXPECT_TRUE(series["refusal"].is_string());
  EXPECT_TRUE(series["spacing_mm"].is_null()) << series;
}

/// Stops the command after a moment and expects nothing of it to be left.
class Interrupted : public CaseCommands, public testing::WithParamInterface<const char*> {
 protected:
  void expectNothingLeft(const std::string& arguments, const std::set<std::string>& before) const {
    const std::string signal = GetParam();
    for (const char* moment : {"0.05", "0.4", "1.5"}) {
      const auto result = run(arguments + " --json", "timeout --preserve-status -s " + signal + " " + moment + " ");
      if (result.status == 0) continue;  // a quick machine
      EXPECT_EQ(result.status, signal == "INT" ? 130 : 143) << moment;
      EXPECT_EQ(names(), before) << "after " << moment << " s";
      if (result.errors.empty()) continue;  // before the program began
      EXPECT_THAT(result.errors, HasSubstr("Canceled: nothing was written."));
      EXPECT_THAT(json::parse(result.output)["error"], HasSubstr("Canceled"));
    }
  }
};

TEST_P(Interrupted, PhantomLeavesNothing) {
  expectNothingLeft("phantom " + at("case") + " --replace --dicom " + at("dicom"), {});
}

TEST_P(Interrupted, RenderWithLayersLeavesNothing) {
  ASSERT_TRUE(writeCase(test::smallCase(), folder_ / "case"));
  std::ofstream(folder_ / "s.json") << R"({"scanlines": 1024, "samples": 4096, "elevationPlanes": 9})";
  expectNothingLeft("render " + at("case") + " --engine reference --settings " + at("s.json") + " --out " +
                        at("f.png") + " --layers " + at("layers"),
                    {"case", "s.json"});
}

INSTANTIATE_TEST_SUITE_P(Signals, Interrupted, testing::Values("INT", "TERM"),
                         [](const auto& chosen) { return std::string(chosen.param); });

}  // namespace
}  // namespace insonate
