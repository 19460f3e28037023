#include "CaseSamples.h"
#include "support/TestData.h"

#include <insonate/cases/LabelFile.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

const std::string kGrid =
    "space: left-posterior-superior\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n"
    "space origin: (0,0,0)\n";

std::string segment(int n, const std::string& name, int value, const std::string& tags = "", int layer = 0) {
  const std::string key = "Segment" + std::to_string(n) + "_";
  return key + "ID:=s" + std::to_string(n) + "\n" + key + "Name:=" + name + "\n" + key +
         "LabelValue:=" + std::to_string(value) + "\n" + key + "Layer:=" + std::to_string(layer) + "\n" + key +
         "Tags:=" + tags + "\n";
}

TEST(LabelFile, SlicerSegmentsAreMappedByTerminologyThenName) {
  test::TemporaryFolder folder;
  const auto file = folder / "labels.seg.nrrd";
  test::writeRawNrrd(file,
                     "type: unsigned char\ndimension: 3\nsizes: 5 1 1\n" + kGrid +
                         segment(0, "Segment_1", 1,
                                 "TerminologyEntry:list~SCT^85756007^Tissue~SCT^12123001^Internal "
                                 "jugular vein~^^~Anatomic codes~^^~^^|") +
                         segment(1, "Left common carotid artery", 2) + segment(2, "Tumour", 3),
                     std::string("\0\1\2\3\4", 5));
  const auto read = readLabelMap(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(read->labels.voxels, testing::ElementsAre(kBackground, kVein, kArtery, kLabelCount, kBackground));
  EXPECT_THAT(read->notes, testing::Contains(HasSubstr("\"Tumour\"")));
  EXPECT_EQ(read->own, (OwnLabels{{kLabelCount, {"Tumour", kSoftTissue}}})) << "kept apart, under its name";
  EXPECT_THAT(read->notes, testing::Contains(HasSubstr("4 in the file belongs to no segment")));
}

TEST(LabelFile, LayersAreFlattened) {
  test::TemporaryFolder folder;
  const auto file = folder / "labels.seg.nrrd";
  test::writeRawNrrd(file,
                     "type: unsigned char\ndimension: 4\nsizes: 2 3 1 1\nspace: left-posterior-superior\n"
                     "space directions: none (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
                     "kinds: list domain domain domain\n" +
                         segment(0, "muscle", 1, "", 0) + segment(1, "vein", 1, "", 1),
                     std::string("\1\0\1\1\0\1", 6));
  const auto read = readLabelMap(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(read->labels.voxels, testing::ElementsAre(kMuscle, kVein, kVein));
  EXPECT_THAT(read->notes, testing::Contains(HasSubstr("1 voxels belong to several segments")));
}

TEST(LabelFile, PlainMapKeepsItsNumbers) {
  test::TemporaryFolder folder;
  const auto file = folder / "labels.nrrd";
  const auto write = [&](std::vector<short> values) {
    test::writeRawNrrd(file, "type: short\ndimension: 3\nsizes: 3 1 1\n" + kGrid, test::bytesOf(values));
  };
  write({0, 6, 200});
  const auto read = readLabelMap(file);
  ASSERT_TRUE(read);
  EXPECT_THAT(read->labels.voxels, testing::ElementsAre(0, 6, 200));
  write({0, 6, 300});
  EXPECT_THAT(readLabelMap(file).error().message, HasSubstr("label 300"));
  EXPECT_THAT(readLabelValues(file)->voxels, testing::ElementsAre(0, 6, 300));
  write({0, -6, 3});
  EXPECT_THAT(readLabelMap(file).error().message, HasSubstr("label -6"));
}

TEST(LabelFile, FractionsAreNoLabels) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "l.nrrd", "type: float\ndimension: 3\nsizes: 2 1 1\n" + kGrid,
                     test::bytesOf(std::vector<float>{1, 2.5F}));
  EXPECT_THAT(readLabelMap(folder / "l.nrrd").error().message, HasSubstr("whole numbers"));
}

TEST(LabelFile, AtlasIsNotMirrored) {
  INSONATE_NEEDS_DATA("neck-atlas-labels");
  const auto atlas = readLabelValues(test::testData("neck-atlas-labels/HN-Atlas-labels.nrrd"));
  ASSERT_TRUE(atlas) << atlas.error().message;
  const VolumeGeometry& g = atlas->geometry;
  EXPECT_EQ(g.size, (std::array{255, 255, 229}));
  EXPECT_EQ(g.direction.column[0], (Vec3{-1, 0, 0}));
  EXPECT_EQ(g.direction.column[1], (Vec3{0, -1, 0}));
  EXPECT_EQ(g.direction.column[2], (Vec3{0, 0, 1}));
  EXPECT_LT(norm(g.origin_mm - Vec3{124.0234375, 124.0234375, -159.6027816}), 1e-6);
}

}  // namespace
}  // namespace insonate
