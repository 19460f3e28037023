#include "Neck.h"

#include <insonate/views/VtkCase.h>

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>

namespace insonate::views {
namespace {

TEST(VtkCase, WrapsThePatientsVoxelsWithoutCopying) {
  VolumeGeometry grid;
  grid.size = {4, 3, 2};
  const auto patient = test::oneVoxel(grid, 2, 1, 1);
  const VtkCase shown(patient);
  EXPECT_EQ(shown.ct()->GetScalarPointer(), patient->ct.voxels.data());
  EXPECT_EQ(shown.ct()->GetScalarComponentAsDouble(2, 1, 1, 0), 1000);
}

TEST(VtkCase, TakesACopyOfTheSamePatientInPlace) {
  VolumeGeometry grid;
  grid.size = {4, 3, 2};
  VtkCase shown(test::oneVoxel(grid, 2, 1, 1));
  auto* const array = shown.ct()->GetPointData()->GetScalars();
  const auto revision = shown.labelRevision();
  const auto copy = test::oneVoxel(grid, 2, 1, 1);
  ASSERT_TRUE(shown.setPatient(copy));
  EXPECT_EQ(shown.ct()->GetScalarPointer(), copy->ct.voxels.data());
  EXPECT_EQ(shown.ct()->GetPointData()->GetScalars(), array) << "others hold it, too";
  EXPECT_EQ(&shown.patient(), copy.get());
  EXPECT_NE(shown.labelRevision(), revision);
  grid.size = {4, 3, 3};
  EXPECT_FALSE(shown.setPatient(test::oneVoxel(grid, 2, 1, 1)));
  EXPECT_EQ(&shown.patient(), copy.get());
}

TEST(VtkCase, PlacesVoxelsOfObliqueAndLeftHandedGrids) {
  const double c = std::cos(0.4), s = std::sin(0.4);
  VolumeGeometry grid;
  grid.size = {6, 5, 4};
  grid.spacing_mm = {0.7, 0.9, 2.5};
  grid.origin_mm = {-30, 12, 700};
  grid.direction = {{Vec3{c, s, 0}, Vec3{0, 0, -1}, Vec3{-s, c, 0}}};
  grid.direction.column[2] = -grid.direction.column[2];
  const VtkCase shown(test::oneVoxel(grid, 0, 0, 0));
  const Vec3 expected = grid.patientFromIndex() * Vec3{5, 3, 2};
  double point[3];
  shown.ct()->TransformIndexToPhysicalPoint(5, 3, 2, point);
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(point[axis], expected[axis], 1e-9);
}

}  // namespace
}  // namespace insonate::views
