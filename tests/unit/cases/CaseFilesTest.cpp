#include "CaseSamples.h"
#include "support/TestData.h"

#include <insonate/cases/PatientCase.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

struct Grid {
  const char* name;
  VolumeGeometry geometry;
};

std::vector<Grid> grids() {
  VolumeGeometry oblique = test::grid({7, 5, 9}, {0.7, 0.7, 1.3}, {-12.3, 45.6, -789.1});
  oblique.direction = test::obliqueDirection();
  VolumeGeometry leftHanded = oblique;
  leftHanded.direction.column[2] = -leftHanded.direction.column[2];
  VolumeGeometry mirrored = test::grid({6, 4, 5}, {0.9765625, 0.9765625, 1.4}, {124, 124, -159.6});
  mirrored.direction.column[0] = {-1, 0, 0};
  mirrored.direction.column[1] = {0, -1, 0};
  return {{"oblique", oblique},
          {"leftHanded", leftHanded},
          {"mirrored", mirrored},
          {"anisotropic", test::grid({8, 6, 4}, {1, 1, 5})},
          {"oneSlice", test::grid({6, 5, 1}, {1, 1, 3})}};
}

class CaseRoundTrip : public testing::TestWithParam<Grid> {};

TEST_P(CaseRoundTrip, KeepsVoxelsGridAndManifest) {
  test::TemporaryFolder folder;
  PatientCase patient = test::noiseCase(GetParam().geometry);
  patient.manifest.title = "Ä \"quoted\" title";
  patient.manifest.difficulty = "hard";
  patient.manifest.shown = {{kVein, {0.4, true}}, {kBone, {1, false}}};
  patient.labels.voxels[0] = 100;
  patient.manifest.ownLabels = {{100, {"left \u00c4ste", kVein}}, {101, {"nothing yet", kBone}}};
  patient.manifest.states = {{kVein, LabelState::Completed}, {101, LabelState::Flagged}};
  patient.manifest.importNotes = {"The slices were tilted.", "Padding was named."};
  patient.manifest.targets = {{"vein", kVein, {1.5, -2.25, 1e-3}}};
  patient.manifest.vessels = {{"left \u00c4ste", kArtery, {{{1, 2, 3.5}, 2.25}, {{4, 5, 6}, 0}}, {{1, 2, 4.5}}}};
  patient.manifest.startPoses = {{"start", {0, 1, 2}, {0, 0.6, 0.8}, {1, 0, 0}}};
  const auto written = writeCase(patient, folder / "case");
  ASSERT_TRUE(written) << written.error().message;
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;

  EXPECT_THAT(read->notes, testing::IsEmpty());
  EXPECT_EQ(read->patient.ct.voxels, patient.ct.voxels);
  EXPECT_EQ(read->patient.labels.voxels, patient.labels.voxels);
  const VolumeGeometry &a = patient.ct.geometry, &b = read->patient.ct.geometry;
  EXPECT_EQ(a.size, b.size);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(a.spacing_mm[axis], b.spacing_mm[axis], 1e-12);
    EXPECT_NEAR(a.origin_mm[axis], b.origin_mm[axis], 1e-12);
    EXPECT_LT(norm(a.direction.column[axis] - b.direction.column[axis]), 1e-12);
  }
  const CaseManifest& m = read->patient.manifest;
  EXPECT_EQ(m.title, patient.manifest.title);
  EXPECT_EQ(m.difficulty, "hard");
  EXPECT_EQ(m.shown, patient.manifest.shown);
  EXPECT_EQ(m.ownLabels, patient.manifest.ownLabels);
  EXPECT_EQ(m.states.at(kVein), LabelState::Completed);
  EXPECT_EQ(m.states.at(101), LabelState::Flagged);
  EXPECT_EQ(m.importNotes, patient.manifest.importNotes);
  ASSERT_EQ(m.targets.size(), 1U);
  EXPECT_EQ(m.targets[0].label, kVein);
  EXPECT_EQ(m.targets[0].position_mm, patient.manifest.targets[0].position_mm);
  EXPECT_EQ(m.vessels, patient.manifest.vessels);
  ASSERT_EQ(m.startPoses.size(), 1U);
  EXPECT_LT(norm(m.startPoses[0].axial - Vec3{0, 0.6, 0.8}), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Grids, CaseRoundTrip, testing::ValuesIn(grids()),
                         [](const auto& chosen) { return chosen.param.name; });

