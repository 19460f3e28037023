#include "NeedleRig.h"

#include <insonate/cases/Phantom.h>

namespace insonate::haptics {
namespace {

/// Middle of the vein of one side in the map's middle slice.
Vec3 middleOfVein(const LabelMap& labels) {
  const VolumeGeometry& g = labels.geometry;
  Vec3 sum;
  int count = 0;
  for (int j = 0; j < g.size[1]; ++j)
    for (int i = 0; i < g.size[0] / 2; ++i)
      if (labels.at(i, j, g.size[2] / 2) == kVein)
        sum = sum + Vec3{double(i), double(j), double(g.size[2] / 2)}, ++count;
  return g.patientFromIndex() * (sum / std::max(count, 1));
}

/// The built-in neck as its labels have it, voxels and all: from the front and the right, at several angles.
TEST(NeckNeedle, SkinAndVeinOnceEachInTheBuiltInNeck) {
  const auto patient = makePhantom(phantomVariants().front().name, 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const Vec3 vein = middleOfVein(patient->labels);
  const auto grid = TissueGrid::fromLabels(patient->labels, vein, 60);
  ASSERT_TRUE(grid) << grid.error().message;
  ASSERT_LT((*grid)->at(vein).distance_mm[1], -3);
  for (const Vec3 axis : {Vec3{0, 1, 0}, Vec3{0.15, 1, 0}, Vec3{0, 1, -0.7}, Vec3{0.1, 1, -1}}) {
    NeedleRig rig;
    rig.grid = *grid;
    const Vec3 way = normalized(axis);
    rig.at = vein - way * 58.0;
    rig.put(rig.at, way);
    rig.push(vein, way, 30);
    EXPECT_EQ(rig.count(NeedleEventKind::Entered, kSkin), 1) << axis.x << " " << axis.z;
    EXPECT_EQ(rig.count(NeedleEventKind::Entered, kVein), 1) << axis.x << " " << axis.z;
    EXPECT_EQ(rig.needle.state().in, kVein);
    rig.push(vein - way * 58.0, way, 30);
    EXPECT_EQ(rig.count(NeedleEventKind::Withdrawn, kVein), 1);
    EXPECT_EQ(rig.count(NeedleEventKind::Withdrawn, kSkin), 1);
    EXPECT_EQ(rig.events.size(), 4U) << axis.x << " " << axis.z;
  }
}

}  // namespace
}  // namespace insonate::haptics
