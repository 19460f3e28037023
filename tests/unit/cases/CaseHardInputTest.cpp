#include "CaseSamples.h"
#include "support/TestData.h"

#include <insonate/cases/PatientCase.h>

#include <gmock/gmock.h>

#include <limits>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kLps =
    "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
    "space origin: (0,0,0)\nkinds: domain domain domain\n";

class HardCase : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(writeCase(test::noiseCase(test::grid({4, 4, 4})), path)); }
  std::string errorOf() {
    const auto read = readCase(path);
    EXPECT_FALSE(read);
    return read ? "" : read.error().message;
  }
  test::TemporaryFolder folder;
  const std::filesystem::path path = folder / "case";
};

TEST_F(HardCase, NotANumberAndPaddingBecomeAir) {
  std::vector<float> hu(64, 40.4F);
  hu[0] = std::numeric_limits<float>::quiet_NaN();
  hu[1] = -3024;
  hu[2] = 1e6F;
  hu[3] = -std::numeric_limits<float>::infinity();
  test::writeRawNrrd(path / "ct.nrrd", std::string("type: float\ndimension: 3\nsizes: 4 4 4\n") + kLps,
                     test::bytesOf(hu));
  const auto read = readCase(path);
  ASSERT_TRUE(read) << read.error().message;
  const auto& ct = read->patient.ct.voxels;
  EXPECT_EQ(ct[0], -1024);
  EXPECT_EQ(ct[1], -1024);
  EXPECT_EQ(ct[2], 32767);
  EXPECT_EQ(ct[3], -1024);
  EXPECT_EQ(ct[4], 40);
  EXPECT_THAT(read->notes, testing::Contains(HasSubstr("1 voxels of the CT were not a number")));
  EXPECT_THAT(read->notes, testing::Contains(HasSubstr("2 voxels of the CT were below -1024")));
}

TEST_F(HardCase, FourDimensionsAndColorAreRefused) {
  test::writeRawNrrd(path / "ct.nrrd", "type: short\ndimension: 4\nsizes: 4 4 4 2\n",
                     test::bytesOf(std::vector<short>(128)));
  EXPECT_THAT(errorOf(), HasSubstr("dimensions"));
  test::writeRawNrrd(path / "ct.nrrd",
                     "type: unsigned char\ndimension: 4\nsizes: 3 4 4 4\nspace: left-posterior-superior\n"
                     "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
                     "kinds: RGB-color domain domain domain\n",
                     std::string(192, '\7'));
  EXPECT_THAT(errorOf(), HasSubstr("3 values per voxel"));
}

TEST_F(HardCase, TruncatedVolumeIsRefused) {
  const std::string whole = test::contentOf(path / "ct.nrrd");
  for (const std::size_t cut : {std::size_t{12}, whole.size() / 4, whole.size() - 40}) {
    test::writeText(path / "ct.nrrd", whole.substr(0, whole.size() - cut));
    EXPECT_THAT(errorOf(), HasSubstr("ct.nrrd")) << "without the last " << cut << " bytes";
  }
  test::writeText(path / "ct.nrrd", "");
  EXPECT_THAT(errorOf(), HasSubstr("ct.nrrd"));
}