TEST(CaseFiles, OpenInSlicerAndItkSnap) {
  test::TemporaryFolder folder;
  PatientCase patient = test::noiseCase(test::grid({4, 5, 6}));
  for (auto& label : patient.labels.voxels) label = label == kVein ? kVein : kBackground;
  ASSERT_TRUE(writeCase(patient, folder / "case"));
  const std::string header = test::contentOf(folder / "case/labels.seg.nrrd").substr(0, 4000);
  EXPECT_THAT(header, testing::StartsWith("NRRD0005\n"));
  for (const char* line : {"\ntype: unsigned char\n", "\nspace: left-posterior-superior\n", "\nencoding: gzip\n",
                           "\nSegment0_Name:=vein\n", "\nSegment0_LabelValue:=6\n", "\nSegment0_Layer:=0\n",
                           "\nSegment0_Extent:=0 3 0 4 0 5\n", "\nSegment0_Color:=0 0.592", "~SCT^29092000^Vein~",
                           "\nSegmentation_MasterRepresentation:=Binary labelmap\n"})
    EXPECT_THAT(header, HasSubstr(line));
  EXPECT_THAT(header, testing::Not(HasSubstr("Segment1_"))) << "only what occurs";
  EXPECT_THAT(test::contentOf(folder / "case/ct.nrrd").substr(0, 100), HasSubstr("type: short"));

  std::ifstream snap(folder / "case/labels.label.txt");
  std::string first, second;
  std::getline(snap, first);
  std::getline(snap, second);
  EXPECT_EQ(second, "# ITK-SnAP Label Description File");
}

TEST(CaseFiles, ColorsOfTheAuthorAreKeptInTheSegmentation) {
  test::TemporaryFolder folder;
  PatientCase patient = test::noiseCase(test::grid({4, 5, 6}));
  patient.colors = {{kVein, {1, 128, 254}}, {kBone, {255, 0, 77}}};
  ASSERT_TRUE(writeCase(patient, folder / "case"));
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->patient.colors, patient.colors) << "and no others";
  EXPECT_EQ(caseLabelColor(read->patient.colors, kVein), (LabelColor{1, 128, 254}));
  EXPECT_EQ(caseLabelColor(read->patient.colors, kArtery), labelTable()[kArtery].color);
  EXPECT_THAT(test::contentOf(folder / "case/labels.label.txt"), HasSubstr("    6     1  128  254"));
}

TEST(CaseFiles, FormerColorsOfTheLabelTableAreNoChoiceOfTheAuthor) {
  test::TemporaryFolder folder;
  PatientCase patient = test::noiseCase(test::grid({4, 5, 6}));
  patient.colors = {{kArtery, {216, 101, 79}}, {kMuscle, {192, 104, 88}}, {kVein, {192, 104, 88}}};
  ASSERT_TRUE(writeCase(patient, folder / "case"));
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->patient.colors, (LabelColors{{kVein, {192, 104, 88}}}));
}

/// A case whose author called a label so.
PatientCase caseWithName(const std::string& name) {
  PatientCase patient = test::noiseCase(test::grid({6, 5, 4}));
  patient.labels.voxels[0] = 16;
  patient.manifest.ownLabels = {{16, {tidyLabelName(name), kVein}}};
  return patient;
}

TEST(CaseFiles, ANameInSlicersFileGoesBeforeThatOfTheManifest) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(caseWithName("before"), folder / "case"));
  const auto file = folder / "case/labels.seg.nrrd";
  std::string bytes = test::contentOf(file);
  const std::size_t at = bytes.find("Name:=before");
  ASSERT_NE(at, std::string::npos);
  test::writeText(file, bytes.replace(at, 12, "Name:=after "));
  EXPECT_EQ(readCase(folder / "case")->patient.manifest.ownLabels, (OwnLabels{{16, {"after", kVein}}}));
}

