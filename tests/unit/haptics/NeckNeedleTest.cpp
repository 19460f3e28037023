#include "NeedleRig.h"

#include <insonate/cases/Phantom.h>

namespace insonate::haptics {
namespace {

/// The point farthest inside the vein, away from the ends of the map.
Vec3 deepInVein(const TissueGrid& grid) {
  const VolumeGeometry& g = grid.geometry();
  const Transform patientFromIndex = g.patientFromIndex();
  Vec3 best;
  double deepest_mm = 0;
  for (int k = g.size[2] / 3; k < 2 * g.size[2] / 3; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        const double inside_mm = -grid.at(p).distance_mm[1];
        if (inside_mm > deepest_mm) deepest_mm = inside_mm, best = p;
      }
  return best;
}

/// The built-in neck as its labels have it, voxels and all: from the front and the right, at several angles.
TEST(NeckNeedle, SkinAndVeinOnceEachInTheBuiltInNeck) {
  const auto patient = makePhantom(phantomVariants().front().name, 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto grid = TissueGrid::fromLabels(patient->labels);
  ASSERT_TRUE(grid) << grid.error().message;
  const Vec3 vein = deepInVein(**grid);
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