TEST_F(HardCase, GridsThatDifferAreRefusedWithTheDifference) {
  const std::string type = "type: unsigned char\ndimension: 3\n";
  std::filesystem::remove(path / "labels.seg.nrrd");
  const auto labels = [&](const std::string& fields, int count) {
    test::writeRawNrrd(path / "labels.nrrd", type + fields, std::string(count, '\1'));
  };
  labels("sizes: 4 4 5\n" + std::string(kLps), 80);
  EXPECT_THAT(errorOf(), AllOf(HasSubstr("4x4x4"), HasSubstr("4x4x5")));
  labels(
      "sizes: 4 4 4\nspace: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,2)\n"
      "space origin: (0,0,0)\n",
      64);
  EXPECT_THAT(errorOf(), HasSubstr("spacing"));
  labels(
      "sizes: 4 4 4\nspace: left-posterior-superior\nspace directions: (-1,0,0) (0,1,0) (0,0,1)\n"
      "space origin: (3,0,0)\n",
      64);
  EXPECT_THAT(errorOf(), HasSubstr("axis 1"));
  labels(
      "sizes: 4 4 4\nspace: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
      "space origin: (0,0,50)\n",
      64);
  EXPECT_THAT(errorOf(), HasSubstr("starts at"));
  labels(
      "sizes: 4 4 4\nspace: right-anterior-superior\nspace directions: (-1,0,0) (0,-1,0) (0,0,1)\n"
      "space origin: (0,0,0)\n",
      64);
  EXPECT_TRUE(readCase(path)) << "the same grid, written in another space";
}

TEST_F(HardCase, VoxelsThatNoScannerMakesAreRefused) {
  test::writeRawNrrd(path / "ct.nrrd",
                     "type: short\ndimension: 3\nsizes: 4 4 4\nspace: left-posterior-superior\n"
                     "space directions: (0.001,0,0) (0,0.001,0) (0,0,0.001)\nspace origin: (0,0,0)\n",
                     test::bytesOf(std::vector<short>(64)));
  EXPECT_THAT(errorOf(), AllOf(HasSubstr("0.001 mm"), HasSubstr("meters?")));
}

TEST_F(HardCase, AFileIsNoCase) {
  const auto read = readCase(path / "ct.nrrd");
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("is a file"));
}

TEST_F(HardCase, ReadersSpeakWithoutTheirClassNames) {
  test::writeText(path / "ct.nrrd", "NRRD0005\nrubbish");
  EXPECT_THAT(errorOf(), AllOf(HasSubstr("ct.nrrd"), testing::Not(HasSubstr("itk::")), testing::Not(HasSubstr("0x"))));
}

TEST_F(HardCase, MissingPartsAreNamed) {
  std::filesystem::remove(path / "labels.seg.nrrd");
  EXPECT_THAT(errorOf(), HasSubstr("labels.seg.nrrd"));
  std::filesystem::remove(path / "ct.nrrd");
  EXPECT_THAT(errorOf(), HasSubstr("ct.nrrd"));
  std::filesystem::remove_all(path);
  EXPECT_THAT(errorOf(), HasSubstr("no case folder"));
}

TEST_F(HardCase, ManifestIsValidated) {
  const auto errorWith = [&](const std::string& json) {
    test::writeText(path / "case.json", json);
    return errorOf();
  };
  EXPECT_THAT(errorWith("{"), AllOf(HasSubstr("not valid JSON: line 1, column 2: "), testing::Not(HasSubstr("["))));
  EXPECT_THAT(errorWith("[]"), HasSubstr("object"));
  EXPECT_THAT(errorWith("{}"), HasSubstr("has no \"schema_version\"; add \"schema_version\": 1"));
  EXPECT_THAT(errorWith(R"({"schema_version": 99})"), HasSubstr("newer"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "title": 3})"), HasSubstr("case.json needs a text as 'title', not 3"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "structures": [{"label": "vein", "opacity": 2}]})"),
              HasSubstr("structure 1 needs a number from 0 to 1 as 'opacity', not 2"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "structures": [{"label": "vein", "visible": 1}]})"),
              HasSubstr("structure 1 needs true or false as 'visible', not 1"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "structures": [{"opacity": 1}]})"),
              HasSubstr("structure 1 has no 'label'"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "import_notes": [1]})"),
              HasSubstr("texts in the list 'import_notes'"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "import_notes": "one"})"),
              HasSubstr("a list [ ... ] as 'import_notes'"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "targets": [{"label": "vein", "position_mm": [1, 2]}]})"),
              HasSubstr("target 1 needs a list of 3 numbers, [x, y, z], as 'position_mm'"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "targets": [{"label": "spleen", "position_mm": [1, 2, 3]}]})"),
              HasSubstr("target 1 needs the name or number (1 to 255) of a label as 'label'"));
  EXPECT_THAT(errorWith(R"({"schema_version": 1, "start_poses":
                            [{"position_mm": [0,0,0], "axial": [0,0,1], "lateral": [0,0,2]}]})"),
              HasSubstr("start pose 1 needs a direction as 'lateral'"));
}

