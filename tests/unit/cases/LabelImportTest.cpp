#include "CaseSamples.h"
#include "support/TestData.h"

#include <insonate/cases/DicomSegmentation.h>
#include <insonate/cases/LabelFile.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace insonate {
namespace {

using testing::Contains;
using testing::HasSubstr;

PatientCase blankCase() {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({6, 5, 4}, {1, 1, 2}, {100, 200, -50}), 0);
  patient.labels = LabelMap(patient.ct.geometry);
  return patient;
}

std::string header(const std::string& sizes, const std::string& origin) {
  return "type: unsigned char\ndimension: 3\nsizes: " + sizes +
         "\nspace: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: " + origin + "\n";
}

const std::string kVeinSegment = "Segment0_ID:=a\nSegment0_Name:=vein\nSegment0_LabelValue:=1\nSegment0_Layer:=0\n";

TEST(LabelImport, APartOfTheGridKeepsItsPlace) {
  test::TemporaryFolder folder;
  // Output of 3D Slicer when it crops to the segments: two voxels at (3, 2, 1) and (4, 2, 1).
  test::writeRawNrrd(folder / "l.seg.nrrd",
                     header("2 1 1", "(103,202,-48)") + kVeinSegment +
                         "Segment0_Extent:=0 1 0 0 0 0\nSegmentation_ReferenceImageExtentOffset:=3 2 1\n",
                     "\1\1");
  const auto imported = importLabels(blankCase(), folder / "l.seg.nrrd");
  ASSERT_TRUE(imported) << imported.error().message;
  LabelMap expected(blankCase().ct.geometry);
  expected.at(3, 2, 1) = expected.at(4, 2, 1) = kVein;
  EXPECT_EQ(imported->labels.voxels, expected.voxels);
  EXPECT_THAT(imported->notes, Contains(HasSubstr("every voxel kept its place")));
}

TEST(LabelImport, ACaseWithSuchLabelsIsRead) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(blankCase(), folder / "case"));
  test::writeRawNrrd(folder / "case/labels.seg.nrrd", header("2 1 1", "(103,202,-48)") + kVeinSegment, "\1\1");
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->patient.labels.at(4, 2, 1), kVein);
  EXPECT_EQ(read->patient.labels.geometry, read->patient.ct.geometry);
  EXPECT_THAT(read->notes, Contains(HasSubstr("every voxel kept its place")));
  // Half a voxel beside: not the CT's voxels.
  test::writeRawNrrd(folder / "case/labels.seg.nrrd", header("2 1 1", "(103.5,202,-48)") + kVeinSegment, "\1\1");
  EXPECT_THAT(readCase(folder / "case").error().message, HasSubstr("different grids"));
}

TEST(LabelImport, ReversedAxesAreTurned) {
  test::TemporaryFolder folder;
  std::string voxels(6 * 5 * 4, '\0');
  voxels[0] = kArtery;
  test::writeRawNrrd(
      folder / "l.nrrd",
      "type: unsigned char\ndimension: 3\nsizes: 6 5 4\nspace: left-posterior-superior\nspace directions: "
      "(-1,0,0) (0,-1,0) (0,0,2)\nspace origin: (105,204,-50)\n",
      voxels);
  const auto imported = importLabels(blankCase(), folder / "l.nrrd", {.areProgramLabels = true});
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->labels.at(5, 4, 0), kArtery);
  EXPECT_EQ(imported->labels.at(0, 0, 0), 0);
}

/// Two segments in two layers of six voxels in a row: the vein (segment 1) in the first, the artery (segment 0) in the
/// second; they share the third voxel.
std::string layered(bool named) {
  const std::string layer[2] = {named ? "Segment0_Layer:=1\nSegment0_LabelValue:=1\n" : "",
                                named ? "Segment1_Layer:=0\nSegment1_LabelValue:=1\n" : ""};
  return "type: unsigned char\ndimension: 4\nsizes: 2 6 1 1\nspace: left-posterior-superior\nspace directions: none "
         "(1,0,0) (0,1,0) (0,0,2)\nspace origin: (100,200,-50)\nkinds: list domain domain domain\n"
         "Segment0_ID:=a\nSegment0_Name:=artery\n" +
         layer[0] + "Segment1_ID:=b\nSegment1_Name:=vein\n" + layer[1];
}