TEST(CaseFiles, WhereItkSnapHasDroppedNamesTheManifestHasThem) {
  test::TemporaryFolder folder;
  const PatientCase patient = caseWithName("kept");
  ASSERT_TRUE(writeCase(patient, folder / "case"));
  std::filesystem::remove(folder / "case/labels.seg.nrrd");
  std::string plain = "type: unsigned char\ndimension: 3\nsizes: 6 5 4\nspace: left-posterior-superior\n";
  plain += "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n";
  test::writeRawNrrd(folder / "case/labels.nrrd", plain, test::bytesOf(patient.labels.voxels));
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->patient.manifest.ownLabels, patient.manifest.ownLabels);
}

TEST(CaseFiles, HostileNamesDoNoHarm) {
  test::TemporaryFolder folder;
  for (const std::string& name :
       {std::string(10'000, 'x'), std::string("a\nSegment0_LabelValue:=9\nb"), std::string("<img src=x> & \"q\" \\n"),
        std::string("\xff\xfe"), std::string(":=|~^")}) {
    const PatientCase patient = caseWithName(name);
    ASSERT_TRUE(writeCase(patient, folder / "case"));
    const auto read = readCase(folder / "case");
    ASSERT_TRUE(read) << read.error().message;
    EXPECT_EQ(read->patient.labels.voxels, patient.labels.voxels) << name.substr(0, 20);
    EXPECT_EQ(read->patient.manifest.ownLabels, patient.manifest.ownLabels) << name.substr(0, 20);
  }
}

TEST(CaseFiles, HostileEntriesOfLabelsAreRefusedOrTidied) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(test::noiseCase(test::grid({6, 5, 4})), folder / "case"));
  const auto read = [&](const std::string& structure) {
    test::writeText(folder / "case/case.json",
                    R"({"schema_version": 1, "structures": [{"label": 20, )" + structure + "}]}");
    return readCase(folder / "case");
  };
  EXPECT_EQ(read(R"("name": "a\nb")")->patient.manifest.ownLabels, (OwnLabels{{20, {"a b", kSoftTissue}}}));
  EXPECT_EQ(read(R"("opacity": 0.5)")->patient.manifest.ownLabels, OwnLabels{}) << "of a case of earlier programs";
  EXPECT_THAT(read(R"("name": 7)").error().message, HasSubstr("structure 1 needs a text as 'name', not 7"));
  for (const char* tissue : {R"("tissue": "stone")", R"("tissue": "background")"})
    EXPECT_THAT(read(tissue).error().message, HasSubstr("structure 1 needs a structure's name as 'tissue'")) << tissue;
  EXPECT_THAT(read(R"("state": "done")").error().message, HasSubstr("completed"));
}

TEST(CaseFiles, SameCaseSameBytes) {
  test::TemporaryFolder folder;
  const PatientCase patient = test::noiseCase(test::grid({20, 10, 6}));
  ASSERT_TRUE(writeCase(patient, folder / "a"));
  ASSERT_TRUE(writeCase(patient, folder / "b"));
  for (const char* file : {"ct.nrrd", "labels.seg.nrrd", "case.json", "labels.label.txt"})
    EXPECT_EQ(test::contentOf(folder / "a" / file), test::contentOf(folder / "b" / file)) << file;
}

TEST(CaseFiles, WithoutManifestDefaultsAreUsedAndSaid) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(test::noiseCase(test::grid({4, 4, 4})), folder / "case"));
  std::filesystem::remove(folder / "case/case.json");
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->patient.manifest.title, "Untitled case");
  EXPECT_THAT(read->notes, testing::ElementsAre(HasSubstr("no case.json")));
}

