#include "support/TestData.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/Import.h>

#include <gmock/gmock.h>

#include <algorithm>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

ImportedCt importedFrom(const fs::path& path, const std::string& uid = {}) {
  auto imported = importSeries(path, uid);
  EXPECT_TRUE(imported) << imported.error().message;
  return imported ? std::move(*imported) : ImportedCt{};
}

TEST(RealImport, Neck) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  const ImportedCt neck = importedFrom(test::testData("neck-ct-dicom"));
  const VolumeGeometry& g = neck.ct.geometry;
  EXPECT_EQ(g.size, (std::array{512, 512, 99}));
  EXPECT_EQ(g.spacing_mm, (Vec3{0.976562, 0.976562, 4.25}));
  EXPECT_EQ(g.origin_mm, (Vec3{-250, -250, -375}));
  EXPECT_EQ(g.direction, Mat3{});
  EXPECT_EQ(*std::ranges::min_element(neck.ct.voxels), -1024);

  // Nothing is labeled: unfit, with the reason.
  PatientCase patient;
  patient.ct = neck.ct;
  patient.labels = LabelMap(g);
  const auto findings = checkCase(patient);
  ASSERT_TRUE(findings);
  EXPECT_FALSE(isFitForTraining(*findings));
  EXPECT_EQ(findings->front().code, "labels_empty");
}

TEST(RealImport, NeckBesideAnotherStudyIsNotMixed) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  INSONATE_NEEDS_DATA("neck-ct-mixed");
  test::TemporaryFolder folder;
  for (const char* source : {"neck-ct-dicom", "neck-ct-mixed"})
    for (const auto& entry : fs::directory_iterator(test::testData(source)))
      fs::create_symlink(fs::absolute(entry.path()), folder / (source + entry.path().filename().string()));
  const auto listing = listSeries(folder.path());
  ASSERT_TRUE(listing) << listing.error().message;
  ASSERT_EQ(listing->series.size(), 2U);
  std::vector<int> slices{listing->series[0].geometry.size[2], listing->series[1].geometry.size[2]};
  EXPECT_THAT(slices, testing::UnorderedElementsAre(99, 5));
  EXPECT_THAT(importSeries(folder.path()).error().message, HasSubstr("2 series"));
}

TEST(RealImport, SmallHead) {
  INSONATE_NEEDS_DATA("head-ct-dicom-small");
  const ImportedCt head = importedFrom(test::testData("head-ct-dicom-small"));
  EXPECT_EQ(head.ct.geometry.size, (std::array{64, 64, 93}));
  EXPECT_EQ(head.ct.geometry.spacing_mm, (Vec3{3.2, 3.2, 1.5}));
  EXPECT_EQ(head.likelyShift_HU, -1024) << "its air is at 0";
}

TEST(RealImport, TiltIsUndoneAndTheScoutLeftOut) {
  INSONATE_NEEDS_DATA("tilted-ct-dicom");
  const auto listing = listSeries(test::testData("tilted-ct-dicom"));
  ASSERT_TRUE(listing);
  ASSERT_EQ(listing->series.size(), 1U);
  ASSERT_EQ(listing->skippedFiles.size(), 1U);
  EXPECT_THAT(listing->skippedFiles[0].reason, HasSubstr("scout"));
  const ImportedCt tilted = importedFrom(test::testData("tilted-ct-dicom"));
  EXPECT_THAT(tilted.series.warnings, testing::Contains(HasSubstr("tilted by 18.5 degrees")));
  EXPECT_NEAR(tilted.ct.geometry.spacing_mm.z, 2.5 * 0.9483237, 1e-3) << "distance of the planes, not of the table";
  EXPECT_TRUE(validate(tilted.ct.geometry));
  EXPECT_FALSE(tilted.likelyShift_HU);
  // The grid begins with the first row of the highest slice, which is measured.
  for (int i = 0; i < 512; ++i) EXPECT_GT(tilted.ct.at(i, 0, 9), -1024) << i;
}

TEST(RealImport, CompressedAbdomen) {
  INSONATE_NEEDS_DATA("abdomen-ct-dicom");
  const ImportedCt abdomen = importedFrom(test::testData("abdomen-ct-dicom"));
  EXPECT_EQ(abdomen.ct.geometry.size, (std::array{512, 512, 20}));
  EXPECT_EQ(abdomen.ct.geometry.spacing_mm.z, 2);
  EXPECT_FALSE(abdomen.likelyShift_HU);
}

TEST(RealImport, EveryTransferSyntaxGivesTheSamePicture) {
  INSONATE_NEEDS_DATA("transfer-syntaxes");
  const ImportedCt plain = importedFrom(test::testData("transfer-syntaxes/CTImage.dcm"));
  int compared = 0;
  for (const auto& entry : fs::directory_iterator(test::testData("transfer-syntaxes"))) {
    if (!entry.path().filename().string().starts_with("CTImage.dcm_")) continue;
    const ImportedCt other = importedFrom(entry.path());
    EXPECT_EQ(other.ct.voxels, plain.ct.voxels) << entry.path();
    EXPECT_EQ(other.ct.geometry, plain.ct.geometry) << entry.path();
    ++compared;
  }
  EXPECT_GE(compared, 5);
  EXPECT_THAT(importSeries(test::testData("transfer-syntaxes/no-pixel-data.dcm")).error().message,
              HasSubstr("report without images"));
  EXPECT_FALSE(importSeries(test::testData("transfer-syntaxes/no-pixel-spacing.dcm")));
}

TEST(RealImport, SegmentationBesideItsCt) {
  INSONATE_NEEDS_DATA("seg-dicom");
  const ImportedCt ct = importedFrom(test::testData("seg-dicom/ct-3slice"));
  EXPECT_EQ(ct.ct.geometry.size, (std::array{512, 512, 3}));
  EXPECT_DOUBLE_EQ(ct.ct.geometry.spacing_mm.z, 1) << "slice thickness is 1.25";
  EXPECT_THAT(importSeries(test::testData("seg-dicom/liver.dcm")).error().message, HasSubstr("segmentation"));
}

TEST(RealImport, NiftiAngiogram) {
  INSONATE_NEEDS_DATA("chest-cta");
  const ImportedCt cta = importedFrom(test::testData("chest-cta"));
  EXPECT_EQ(cta.series.uid, "ct_cropped.nii.gz") << "the masks beside it are no CT";
  EXPECT_EQ(cta.ct.geometry.size, (std::array{120, 126, 164}));
  // NIfTI (-1.5, 0, 0 | 71.658), (0, -1.5, 0 | 255.658), (0, 0, 1.5 | 540.2) in RAS.
  EXPECT_NEAR(cta.ct.geometry.origin_mm.x, -71.658203125, 1e-4);
  EXPECT_NEAR(cta.ct.geometry.origin_mm.y, -255.658203125, 1e-4);
  EXPECT_LT(norm(cta.ct.geometry.direction.column[0] - Vec3{1, 0, 0}), 1e-6);
}

}  // namespace
}  // namespace insonate
