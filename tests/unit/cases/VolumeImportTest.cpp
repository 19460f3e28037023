#include "CaseSamples.h"
#include "VolumeFiles.h"
#include "import/ValueShift.h"
#include "support/TestData.h"

#include <insonate/cases/Import.h>

#include <gmock/gmock.h>

#include <functional>

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

TEST(VolumeImport, ASlopeThatSaturatesIsCounted) {
  test::TemporaryFolder folder;
  test::writeText(folder / "a.nii", test::niftiOf(CtVolume(kGrid, 400), test::kRas, 100, 0));
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->saturatedVoxels, imported->ct.voxels.size());
  EXPECT_EQ(imported->ct.at(1, 1, 1), 32767);
}

/// A body in air as a scanner of 12 bits stores it: HU + 1024, nothing below 0.
CtVolume storedWithOffset() {
  CtVolume ct(test::grid({20, 20, 10}, {2, 2, 2}, {0, 0, 0}), 0);
  for (int k = 0; k < 10; ++k)
    for (int j = 0; j < 20; ++j)
      for (int i = 0; i < 20; ++i) {
        const int noise = (31 * i + 17 * j + 7 * k) % 150;
        const bool body = i >= 4 && i < 16 && j >= 4 && j < 16;
        ct.at(i, j, k) = std::int16_t(!body ? noise : i == 4 ? 924 : i == 8 && j == 8 ? 1900 : 985 + noise);
      }
  return ct;
}

TEST(VolumeImport, ValuesWhoseOffsetIsMissingAreSeenAndShiftedOnlyWhenAsked) {
  test::TemporaryFolder folder;
  const CtVolume stored = storedWithOffset();
  test::writeText(folder / "a.nii", test::niftiOf(stored, test::kRas, 1, 0));
  auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->ct.voxels, stored.voxels) << "never by itself";
  ASSERT_EQ(imported->likelyShift_HU, -1024);
  EXPECT_THAT(imported->series.warnings, testing::Contains(HasSubstr("to which 1024 was added")));

  imported->ct.voxels[0] = -1024;  // padding
  imported->ct.voxels[1] = 0;
  shiftValues(*imported, -1024);
  EXPECT_EQ(imported->ct.voxels[0], -1024);
  EXPECT_EQ(imported->ct.voxels[1], -1024);
  EXPECT_EQ(imported->ct.at(4, 4, 0), -100);
  EXPECT_THAT(imported->series.warnings.back(), HasSubstr("-1024 was added to every value"));
  EXPECT_FALSE(imported->likelyShift_HU);
  shiftValues(*imported, 4000);
  EXPECT_EQ(imported->ct.voxels[0], -1024) << "padding is nothing that was measured";
}

TEST(VolumeImport, NoOffsetIsSeenWhereThereIsNone) {
  const auto likely = [](const std::function<int(int)>& valueOf) {
    CtVolume ct = storedWithOffset();
    for (std::int16_t& value : ct.voxels) value = std::int16_t(valueOf(value));
    return likelyShift(ct).has_value();
  };
  EXPECT_FALSE(likely([](int v) { return v - 1024; })) << "Hounsfield units";
  EXPECT_FALSE(likely([](int v) { return std::max(0, v - 1024); })) << "cut off at 0";
  EXPECT_FALSE(likely([](int v) { return v + 1000; })) << "no air at 0";
  EXPECT_FALSE(likely([](int v) { return v / 4; })) << "another scale";
  // A cloud of values as bone has, behind air and muscle that were cut off.
  EXPECT_FALSE(likely([n = 0](int v) mutable { return v < 900 ? 0 : 200 + 37 * n++ % 1500; }));
  EXPECT_FALSE(likely([](int) { return -1024; })) << "nothing but padding";
  EXPECT_TRUE(likely([](int v) { return v; }));
  EXPECT_TRUE(likely([](int v) { return v < 20 ? -1024 : v; })) << "padding is no value";
}

/// As nibabel writes it: a rotated grid, its directions rounded to floats, in an sform alone.
TEST(VolumeImport, ObliqueNiftiIsRead) {
  test::TemporaryFolder folder;
  VolumeGeometry g = kGrid;
  g.direction = test::obliqueDirection();
  g.direction.column[2] = -1.0 * g.direction.column[2];
  const CtVolume ct = test::noiseCt(g);
  const Transform t = g.patientFromIndex();
  std::array<std::array<float, 4>, 3> sform;
  for (int row = 0; row < 3; ++row) {
    const double sign = row < 2 ? -1 : 1;
    for (int column = 0; column < 3; ++column) sform[row][column] = float(sign * t.linear.column[column][row]);
    sform[row][3] = float(sign * t.offset[row]);
  }
  test::writeText(folder / "a.nii", test::niftiOf(ct, sform, 1, 0));
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_EQ(imported->ct.voxels, ct.voxels);
  for (const Vec3 corner : {Vec3{0, 0, 0}, Vec3{4, 3, 2}})
    EXPECT_LT(norm(imported->ct.geometry.patientFromIndex() * corner - t * corner), 1e-4);
}