TEST(LabelImport, TheLaterOfOverlappingSegmentsWinsInWhicheverLayerItIs) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "l.seg.nrrd", layered(true), std::string("\1\0\1\0\1\1\0\1\0\0\0\0", 12));
  const auto imported = importLabels(blankCase(), folder / "l.seg.nrrd");
  ASSERT_TRUE(imported) << imported.error().message;
  const auto& found = imported->labels.voxels;
  EXPECT_EQ((std::vector<int>(found.begin(), found.begin() + 5)),
            (std::vector<int>{kVein, kVein, kVein, kArtery, kBackground}));
  EXPECT_THAT(imported->notes, Contains(HasSubstr("1 voxels belong to several segments")));
}

TEST(LabelImport, TheListOfLayersMayBeAnyAxis) {
  test::TemporaryFolder folder;
  // The same layers as above, one behind the other: their list is the last axis, the slowest.
  std::string header = layered(true);
  const auto instead = [&](const std::string& what, const std::string& with) {
    ASSERT_NE(header.find(what), std::string::npos) << what;
    header.replace(header.find(what), what.size(), with);
  };
  instead("sizes: 2 6 1 1", "sizes: 6 1 1 2");
  instead("space directions: none (1,0,0) (0,1,0) (0,0,2)", "space directions: (1,0,0) (0,1,0) (0,0,2) none");
  instead("kinds: list domain domain domain", "kinds: domain domain domain list");
  test::writeRawNrrd(folder / "first.seg.nrrd", layered(true), std::string("\1\0\1\0\1\1\0\1\0\0\0\0", 12));
  test::writeRawNrrd(folder / "last.seg.nrrd", header, std::string("\1\1\1\0\0\0\0\0\1\1\0\0", 12));
  const auto first = readLabelMap(folder / "first.seg.nrrd"), last = readLabelMap(folder / "last.seg.nrrd");
  ASSERT_TRUE(first) << first.error().message;
  ASSERT_TRUE(last) << last.error().message;
  EXPECT_EQ(last->labels.voxels, first->labels.voxels);
  EXPECT_EQ(last->labels.geometry, first->labels.geometry);
}

TEST(LabelImport, LayersWithoutANameBelongToTheSegmentsInTheirOrder) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "l.seg.nrrd", layered(false), std::string("\1\0\0\1\0\0\0\0\0\0\0\0", 12));
  const auto imported = importLabels(blankCase(), folder / "l.seg.nrrd");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->labels.at(0, 0, 0), kArtery);
  EXPECT_EQ(imported->labels.at(1, 0, 0), kVein);
}

TEST(LabelImport, PlacesBetweenTwoVoxelsAllTakeTheSameSide) {
  test::TemporaryFolder folder;
  PatientCase patient;
  VolumeGeometry g = test::grid({8, 8, 7}, {0.7, 0.9, 1.25}, {-123.4, 56.7, 8.9});
  g.direction = test::obliqueDirection();
  patient.ct = CtVolume(g, 0);
  patient.labels = LabelMap(g);
  // Every second voxel, as a program keeps them that works at half the resolution.
  PatientCase coarse;
  VolumeGeometry half = g;
  half.size = {4, 4, 4};
  half.spacing_mm = 2.0 * g.spacing_mm;
  coarse.ct = CtVolume(half, 0);
  coarse.labels = LabelMap(half);
  for (int n = 0; n < 64; ++n) coarse.labels.voxels[n] = static_cast<std::uint8_t>(1 + n % 15);
  const auto check = [&](const std::filesystem::path& file) {
    const auto imported = importLabels(patient, file);
    ASSERT_TRUE(imported) << imported.error().message;
    for (int k = 0; k < 7; ++k)
      for (int j = 0; j < 8; ++j)
        for (int i = 0; i < 8; ++i)
          ASSERT_EQ(imported->labels.at(i, j, k), coarse.labels.at(i / 2, j / 2, k / 2)) << i << ' ' << j << ' ' << k;
  };
  ASSERT_TRUE(writeLabelFile(coarse, folder / "a.seg.nrrd"));
  check(folder / "a.seg.nrrd");
  ASSERT_TRUE(writeDicomSegmentation(coarse, folder / "a.dcm"));
  check(folder / "a.dcm");
}

