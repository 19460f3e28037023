#include "model/Boundary.h"

#include <gtest/gtest.h>

namespace insonate {
namespace {

/// Samples of a layer's profile, 1 in its middle and less in its flanks, that are covered at a place of the given
/// patch.
int coveredSamples(double patchiness, double patch) {
  int covered = 0;
  for (double occupancy = 0.05; occupancy < 1; occupancy += 0.1)
    covered += layerCover(occupancy, patchiness, patch) > 0;
  return covered;
}

TEST(LayerCover, AnEvenLayerIsItsProfileEverywhere) {
  for (const double patch : {-3.0, -0.5, 0.0, 2.0})
    for (const double occupancy : {0.0, 0.3, 1.0}) EXPECT_EQ(layerCover(occupancy, 0, patch), occupancy);
}

TEST(LayerCover, APatchyLayerBecomesThinnerBeforeItEnds) {
  const int thick = coveredSamples(0.8, 1), medium = coveredSamples(0.8, 0), thin = coveredSamples(0.8, -0.5);
  EXPECT_EQ(thick, 10);
  EXPECT_LT(medium, thick);
  EXPECT_LT(thin, medium);
  EXPECT_GT(thin, 0);
  EXPECT_GT(layerCover(1, 0.8, -3), 0) << "its middle remains";
  EXPECT_EQ(layerCover(1, 1, -3), 0) << "a layer of full patchiness has gaps";
}

TEST(LayerCover, IsBetweenNothingAndTheProfile) {
  for (double patch = -4; patch <= 4; patch += 0.25)
    for (double patchiness = 0; patchiness <= 1; patchiness += 0.25) {
      const double cover = layerCover(0.7, patchiness, patch);
      EXPECT_GE(cover, 0);
      EXPECT_LE(cover, 0.7);
    }
}

TEST(SurfaceOf, BothWallsOfAVesselAreItsIntima) {
  AcousticTissue vessel, muscle;
  vessel.vessel = true;
  EXPECT_EQ(&surfaceOf(muscle, vessel), &vessel);
  EXPECT_EQ(&surfaceOf(vessel, muscle), &vessel);
}

}  // namespace
}  // namespace insonate
