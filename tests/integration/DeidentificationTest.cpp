#include "CommandLine.h"
#include "support/ByteSearch.h"
#include "support/MarkedSeries.h"
#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/cases/VolumeFiles.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/cases/PatientCase.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using test::shellWord;

/// Output of the command line for a patient whose name is in every possible place.
class Deidentification : public testing::Test {
 protected:
  test::CommandResult run(const std::string& arguments, const std::string& before = "") const {
    const std::string home = shellWord(written_.path());
    return test::runCommand(
        arguments, errors_ / "stderr",
        before + "HOME=" + home + " TMPDIR=" + home + " XDG_CONFIG_HOME= XDG_CACHE_HOME= XDG_DATA_HOME= ");
  }
  PatientCase imported() const {
    const auto read = readCase(written_ / "case");
    EXPECT_TRUE(read) << read.error().message;
    return read ? read->patient : PatientCase{};
  }
  /// A marked series becomes a case that attempts can be made on, with its labels from elsewhere; and a script of one.
  void writeImportedBlock() {
    const PatientCase block = test::smallAttemptCase();
    const VolumeGeometry& grid = block.ct.geometry;
    std::vector<test::HospitalSlice> slices;
    for (int k = 0; k < grid.size[2]; ++k) {
      slices.push_back({grid.origin_mm + Vec3{0, 0, double(k)}});
      slices.back().columns = grid.size[0], slices.back().rows = grid.size[1];
    }
    test::writeMarkedSeries(input_.path(), slices);
    const auto done = run("import " + shellWord(input_.path()) + " " + case_);
    ASSERT_EQ(done.status, 0) << done.errors;
    PatientCase patient = imported();
    ASSERT_TRUE(sameGrid(patient.ct.geometry, grid));
    patient.labels = block.labels;
    patient.manifest.targets = block.manifest.targets;
    patient.manifest.startPoses = block.manifest.startPoses;
    ASSERT_TRUE(saveCaseVersion(patient, written_ / "case", "2026-11-23", ""));
    test::writeText(written_ / "script.json", R"({"acts": [{"probe": "auto"},
      {"needle": {"from_mm": [0, -5, 0], "to": "vein"}}, {"advance_mm": 27}, {"withdraw_mm": 10}]})");
  }
  void expectNoMarks(int atLeastFiles) const {
    int files = 0;
    EXPECT_THAT(test::marksBelow(written_.path(), test::kMarks, files), testing::IsEmpty());
    EXPECT_GE(files, atLeastFiles);
  }
  test::TemporaryFolder input_, written_, errors_;
  const std::string case_ = shellWord(written_ / "case");
};

TEST_F(Deidentification, TheSearchFindsWhatIsThere) {
  const int planted = test::writeMarkedSeries(input_.path(), 1);
  EXPECT_GT(planted, 1500) << "of the dictionary's attributes";
  int files = 0;
  for (const std::string& mark : test::kMarks)
    EXPECT_FALSE(test::marksBelow(input_.path(), {mark}, files).empty()) << mark;
  const std::string text = "a ZQXMARK b";
  EXPECT_FALSE(test::marksIn(test::wide(text, false), test::kMarks).empty());
  EXPECT_FALSE(test::marksIn(test::wide(text, true), test::kMarks).empty());
  // "ZQXMARK b" behind none, one and two letters.
  for (const char* base64 : {"WlFYTUFSSyBi", "YVpRWE1BUksgYg==", "YSBaUVhNQVJLIGI="})
    EXPECT_FALSE(test::marksIn(base64, test::kMarks).empty()) << base64;
  std::string packed(200, '\0');
  uLongf size = packed.size();
  ASSERT_EQ(::compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
                       text.size()),
            Z_OK);
  EXPECT_FALSE(test::marksIn("before" + packed.substr(0, size), test::kMarks).empty());
}

TEST_F(Deidentification, NothingOfADicomSeriesIsWritten) {
  test::writeMarkedSeries(input_.path(), 5);
  const auto imported = run("import " + shellWord(input_.path()) + " " + shellWord(written_ / "case"));
  ASSERT_EQ(imported.status, 0) << imported.errors;
  ASSERT_EQ(run("export " + shellWord(written_ / "case") + " --dicom " + shellWord(written_ / "out")).status, 0);
  expectNoMarks(9);
}

TEST_F(Deidentification, NothingOfWhatBecomesOfACaseNamesAnybody) {
  writeImportedBlock();
  ASSERT_TRUE(publishCase(imported(), written_ / "case", "2026-11-24"));
  PatientCase later = imported();
  later.labels.voxels.front() = kBone;
  ASSERT_TRUE(saveCaseVersion(later, written_ / "case", "2026-11-24", ""));
  EXPECT_TRUE(fs::exists(written_ / "case/versions/001/ct.nrrd"));
  const auto under = [&](const char* name) { return " " + shellWord(written_ / name); };
  const auto session = run("session " + case_ + " --script" + under("script.json") + " --record" + under("attempt") +
                           " --pictures" + under("seen") + " --json");
  ASSERT_EQ(session.status, 0) << session.errors;
  const auto replay = run("replay" + under("attempt") + " " + case_ + " --metrics --json");
  ASSERT_EQ(replay.status, 0) << replay.errors;
  for (const std::string& told : {session.output, replay.output, run("check " + case_ + " --json").output})
    EXPECT_THAT(test::marksIn(told, test::kMarks), testing::IsEmpty());
  for (const std::string& command :
       {"export " + case_ + " --dicom" + under("series") + " --seg" + under("seg.dcm") + " --labels" +
            under("l.seg.nrrd"),
        "surfaces " + case_ + under("meshes"), "crop " + case_ + under("smaller") + " --from 2 2 2 --to 40 36 14",
        "render " + case_ + " --probe linear --pose auto --out" + under("picture.png")})
    EXPECT_EQ(run(command).status, 0) << command;
  expectNoMarks(45);
}

