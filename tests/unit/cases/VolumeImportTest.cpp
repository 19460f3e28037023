#include "CaseSamples.h"
#include "VolumeFiles.h"
#include "support/TestData.h"

#include <insonate/cases/Import.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

const VolumeGeometry kGrid = test::grid({5, 4, 3}, {0.5, 0.75, 2}, {-10, 20, 30});

TEST(VolumeImport, NiftiIsTurnedToLps) {
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kGrid);
  // LPS (x, y, z) is (-x, -y, z) in RAS.
  test::writeText(folder / "a.nii", test::niftiOf(ct, test::kRas, 1, 0));
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_TRUE(sameGrid(imported->ct.geometry, kGrid));
  EXPECT_EQ(imported->ct.voxels, ct.voxels);
  EXPECT_THAT(imported->source, testing::Not(HasSubstr("a.nii"))) << "file names may name patients";
}

TEST(VolumeImport, NiftiSlopeAndIntercept) {
  test::TemporaryFolder folder;
  test::writeText(folder / "a.nii", test::niftiOf(CtVolume(kGrid, 100), test::kRas, 2, -1000));
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->ct.at(1, 1, 1), -800);
}

TEST(VolumeImport, MetaImageKeepsItsDirections) {
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kGrid);
  test::writeText(folder / "a.mha", test::metaImage(ct, "-1 0 0 0 -1 0 0 0 1"));
  const auto imported = importSeries(folder / "a.mha");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->ct.voxels, ct.voxels);
  EXPECT_EQ(imported->ct.geometry.direction.column[0], (Vec3{-1, 0, 0}));
  EXPECT_EQ(imported->ct.geometry.spacing_mm, kGrid.spacing_mm);
  EXPECT_EQ(imported->ct.geometry.origin_mm, kGrid.origin_mm);
}

TEST(VolumeImport, MasksArePointedOut) {
  test::TemporaryFolder folder;
  test::writeText(folder / "mask.mha", test::metaImage(CtVolume(kGrid), "1 0 0 0 1 0 0 0 1", "MET_UCHAR"));
  const auto listing = listSeries(folder.path());
  ASSERT_TRUE(listing);
  EXPECT_THAT(listing->series.at(0).refusal, HasSubstr("8 bits"));
  EXPECT_THAT(importSeries(folder.path()).error().message, HasSubstr("8 bits"));
}

TEST(VolumeImport, ShearedNrrdIsStraightened) {
  test::TemporaryFolder folder;
  VolumeGeometry g = test::grid({30, 30, 8});
  CtVolume ct(g);
  // HU as a linear function of place, on a grid whose slices step sideways by 0.4 mm.
  for (int k = 0; k < 8; ++k)
    for (int j = 0; j < 30; ++j)
      for (int i = 0; i < 30; ++i) ct.at(i, j, k) = static_cast<std::int16_t>(10 * i + 20 * (j + 0.4 * k) - 30 * k);
  test::writeRawNrrd(folder / "a.nrrd",
                     "type: short\ndimension: 3\nsizes: 30 30 8\nspace: left-posterior-superior\n"
                     "space directions: (1,0,0) (0,1,0) (0,0.4,1)\nspace origin: (0,0,0)\n",
                     test::bytesOf(ct.voxels));
  const auto imported = importSeries(folder / "a.nrrd");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_THAT(imported->series.warnings, testing::Contains(HasSubstr("tilted by 21.8 degrees")));
  EXPECT_TRUE(validate(imported->ct.geometry));
  for (int k = 0; k < 8; ++k) EXPECT_NEAR(imported->ct.at(7, 12, k), 10 * 7 + 20 * 12 - 30 * k, 1.01);
}

TEST(VolumeImport, SkewedRowsAreRefused) {
  test::TemporaryFolder folder;
  test::writeRawNrrd(folder / "a.nrrd",
                     "type: short\ndimension: 3\nsizes: 4 4 4\nspace: left-posterior-superior\n"
                     "space directions: (1,0,0) (0.5,1,0) (0,0,1)\nspace origin: (0,0,0)\n",
                     test::bytesOf(std::vector<short>(64)));
  EXPECT_THAT(importSeries(folder / "a.nrrd").error().message, HasSubstr("right angles"));
}

TEST(VolumeImport, EachSpaceOfNrrdIsTurnedToLps) {
  test::TemporaryFolder folder;
  struct Space {
    const char *name, *directions, *origin;
    bool patient;
  };
  const Space spaces[] = {
      {"left-posterior-superior", "(0.8,0.6,0) (-0.6,0.8,0) (0,0,2)", "(10,20,30)", true},
      {"right-anterior-superior", "(-0.8,-0.6,0) (0.6,-0.8,0) (0,0,2)", "(-10,-20,30)", true},
      {"left-anterior-superior", "(0.8,-0.6,0) (-0.6,-0.8,0) (0,0,2)", "(10,-20,30)", true},
      {"scanner-xyz", "(0.8,0.6,0) (-0.6,0.8,0) (0,0,2)", "(10,20,30)", false},
  };
  for (const Space& space : spaces) {
    test::writeRawNrrd(folder / "a.nrrd",
                       std::string("type: short\ndimension: 3\nsizes: 4 4 4\nspace: ") + space.name +
                           "\nspace directions: " + space.directions + "\nspace origin: " + space.origin + "\n",
                       test::bytesOf(std::vector<short>(64)));
    const auto imported = importSeries(folder / "a.nrrd");
    ASSERT_TRUE(imported) << imported.error().message;
    const Transform patientFromIndex = imported->ct.geometry.patientFromIndex();
    const Vec3 corner = patientFromIndex * Vec3{3, 1, 2};
    EXPECT_LT(norm(corner - Vec3{10 + 3 * 0.8 - 0.6, 20 + 3 * 0.6 + 0.8, 34}), 1e-9) << space.name;
    EXPECT_EQ(testing::Value(imported->series.warnings, testing::Contains(HasSubstr("does not say how it lies"))),
              !space.patient)
        << space.name;
  }
}

TEST(VolumeImport, DamagedFilesGetASentence) {
  test::TemporaryFolder folder;
  for (const char* name : {"a.nrrd", "a.nii", "a.nii.gz", "a.mha"}) {
    test::writeText(folder / name, "this is no picture");
    const auto imported = importSeries(folder / name);
    ASSERT_FALSE(imported) << name;
    EXPECT_THAT(imported.error().message, HasSubstr(name));
  }
}

}  // namespace
}  // namespace insonate