TEST(LabelImport, LabelsOfAnotherPlaceAreRefused) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "l.seg.nrrd", header("2 1 1", "(900,202,-48)") + kVeinSegment, "\1\1");
  EXPECT_THAT(importLabels(blankCase(), folder / "l.seg.nrrd").error().message,
              testing::AllOf(HasSubstr("l.seg.nrrd"), HasSubstr("drawn on another CT")));
}

TEST(LabelImport, ItkSnapsDescriptionNamesTheNumbers) {
  test::TemporaryFolder folder;
  std::string voxels(6 * 5 * 4, '\0');
  voxels[0] = 1, voxels[1] = 2, voxels[2] = 3, voxels[3] = 9, voxels[4] = 4;
  test::writeRawNrrd(folder / "seg.nrrd", header("6 5 4", "(100,200,-50)"), voxels);
  test::writeText(folder / "names.txt",
                  "# ITK-SnAP Label Description File\n    0     0    0    0        0  0  0    \"Clear Label\"\n"
                  "    1    10   20   30        1  1  1    \"Internal jugular \"\n"
                  "    2   216  101   79      0.5  1  1    \"Artery, common carotid\"\n"
                  "    3   255    0    0        1  1  1    \"Mr Smith's tumour\"\r\n"
                  "    4   255    0    0        1  1  1    \"label 47\"\n");
  const auto imported = importLabels(blankCase(), folder / "seg.nrrd", {.names = folder / "names.txt"});
  ASSERT_TRUE(imported) << imported.error().message;
  const auto& found = imported->labels.voxels;
  EXPECT_EQ((std::vector<int>(found.begin(), found.begin() + 5)),
            (std::vector<int>{kVein, kArtery, kLabelCount, 0, 47}));
  EXPECT_EQ(imported->colors.at(kVein), (LabelColor{10, 20, 30}));
  EXPECT_FALSE(imported->colors.contains(kArtery)) << "the label table's own colour";
  EXPECT_THAT(imported->notes, Contains(HasSubstr("The number 9 is not described")));
  EXPECT_THAT(imported->notes, Contains(HasSubstr("tumour")));
  PatientCase patient = blankCase();
  replaceLabels(LabelReadResult(*imported), patient);
  EXPECT_THAT(patient.manifest.importNotes, testing::Each(testing::Not(HasSubstr("Smith"))));
  EXPECT_EQ(patient.manifest.ownLabels, (OwnLabels{{kLabelCount, {"", kSoftTissue}}})) << "a name identifies";

  std::filesystem::rename(folder / "names.txt", folder / "seg.label.txt");
  const auto beside = importLabels(blankCase(), folder / "seg.nrrd");
  ASSERT_TRUE(beside) << beside.error().message;
  EXPECT_EQ(beside->labels.voxels, imported->labels.voxels) << "found beside the map";
}

TEST(LabelImport, ADamagedDescriptionIsNamedWithItsLine) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "seg.nrrd", header("6 5 4", "(100,200,-50)"), std::string(120, '\1'));
  const auto refusal = [&](const std::string& text) {
    test::writeText(folder / "names.txt", text);
    return importLabels(blankCase(), folder / "seg.nrrd", {.names = folder / "names.txt"}).error().message;
  };
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("describes no labels"));
  EXPECT_THAT(refusal("\n1 2 3 4 1 1 1 \"vein\"\nvein\n"), HasSubstr("Line 3 of"));
  EXPECT_THAT(refusal("1 2 3 400 1 1 1 \"vein\"\n"), HasSubstr("Line 1 of"));
  EXPECT_THAT(refusal("1 2 3 4 1 1 1 vein\"\n"), HasSubstr("in quotes"));
  EXPECT_THAT(importLabels(blankCase(), folder / "seg.nrrd", {.names = folder / "none"}).error().message,
              HasSubstr("Could not read"));
}

/// A map of the numbers 1, 2 and 51 in the first three voxels.
void writeNumbers(const std::filesystem::path& file) {
  std::string voxels(6 * 5 * 4, '\0');
  voxels[0] = 1, voxels[1] = 2, voxels[2] = 51;
  test::writeRawNrrd(file, header("6 5 4", "(100,200,-50)"), voxels);
}