/// A program is ended in the middle of a file that grows longer than it may: as a kill, but always at the same place.
TEST_F(Deidentification, NothingOfAPatientIsLeftByAProgramThatIsEnded) {
  writeImportedBlock();
  const auto ended = [&](const std::string& arguments) {
    return run(arguments, "trap '' TERM; ulimit -f 3; ").status != 0;
  };
  EXPECT_TRUE(ended("import " + shellWord(input_.path()) + " " + shellWord(written_ / "again")));
  EXPECT_FALSE(fs::exists(written_ / "again"));
  EXPECT_TRUE(ended("session " + case_ + " --script " + shellWord(written_ / "script.json") + " --record " +
                    shellWord(written_ / "attempt")));
  const auto left = std::ranges::count_if(fs::directory_iterator(written_.path()), [](const auto& entry) {
    return entry.path().filename().string().find(".part-") != std::string::npos;
  });
  EXPECT_GT(left, 0);
  expectNoMarks(6);
}

TEST_F(Deidentification, NothingOfWhatVolumeFilesSayIsWritten) {
  const CtVolume ct = test::noiseCt(test::grid({12, 10, 12}));
  test::writeRawNrrd(input_ / "ZQXMARK.nrrd",
                     "# ZQXMARK comment\ncontent: ZQXMARK content\ntype: short\ndimension: 3\nsizes: 12 10 12\nspace: "
                     "left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: "
                     "(0,0,0)\npatient:=ZQXMARK^Jane\nDICOM_0010_0010:=ZQXMARK\n",
                     test::bytesOf(ct.voxels));
  const auto imported = run("import " + shellWord(input_.path()) + " " + shellWord(written_ / "case"));
  ASSERT_EQ(imported.status, 0) << imported.errors;
  expectNoMarks(4);
}

TEST_F(Deidentification, NothingOfNiftiMetaImageOrItkSnapIsWritten) {
  const CtVolume ct = test::noiseCt(test::grid({12, 10, 12}));
  std::string nifti = test::niftiOf(ct, {{{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}}}, 1, 0);
  const std::string mark = "ZQXMARK";
  for (const std::size_t at : {14, 148, 228, 328}) nifti.replace(at, mark.size(), mark);  // db_name to intent_name
  test::writeText(input_ / "ZQXMARK.nii", nifti);
  test::writeText(input_ / "ZQXMARK.mha",
                  "Comment = ZQXMARK\nPatientName = ZQXMARK\n" + test::metaImage(ct, "1 0 0 0 1 0 0 0 1"));
  test::writeText(input_ / "ZQXMARK.label.txt", "# of ZQXMARK\n 1 1 2 3 1 1 1 \"ZQXMARK's tumour\"\n");
  test::writeText(input_ / "ZQXMARK_labels.mha", "Name = ZQXMARK\n" +
                                                     test::metaHeader(ct.geometry, "1 0 0 0 1 0 0 0 1", "MET_UCHAR") +
                                                     "ElementDataFile = LOCAL\n" + std::string(12 * 10 * 12, '\1'));
  for (const char* file : {"ZQXMARK.nii", "ZQXMARK.mha"}) {
    const fs::path folder = written_ / fs::path(file).extension().string().substr(1);
    const auto imported = run("import " + shellWord(input_ / file) + " " + shellWord(folder));
    ASSERT_EQ(imported.status, 0) << imported.errors;
    const auto labeled = run("import-labels " + shellWord(folder) + " " + shellWord(input_ / "ZQXMARK_labels.mha") +
                             " --names " + shellWord(input_ / "ZQXMARK.label.txt"));
    ASSERT_EQ(labeled.status, 0) << labeled.errors;
    ASSERT_EQ(run("export " + shellWord(folder) + " --seg " + shellWord(folder.string() + ".dcm")).status, 0);
  }
  expectNoMarks(10);
}

TEST_F(Deidentification, NothingOfASegmentationIsWritten) {
  PatientCase patient;
  patient.ct = test::noiseCt(test::grid({12, 10, 12}));
  patient.labels = LabelMap(patient.ct.geometry);
  ASSERT_TRUE(writeCase(patient, written_ / "case"));
  test::writeRawNrrd(input_ / "ZQXMARK.seg.nrrd",
                     "type: unsigned char\ndimension: 3\nsizes: 12 10 12\nspace: left-posterior-superior\nspace "
                     "directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\nSegment0_ID:=ZQXMARK\n"
                     "Segment0_Name:=tumour of ZQXMARK\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n",
                     std::string(12 * 10 * 12, '\1'));
  const auto imported =
      run("import-labels " + shellWord(written_ / "case") + " " + shellWord(input_ / "ZQXMARK.seg.nrrd"));
  ASSERT_EQ(imported.status, 0) << imported.errors;
  EXPECT_THAT(imported.errors, testing::HasSubstr("ZQXMARK")) << "said to the author, who must know which";
  expectNoMarks(4);
}

}  // namespace
}  // namespace insonate
