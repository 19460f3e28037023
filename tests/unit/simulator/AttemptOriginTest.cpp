#include <insonate/cases/CaseVersions.h>
#include <insonate/simulator/AttemptOrigin.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

PatientCase twoVoxels() {
  VolumeGeometry grid;
  grid.size = {2, 1, 1};
  PatientCase patient{{}, CtVolume(grid, 40), LabelMap(grid)};
  patient.labels.at(0, 0, 0) = 3;
  patient.ct.at(1, 0, 0) = -1000;
  return patient;
}

/// FNV-1a by hand over 2, 1, 1; 3, 0; 40, 64536. Recordings keep it: it must never change.
TEST(AttemptOrigin, HashIsThatOfSizeLabelsAndCt) {
  EXPECT_EQ(voxelHashOf(twoVoxels()), "52b2f407e7ca6964");
}

TEST(AttemptOrigin, HashTellsALabelAndAVoxelApartAndNotATitle) {
  PatientCase other = twoVoxels();
  other.manifest.title = "another";
  EXPECT_EQ(voxelHashOf(other), voxelHashOf(twoVoxels()));
  other.labels.at(1, 0, 0) = 1;
  EXPECT_NE(voxelHashOf(other), voxelHashOf(twoVoxels()));
  other = twoVoxels();
  other.ct.at(0, 0, 0) = 41;
  EXPECT_NE(voxelHashOf(other), voxelHashOf(twoVoxels()));
}

}  // namespace
}  // namespace insonate
