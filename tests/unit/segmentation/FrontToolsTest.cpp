#include "ToolGrids.h"

#include <insonate/core/Hash.h>
#include <insonate/segmentation/FastMarching.h>
#include <insonate/segmentation/FillBetweenSlices.h>
#include <insonate/segmentation/GrowFromSeeds.h>
#include <insonate/segmentation/LevelSet.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using test::difference;
using testing::HasSubstr;

class FrontsOnGrids : public test::OnGrids {
 protected:
  /// Bright where it is chosen, with noise.
  CtVolume ctOf(const Selection& bright, int noise_HU = 20) const {
    CtVolume ct(grid());
    for (std::size_t v = 0; v < ct.voxels.size(); ++v) {
      const double u = unitInterval(hashNode(int(v), 1, 2, 3)) + unitInterval(hashNode(int(v), 5, 6, 7)) - 1;
      ct.voxels[v] = static_cast<std::int16_t>((bright.mask.voxels[v] ? 250 : 50) + noise_HU * u * 2.45);
    }
    return ct;
  }
  double dice(const Selection& a, const Selection& b) const {
    const auto all = double(a.count() + b.count());
    return 1 - double(difference(a, b)) / all;
  }
  double largestSpacing_mm() const {
    const Vec3& s = grid().spacing_mm;
    return std::max({s.x, s.y, s.z});
  }
};
INSONATE_ON_GRIDS(FrontsOnGrids);

TEST_P(FrontsOnGrids, MarchesAtOneMillimetreInEvenTissue) {
  const CtVolume even(grid(), 60);
  const auto reached = fastMarching(even, boxOf(grid()), std::array{Vec3{}}, {.reach_mm = 12});
  ASSERT_TRUE(reached) << reached.error().message;
  // The scheme is of first order: a diagonal way comes out longer by up to a voxel and a half.
  const double error_mm = 1.5 * largestSpacing_mm();
  const Selection least = ball({}, 12 - error_mm), most = ball({}, 12 + error_mm);
  for (std::size_t v = 0; v < least.mask.voxels.size(); ++v) {
    ASSERT_LE(least.mask.voxels[v], reached->mask.voxels[v]);
    ASSERT_LE(reached->mask.voxels[v], most.mask.voxels[v]);
  }
}

TEST_P(FrontsOnGrids, AFrontStopsAtAnEdge) {
  const Selection bright = ball({}, 10);
  const auto reached =
      fastMarching(ctOf(bright, 5), boxOf(grid()), std::array{Vec3{}}, {.reach_mm = 18, .edge_HUpmm = 15});
  ASSERT_TRUE(reached) << reached.error().message;
  const Selection least = ball({}, 9 - 1.5 * largestSpacing_mm()), most = ball({}, 10 + 1.5 * largestSpacing_mm());
  for (std::size_t v = 0; v < least.mask.voxels.size(); ++v) {
    ASSERT_LE(least.mask.voxels[v], reached->mask.voxels[v]);
    ASSERT_LE(reached->mask.voxels[v], most.mask.voxels[v]);
  }
}

TEST_P(FrontsOnGrids, LevelSetGrowsToTheEdgeOfABall) {
  const Selection bright = ball({}, 10);
  const auto grown = levelSet(ctOf(bright), ball({1, 0, 0}, 5), {.edge_HUpmm = 25, .rounds = 300});
  ASSERT_TRUE(grown) << grown.error().message;
  EXPECT_GT(dice(*grown, bright), 0.92);
}

TEST_P(FrontsOnGrids, LevelSetShrinksToABallFromOutside) {
  const Selection bright = ball({}, 8);
  const auto shrunk =
      levelSet(ctOf(bright), ball({}, 13), {.edge_HUpmm = 25, .propagation = -1, .advection = 2, .rounds = 300});
  ASSERT_TRUE(shrunk) << shrunk.error().message;
  EXPECT_GT(dice(*shrunk, bright), 0.88);
}

TEST_P(FrontsOnGrids, LevelSetAsksBetweenTheStepsOfItsPreparation) {
  const CtVolume ct = ctOf(ball({}, 10));
  const Selection start = ball({1, 0, 0}, 5);
  const GeodesicLevelSet parameters{.rounds = 20};
  int asked = 0, steps = 0;
  ASSERT_TRUE(levelSet(ct, start, parameters, [&](std::string_view doing, double share) {
    ++asked;
    steps += doing == "Moving the surface" && share == 0;
    return true;
  }));
  EXPECT_GE(steps, 4) << "speed, advection, zero crossing, layers";
  ASSERT_GT(asked, steps + 20);
  for (int last = 0; last < asked - 20; ++last) {
    int n = 0;
    const auto stopped = levelSet(ct, start, parameters, [&](std::string_view, double) { return n++ != last; });
    ASSERT_FALSE(stopped) << last;
    EXPECT_EQ(stopped.error().message, kCancelled);
    EXPECT_LE(n, last + 4) << "it goes on for more than a round when told to stop";
  }
}