/// A half turn about z that only the qform says; the third axis is turned by the sign in pixdim[0].
std::string qformOnly(const CtVolume& ct) {
  std::string bytes = test::niftiOf(ct, {}, 1, 0);
  test::putAt<std::int16_t>(bytes, 254, 0);
  test::putAt<std::int16_t>(bytes, 252, 1);
  test::putAt<float>(bytes, 76, -1);
  const float quaternion[3] = {0, 0, 1}, offset[3] = {10, -20, 30};
  std::memcpy(bytes.data() + 256, quaternion, sizeof quaternion);
  std::memcpy(bytes.data() + 268, offset, sizeof offset);
  return bytes;
}

TEST(VolumeImport, NiftisQformAndUnits) {
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kGrid);
  std::string bytes = qformOnly(ct);
  const auto cornerOf = [&] {
    test::writeText(folder / "a.nii", bytes);
    const auto imported = importSeries(folder / "a.nii");
    EXPECT_TRUE(imported) << imported.error().message;
    return imported ? imported->ct.geometry.patientFromIndex() * Vec3{4, 3, 2} : Vec3{};
  };
  const Vec3 corner{-10 + 4 * 0.5, 20 + 3 * 0.75, 30 - 2 * 2};
  EXPECT_LT(norm(cornerOf() - corner), 1e-4);
  test::putAt<std::int16_t>(bytes, 254, 2);  // an sform that leads elsewhere
  EXPECT_LT(norm(cornerOf() - corner), 1e-4);
  bytes = test::niftiOf(ct, {{{-500, 0, 0, 10000}, {0, -750, 0, -20000}, {0, 0, 2000, 30000}}}, 1, 0);
  test::putAt<char>(bytes, 123, 3);  // micrometers
  EXPECT_LT(norm(cornerOf() - Vec3{-10 + 4 * 0.5, 20 + 3 * 0.75, 30 + 2 * 2}), 1e-4);
}

TEST(VolumeImport, NiftisNumbersInEitherByteOrder) {
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kGrid);
  const std::string header = test::niftiOf(ct, test::kRas, 1, 0).substr(0, 352);
  const auto imported = [&](std::int16_t datatype, const std::string& voxels, bool swap) {
    std::string bytes = header + voxels;
    test::putAt<std::int16_t>(bytes, 70, datatype);
    if (swap) bytes = test::swappedNifti(bytes);
    test::writeText(folder / "a.nii", bytes);
    const auto read = importSeries(folder / "a.nii");
    EXPECT_TRUE(read) << read.error().message;
    return read ? read->ct : CtVolume{};
  };
  const auto as = [&]<class T>(T) { return test::bytesOf(std::vector<T>(ct.voxels.begin(), ct.voxels.end())); };
  for (const auto& [datatype, voxels] : {std::pair<std::int16_t, std::string>{8, as(std::int32_t{})},
                                         {16, as(float{})},
                                         {64, as(double{})},
                                         {1024, as(std::int64_t{})}})
    EXPECT_EQ(imported(datatype, voxels, false).voxels, ct.voxels) << datatype;
  const CtVolume swapped = imported(4, as(std::int16_t{}), true);
  EXPECT_EQ(swapped.voxels, ct.voxels);
  EXPECT_TRUE(sameGrid(swapped.geometry, kGrid));
}

TEST(VolumeImport, TheSecondNiftiIsRead) {
  test::TemporaryFolder folder;
  const CtVolume ct = test::noiseCt(kGrid);
  test::writeText(folder / "a.nii", test::secondNiftiOf(ct, test::kRas));
  const auto imported = importSeries(folder / "a.nii");
  ASSERT_TRUE(imported) << imported.error().message;
  EXPECT_TRUE(sameGrid(imported->ct.geometry, kGrid));
  EXPECT_EQ(imported->ct.voxels, ct.voxels);
}

TEST(VolumeImport, OfANiftiWhatIsNoVolumeIsRefused) {
  test::TemporaryFolder folder;
  const std::string whole = test::niftiOf(test::noiseCt(kGrid), test::kRas, 1, 0);
  const auto refusal = [&](const std::function<void(std::string&)>& edit) {
    std::string bytes = whole;
    edit(bytes);
    test::writeText(folder / "a.nii", bytes);
    const auto imported = importSeries(folder / "a.nii");
    EXPECT_FALSE(imported);
    return imported ? "" : imported.error().message;
  };
  EXPECT_THAT(refusal([](std::string& b) { b[345] = 'x'; }), HasSubstr("not a NIfTI file"));
  EXPECT_THAT(refusal([](std::string& b) { test::putAt<float>(b, 108, 1e30F); }), HasSubstr("not a NIfTI file"));
  EXPECT_THAT(refusal([](std::string& b) { test::putAt<std::int16_t>(b, 70, 32); }), HasSubstr("number type"));
  EXPECT_THAT(refusal([](std::string& b) { test::putAt<std::int16_t>(b, 70, 128); }), HasSubstr("3 values per voxel"));
  EXPECT_THAT(refusal([](std::string& b) { test::putAt<std::int16_t>(b, 42, -5); }), HasSubstr("-5 voxels"));
  EXPECT_THAT(refusal([](std::string& b) {
                test::putAt<std::int16_t>(b, 40, 4);
                test::putAt<std::int16_t>(b, 48, 7);
              }),
              HasSubstr("4 dimensions"));
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
    EXPECT_EQ(testing::Value(imported->series.warnings, testing::Contains(HasSubstr("does not state its orientation"))),
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