TEST(CaseFiles, FailedWriteLeavesTheOldCase) {
  test::TemporaryFolder folder;
  const PatientCase patient = test::noiseCase(test::grid({4, 4, 4}));
  ASSERT_TRUE(writeCase(patient, folder / "case"));
  const std::string before = test::contentOf(folder / "case/ct.nrrd");
  PatientCase mismatched = patient;
  mismatched.labels = LabelMap(test::grid({4, 4, 5}));
  const auto written = writeCase(mismatched, folder / "case");
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message, HasSubstr("4x4x5"));
  EXPECT_EQ(test::contentOf(folder / "case/ct.nrrd"), before);
  EXPECT_FALSE(writeCase(patient, folder / "missing/parent/case"));
  EXPECT_FALSE(std::filesystem::exists(folder / "missing"));
}

TEST(CaseFiles, AnExistingCaseIsKeptUnlessItMayBeReplaced) {
  test::TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& target, bool replace) {
    const auto ok = checkCaseTarget(target, replace);
    return ok ? std::string() : ok.error().message;
  };
  EXPECT_EQ(refusal(folder / "new", false), "");
  std::filesystem::create_directory(folder / "case");
  EXPECT_EQ(refusal(folder / "case", false), "") << "an empty folder";
  for (const char* file : {"ct.nrrd", "labels.seg.nrrd", "case.json"}) {
    test::writeText(folder / "case" / file, "mine");
    EXPECT_THAT(refusal(folder / "case", false), HasSubstr("already holds a case")) << file;
    EXPECT_EQ(refusal(folder / "case", true), "");
    std::filesystem::remove(folder / "case" / file);
  }
}

/// A file dialog that is confirmed twice enters the folder of the case.
TEST(CaseFiles, NoCaseIsWrittenIntoTheFolderOfAnother) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(caseWithName("neck"), folder / "neck"));
  const auto inside = checkCaseTarget(folder / "neck" / "neck", true);
  ASSERT_FALSE(inside);
  EXPECT_THAT(inside.error().message, HasSubstr("lies in the folder of another case"));
  EXPECT_TRUE(checkCaseTarget(folder / "neck", true));
}

TEST(CaseFiles, ReplacingLeavesNothingOfTheOldCase) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(test::noiseCase(test::grid({4, 4, 4})), folder / "case"));
  test::writeText(folder / "case/labels.nrrd", "of the old case");
  test::writeText(folder / "case/remarks.txt", "mine");
  ASSERT_TRUE(writeCase(test::noiseCase(test::grid({5, 4, 4})), folder / "case"));
  const auto read = readCase(folder / "case");
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(read->notes, testing::IsEmpty());
  EXPECT_EQ(read->patient.ct.geometry.size[0], 5);
  EXPECT_EQ(test::contentOf(folder / "case/remarks.txt"), "mine");
}

TEST(CaseFiles, CancelledWritingLeavesNothing) {
  test::TemporaryFolder folder;
  const PatientCase patient = test::noiseCase(test::grid({4, 4, 4}));
  int calls = 0;
  ASSERT_TRUE(writeCase(patient, folder / "case", [&](std::string_view, double) { return ++calls, true; }));
  EXPECT_GE(calls, 3);
  for (int stop = 1; stop <= calls; ++stop) {
    int heard = 0;
    const auto written = writeCase(patient, folder / "other", [&](std::string_view, double) { return ++heard < stop; });
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().message, kCancelled);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "the first case only";
  }
}

TEST(CaseFiles, KnowsItsOwnFiles) {
  test::TemporaryFolder folder;
  ASSERT_TRUE(writeCase(test::noiseCase(test::grid({4, 4, 4})), folder / "case"));
  std::filesystem::create_symlink(folder / "case/ct.nrrd", folder / "link.nrrd");
  EXPECT_TRUE(isCaseFile(folder / "case", folder / "case/../case/ct.nrrd"));
  EXPECT_TRUE(isCaseFile(folder / "case/", folder / "link.nrrd"));
  EXPECT_TRUE(isCaseFile(folder / "case", folder / "case/labels.nrrd")) << "not there, but would be taken for labels";
  EXPECT_FALSE(isCaseFile(folder / "case", folder / "case/echo.nrrd"));
  EXPECT_FALSE(isCaseFile(folder / "case", folder / "ct.nrrd"));
}

}  // namespace
}  // namespace insonate