TEST_P(FrontsOnGrids, FillingDrawsAnObliqueTubeBetweenItsSlices) {
  for (int axis = 0; axis < 3; ++axis) {
    const Mat3& d = grid().direction;
    const Vec3 u = d.column[axis], v = d.column[(axis + 1) % 3];
    // Widens from 4 to 6 mm and moves 0.4 mm aside a millimeter of way, more than its width from drawing to drawing.
    const Selection tube = shape([&](Vec3 p) {
      const double along = dot(p, u);
      return std::abs(along) < 15.91 && norm(p - u * along - v * (0.4 * along)) < 5 + along / 16;
    });
    Selection drawn = tube;
    const int step = std::max(2, int(8 / grid().spacing_mm[axis]));
    std::vector<bool> isDrawn(std::size_t(grid().size[axis]), false);
    const VoxelBox extent = boundingBoxOf(tube.mask, 1);
    for (int n = extent.first[axis]; n < extent.end[axis]; n += step) isDrawn[n] = true;
    isDrawn[extent.end[axis] - 1] = true;
    std::array<int, 3> at{};
    for (at[2] = 0; at[2] < grid().size[2]; ++at[2])
      for (at[1] = 0; at[1] < grid().size[1]; ++at[1])
        for (at[0] = 0; at[0] < grid().size[0]; ++at[0])
          if (!isDrawn[at[axis]]) drawn.mask.at(at[0], at[1], at[2]) = 0;
    const auto filled = fillBetweenSlices(drawn, axis);
    ASSERT_TRUE(filled) << filled.error().message;
    EXPECT_GT(dice(*filled, tube), 0.94) << axis;
    for (std::size_t n = 0; n < drawn.mask.voxels.size(); ++n)
      ASSERT_GE(filled->mask.voxels[n], drawn.mask.voxels[n]) << "what was drawn stays";
  }
}

TEST_P(FrontsOnGrids, FillingNeedsTwoDrawingsApart) {
  Selection one(grid(), boxOf(grid()));
  one.mask.at(4, 4, 4) = 1;
  for (const auto& refused :
       {fillBetweenSlices(one, 2), fillBetweenSlices(Selection{}, 2), fillBetweenSlices(ball({}, 5), 2)}) {
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().message, HasSubstr("no empty slices between the drawn slices"));
  }
}

/// A ball of bright tissue, with one seed in it and one beside, as an author would paint them.
struct Contest {
  LabelMap labels;
  Seeds seeds;
};

class ContestsOnGrids : public FrontsOnGrids {
 protected:
  Contest contest() const {
    Contest c{LabelMap(grid(), kSoftTissue), {}};
    const Selection inner = ball({}, 3), outer = shape([](Vec3 p) { return norm(p) > 16; });
    for (std::size_t v = 0; v < c.labels.voxels.size(); ++v)
      if (inner.mask.voxels[v] || outer.mask.voxels[v]) c.labels.voxels[v] = inner.mask.voxels[v] ? kVein : kMuscle;
    c.seeds = seedsOf(c.labels, boxOf(grid()), LabelSet().set(kVein).set(kMuscle), LabelSet().set(kSoftTissue));
    return c;
  }
  Selection wonBy(const Proposal& proposal, std::uint8_t label) const {
    Selection won(grid(), boxOf(grid()));
    for (std::size_t v = 0; v < won.mask.voxels.size(); ++v) won.mask.voxels[v] = proposal.labels.voxels[v] == label;
    return won;
  }
};
INSONATE_ON_GRIDS(ContestsOnGrids);

TEST_P(ContestsOnGrids, SeedsGrowToTheEdgeBetweenThem) {
  const Selection bright = ball({}, 10);
  const auto grown = grownFromSeeds(ctOf(bright), contest().seeds, {});
  ASSERT_TRUE(grown) << grown.error().message;
  EXPECT_GT(dice(wonBy(*grown, kVein), bright), 0.95);
  EXPECT_EQ(wonBy(*grown, kVein).count() + wonBy(*grown, kMuscle).count(), grown->labels.voxels.size());
}