std::vector<int> firstThree(const Result<LabelReadResult>& read) {
  if (!read) return {};
  return {read->labels.voxels.begin(), read->labels.voxels.begin() + 3};
}

/// Number 1 is the spleen for TotalSegmentator, and skin here.
TEST(LabelImport, NumbersWithoutNamesAreRefusedUnlessTheyAreOurs) {
  test::TemporaryFolder folder;
  writeNumbers(folder / "map.nrrd");
  const auto refused = importLabels(blankCase(), folder / "map.nrrd");
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::AllOf(HasSubstr("map.nrrd"), HasSubstr("(1, 2, 51)"),
                                                      HasSubstr("--names"), HasSubstr("--ours")));
  const auto ours = importLabels(blankCase(), folder / "map.nrrd", {.areProgramLabels = true});
  ASSERT_TRUE(ours) << ours.error().message;
  EXPECT_EQ(firstThree(ours), (std::vector<int>{1, 2, 51}));
  EXPECT_TRUE(ours->isUnnamed);
  ASSERT_EQ(ours->structures.size(), 3U);
  EXPECT_EQ(ours->structures[2].number, 51);
}

TEST(LabelImport, OtherProgramsNameTheNumbers) {
  test::TemporaryFolder folder;
  writeNumbers(folder / "map.nrrd");
  test::writeText(folder / "slicer.ctbl",
                  "# Color\n0 Background 0 0 0 0\n1 internal_jugular_vein 1 2 3 255\n"
                  "2 common_carotid_artery 4 5 6 255\n51 trachea 7 8 9 255\n");
  test::writeText(folder / "dcmqi.json",
                  R"({"segmentAttributes": [[{"labelID": 1, "SegmentedPropertyTypeCodeSequence": {"CodeValue":
                  "12123001", "CodeMeaning": "x"}}, {"labelID": 2, "SegmentLabel": "carotid artery"}],
                  [{"labelID": 51, "SegmentDescription": "Trachea"}, {"labelID": "no number"}]]})");
  test::writeText(folder / "nnunet.json", R"({"labels": {"background": 0, "vein": 1, "artery": 2, "trachea": 51}})");
  test::writeText(folder / "former.json",
                  R"({"labels": {"0": "background", "1": "vein", "2": "artery", "51": "airway"}})");
  for (const char* names : {"slicer.ctbl", "dcmqi.json", "nnunet.json", "former.json"}) {
    const auto read = importLabels(blankCase(), folder / "map.nrrd", {.names = folder / names});
    ASSERT_TRUE(read) << names << ": " << read.error().message;
    EXPECT_EQ(firstThree(read), (std::vector<int>{kVein, kArtery, kAirway})) << names;
    EXPECT_FALSE(read->isUnnamed);
    EXPECT_EQ(read->structures.size(), 3U) << names;
    EXPECT_THAT(read->notes, Contains(HasSubstr(names)));
  }
  for (const char* damaged : {"", "{", "[1]", "{\"labels\": 3}", "{\"segmentAttributes\": [7]}"}) {
    test::writeText(folder / "damaged.json", damaged);
    EXPECT_THAT(importLabels(blankCase(), folder / "map.nrrd", {.names = folder / "damaged.json"}).error().message,
                HasSubstr("names no labels"))
        << damaged;
  }
}

/// NIfTI-1 with the label table that TotalSegmentator adds to its header.
void writeNamedNifti(const std::filesystem::path& file, const std::string& extension) {
  std::string bytes(352 + 8 + extension.size(), '\0');
  const auto put = [&bytes](std::size_t at, auto value) { std::memcpy(bytes.data() + at, &value, sizeof value); };
  put(0, std::int32_t{348});
  for (const auto& [axis, size] : {std::pair{0, 3}, {1, 6}, {2, 5}, {3, 4}}) put(40 + 2 * axis, std::int16_t(size));
  put(70, std::int16_t{2}), put(72, std::int16_t{8});
  for (const auto& [axis, spacing] : {std::pair{0, 1.F}, {1, 1.F}, {2, 1.F}, {3, 2.F}}) put(76 + 4 * axis, spacing);
  put(108, float(bytes.size()));
  put(254, std::int16_t{1});
  const float rows[3][4] = {{-1, 0, 0, -100}, {0, -1, 0, -200}, {0, 0, 2, -50}};
  std::memcpy(bytes.data() + 280, rows, sizeof rows);
  bytes.replace(344, 4, std::string("n+1\0", 4));
  bytes[348] = 1;
  put(352, std::int32_t(8 + extension.size()));
  bytes.replace(360, extension.size(), extension);
  std::string voxels(6 * 5 * 4, '\0');
  voxels[0] = 1, voxels[1] = 2, voxels[2] = 51;
  test::writeText(file, bytes + voxels);
}

