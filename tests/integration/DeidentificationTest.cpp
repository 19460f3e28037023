#include "CommandLine.h"
#include "support/ByteSearch.h"
#include "support/MarkedSeries.h"
#include "support/TestData.h"
#include "unit/cases/VolumeFiles.h"

#include <insonate/cases/PatientCase.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using test::shellWord;

/// What the command line writes of a patient whose name stands everywhere it can.
class Deidentification : public testing::Test {
 protected:
  test::CommandResult run(const std::string& arguments) const {
    return test::runCommand(arguments, errors_ / "stderr",
                            "HOME=" + shellWord(written_.path()) + " XDG_CONFIG_HOME= XDG_CACHE_HOME= XDG_DATA_HOME= ");
  }
  void expectNoMarks(int atLeastFiles) const {
    int files = 0;
    EXPECT_THAT(test::marksBelow(written_.path(), test::kMarks, files), testing::IsEmpty());
    EXPECT_GE(files, atLeastFiles);
  }
  test::TemporaryFolder input_, written_, errors_;
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
    const auto labelled = run("import-labels " + shellWord(folder) + " " + shellWord(input_ / "ZQXMARK_labels.mha") +
                              " --names " + shellWord(input_ / "ZQXMARK.label.txt"));
    ASSERT_EQ(labelled.status, 0) << labelled.errors;
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