TEST_P(ContestsOnGrids, WaterMeetsAtTheEdge) {
  const Selection bright = ball({}, 10);
  const auto flooded = watershed(ctOf(bright), contest().seeds, 1.2);
  ASSERT_TRUE(flooded) << flooded.error().message;
  EXPECT_GT(dice(wonBy(*flooded, kVein), bright), 0.9);
  EXPECT_EQ(wonBy(*flooded, kVein).count() + wonBy(*flooded, kMuscle).count(), flooded->labels.voxels.size());
}

TEST_P(ContestsOnGrids, InEvenTissueTheNearerSeedWins) {
  const CtVolume even(grid(), 50);
  const auto grown = grownFromSeeds(even, contest().seeds, {});
  ASSERT_TRUE(grown);
  const auto [i, j, k] = nearestVoxel(grid().indexFromPatient() * Vec3{5, 0, 0});
  const auto [x, y, z] = nearestVoxel(grid().indexFromPatient() * Vec3{13.5, 0, 0});
  EXPECT_EQ(grown->labels.at(i, j, k), kVein);
  EXPECT_EQ(grown->labels.at(x, y, z), kMuscle);
}

TEST_P(ContestsOnGrids, LabelsThatAreNotContestedAreWalls) {
  Contest c = contest();
  const Selection wall = shape([](Vec3 p) { return norm(p) > 8 && norm(p) < 14; });
  for (std::size_t v = 0; v < c.labels.voxels.size(); ++v)
    if (wall.mask.voxels[v]) c.labels.voxels[v] = kBone;
  c.seeds = seedsOf(c.labels, boxOf(grid()), LabelSet().set(kVein).set(kMuscle), LabelSet().set(kSoftTissue));
  const CtVolume even(grid(), 50);
  const auto flooded = watershed(even, c.seeds, 1);
  const auto grown = grownFromSeeds(even, c.seeds, {});
  ASSERT_TRUE(grown && flooded);
  for (const Proposal* p : {&*grown, &*flooded}) {
    EXPECT_EQ(difference(wonBy(*p, kVein), ball({}, 8)), 0u);
    EXPECT_EQ(difference(wonBy(*p, Proposal::kKeep), wall), 0u);
  }
}

TEST(Fronts, RefuseWhatTheyCannotStartFrom) {
  const VolumeGeometry g = test::toolGrids()[0].geometry;
  const CtVolume ct(g);
  EXPECT_THAT(fastMarching(ct, boxOf(g), std::array{Vec3{900, 0, 0}}, {}).error().message, HasSubstr("No click"));
  EXPECT_THAT(fastMarching(ct, VoxelBox{}, std::array{Vec3{}}, {}).error().message, HasSubstr("No click"));
  EXPECT_THAT(levelSet(ct, Selection(g, boxOf(g)), {}).error().message, HasSubstr("so its surface cannot move"));
  LabelMap labels(g, kSoftTissue);
  labels.at(3, 3, 3) = kVein;
  const Seeds one = seedsOf(labels, boxOf(g), LabelSet().set(kVein), LabelSet().set(kSoftTissue));
  EXPECT_THAT(grownFromSeeds(ct, one, {}).error().message, HasSubstr("Seeds of at least two labels are needed"));
  EXPECT_THAT(watershed(ct, one, 1).error().message, HasSubstr("1 found"));
}

TEST(Fronts, StopWhenAsked) {
  const VolumeGeometry g = test::toolGrids()[0].geometry;
  const CtVolume ct(g, 60);
  LabelMap labels(g, kSoftTissue);
  labels.at(3, 3, 3) = kVein;
  labels.at(30, 30, 30) = kFat;
  const Seeds seeds = seedsOf(labels, boxOf(g), LabelSet().set(kVein).set(kFat), LabelSet().set(kSoftTissue));
  Selection start(g, boxOf(g));
  for (int n = 10; n < 20; ++n) start.mask.at(n, 20, 20) = 1;
  int calls = 0;
  const Progress stop = [&](std::string_view, double) { return ++calls < 3; };
  EXPECT_EQ(fastMarching(ct, boxOf(g), std::array{Vec3{}}, {}, stop).error().message, kCancelled);
  EXPECT_EQ(levelSet(ct, start, {}, stop).error().message, kCancelled);
  EXPECT_EQ(watershed(ct, seeds, 1, stop).error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