TEST(LabelImport, ANiftiHeaderNamesTheNumbers) {
  test::TemporaryFolder folder;
  const std::string table =
      "<CaretExtension><VolumeInformation Index=\"0\"><LabelTable>"
      "<Label Key=\"1\" Red=\"1\" Green=\"0\" Blue=\"0\" Alpha=\"1\"><![CDATA[spleen]]></Label>\n"
      "<Label Key=\"2\" Red=\"1\"><![CDATA[brachiocephalic_vein_left]]></Label>"
      "<Label Key=\"51\"><![CDATA[common_carotid_artery_left]]></Label></LabelTable></CaretExtension>";
  writeNamedNifti(folder / "map.nii", table);
  const auto read = importLabels(blankCase(), folder / "map.nii");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(firstThree(read), (std::vector<int>{kBackground, kVein, kArtery})) << "a spleen is no skin";
  EXPECT_THAT(read->notes, Contains(HasSubstr("the file's header")));
  EXPECT_TRUE(std::ranges::is_sorted(read->structures, {}, &ReadStructure::number));
  for (const char* other : {"", "<Label Key=\"x\"><![CDATA[a]]></Label>", "<Label Key=\"1\"", "<Label ]]><![CDATA["}) {
    writeNamedNifti(folder / "map.nii", other);
    EXPECT_THAT(importLabels(blankCase(), folder / "map.nii").error().message, HasSubstr("does not say")) << other;
  }
}

TEST(LabelImport, WhatIsWrittenComesBack) {
  test::TemporaryFolder folder;
  PatientCase patient = test::noiseCase(test::grid({6, 5, 4}, {1, 1, 2}, {100, 200, -50}));
  patient.labels.voxels[0] = 200, patient.labels.voxels[1] = 254;
  patient.manifest.ownLabels = {{254, {"vein for later", kArtery}}};
  patient.manifest.states = {{kVein, LabelState::Flagged}, {254, LabelState::NotStarted}};
  patient.colors = {{kVein, {1, 2, 3}}, {254, {4, 5, 6}}};
  ASSERT_TRUE(writeLabelFile(patient, folder / "a.seg.nrrd"));
  EXPECT_THAT(test::contentOf(folder / "a.label.txt"),
              testing::AllOf(HasSubstr("\"label 200\""), HasSubstr("\"vein for later\"")));
  const auto back = importLabels(patient, folder / "a.seg.nrrd");
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(back->labels.voxels, patient.labels.voxels);
  EXPECT_EQ(back->own.at(254), patient.manifest.ownLabels.at(254)) << "written here, by an author";
  EXPECT_EQ(back->states.at(kVein), LabelState::Flagged);
  EXPECT_EQ(back->states.at(254), LabelState::NotStarted);
  EXPECT_EQ(back->states.at(kArtery), LabelState::InProgress) << "what nobody said is what can be seen";
  EXPECT_EQ(back->colors, patient.colors);
  EXPECT_THAT(writeLabelFile(patient, folder / "a.nrrd").error().message, HasSubstr(".seg.nrrd"));
  EXPECT_THAT(writeLabelFile(blankCase(), folder / "b.seg.nrrd").error().message, HasSubstr("Nothing is labeled"));
}

TEST(LabelImport, OtherFilesGetASentence) {
  test::TemporaryFolder folder;
  test::writeText(folder / "text", "no labels");
  EXPECT_THAT(importLabels(blankCase(), folder / "text").error().message, HasSubstr("contains no labels"));
  EXPECT_THAT(importLabels(blankCase(), folder / "none").error().message, HasSubstr("There is no file"));
  EXPECT_THAT(importLabels(blankCase(), folder.path()).error().message, HasSubstr("contains no labels"));
}

}  // namespace
}  // namespace insonate