TEST_F(HardCase, VesselsAndDifficultyAreValidated) {
  const auto errorWith = [&](const std::string& fields) {
    test::writeText(path / "case.json", R"({"schema_version": 1, )" + fields + "}");
    return errorOf();
  };
  const auto errorOfVessel = [&](const std::string& course) {
    return errorWith(R"("vessels": [{"name": "jugular", "label": "vein", "course_mm": )" + course + "}]");
  };
  EXPECT_THAT(errorOfVessel("[]"), HasSubstr("vessel 'jugular' needs a list of points"));
  EXPECT_THAT(errorOfVessel("[[1, 2, 3, 4], [1, 2, 3]]"), HasSubstr("point 2 needs [x, y, z, radius] in mm"));
  EXPECT_THAT(errorOfVessel("[[1, 2, 3, 101]]"), HasSubstr("a radius from 0 to 100"));
  EXPECT_THAT(errorWith(R"("vessels": [{"name": "", "label": 9, "course_mm": [[1, 2, 3, 4]]}])"),
              HasSubstr("vessel 1 needs a text as 'name'"));
  EXPECT_THAT(errorWith(R"("difficulty": "huge")"), HasSubstr("it is one of easy, moderate"));
}

TEST_F(HardCase, ManifestOfAnEarlierProgramIsRead) {
  // Written with empty texts, without vessels and versions, and with fields that no program knows any more.
  test::writeText(path / "case.json", R"({
  "description": "", "difficulty": "", "import_notes": [], "landmarks": [{"code": "", "name": "", "position_mm": [1, 2, 3]}],
  "schema_version": 1, "source": "",
  "start_poses": [{"axial": [0, 0, 1], "lateral": [1, 0, 0], "name": "", "position_mm": [0, 0, 0]}],
  "structures": [{"label": "vein", "opacity": 0.5, "visible": false, "color": "red"}, {"label": 20, "name": "", "tissue": "vein"}],
  "targets": [{"label": "vein", "name": "", "position_mm": [1, 2, 3]}, {"label": 7, "name": "", "position_mm": [4, 5, 6]}],
  "title": ""})");
  const auto read = readCase(path);
  ASSERT_TRUE(read) << read.error().message;
  const CaseManifest& manifest = read->patient.manifest;
  EXPECT_EQ(manifest.title, "");
  EXPECT_EQ(manifest.targets.size(), 2U) << "of one name";
  EXPECT_EQ(manifest.landmarks.size(), 1U);
  EXPECT_EQ(manifest.shown.at(kVein), (SurfaceAppearance{0.5, false}));
  EXPECT_EQ(manifest.ownLabels, (OwnLabels{{20, {"", kVein}}}));
  EXPECT_EQ(manifest.version.number, 0);
}

TEST_F(HardCase, SlantedPoseIsStraightenedAndSaid) {
  test::writeText(path / "case.json", R"({"schema_version": 1, "unheard_of": 1, "start_poses":
      [{"name": "p", "position_mm": [0,0,0], "axial": [0,0,2], "lateral": [1,0,1]}]})");
  const auto read = readCase(path);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->patient.manifest.startPoses[0].axial, (Vec3{0, 0, 1}));
  EXPECT_EQ(read->patient.manifest.startPoses[0].lateral, (Vec3{1, 0, 0}));
  EXPECT_THAT(read->notes, testing::UnorderedElementsAre(HasSubstr("straightened"), HasSubstr("unheard_of")));
}

}  // namespace
}  // namespace insonate
