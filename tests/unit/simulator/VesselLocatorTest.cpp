#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/VesselLocator.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::Optional;

const std::vector<CenterLine> kLines{
    {{0, 10, -50}, {0, 10, 50}}, {{40, 10, -50}, {40, 10, 50}}, {{6, 2, -50}, {6, 2, 50}}};

CaseManifest twoSides() {
  CaseManifest manifest;
  manifest.targets = {{"carotid", kArtery, {5, 10, 0}},
                      {"right internal jugular vein", kVein, {1, 10, 0}},
                      {"left internal jugular vein", kVein, {39, 10, 0}}};
  return manifest;
}

TEST(VesselLocator, TheNearestTargetIsMeant) {
  const Procedure procedure = *loadProcedure("internal_jugular");
  EXPECT_THAT(VesselLocator(twoSides(), procedure, {0, 0, 0}).names(),
              ElementsAre("right internal jugular vein", "left internal jugular vein"));
  EXPECT_THAT(VesselLocator(twoSides(), procedure, {50, 0, 0}).names(),
              ElementsAre("left internal jugular vein", "right internal jugular vein"));
}

TEST(VesselLocator, ATargetOfTheProcedureComesBeforeANearerOne) {
  CaseManifest manifest = twoSides();
  manifest.targets.push_back({"external jugular vein", kVein, {6, 2, 0}});
  EXPECT_EQ(VesselLocator(manifest, *loadProcedure("internal_jugular"), {6, 0, 0}).names().front(),
            "right internal jugular vein");
}

TEST(VesselLocator, VeinsAreToldApartByTheirLines) {
  const VesselLocator target(twoSides(), *loadProcedure("internal_jugular"), {0, 0, 0});
  EXPECT_EQ(target.vesselAt(kVein, {-4, 12, 30}, kLines), 1);
  EXPECT_EQ(target.vesselAt(kVein, {36, 8, -30}, kLines), 2);
  EXPECT_EQ(target.vesselAt(kVein, {6, 3, 0}, kLines), kUnnamedVessel) << "the small one in between";
  EXPECT_EQ(target.vesselAt(kVein, {0, 10, 0}, {}), kUnnamedVessel) << "without lines nothing passes";
  EXPECT_THAT(target.distanceToCenterLine_mm({6, 2, 0}, kLines), Optional(testing::DoubleNear(10, 1e-9)));
}

TEST(VesselLocator, ACaseWithoutATargetNamesNone) {
  const VesselLocator target(CaseManifest{}, *loadProcedure("internal_jugular"), {});
  EXPECT_TRUE(target.names().empty());
  EXPECT_EQ(target.vesselAt(kVein, {0, 10, 0}, kLines), 0);
  EXPECT_THAT(target.distanceToCenterLine_mm({6, 2, 0}, kLines), Optional(testing::DoubleNear(0, 1e-9)));
}

CaseManifest named() {
  CaseManifest manifest = twoSides();
  manifest.vessels = {{"right common carotid artery", kArtery, {{{-20, 10, -50}, 3}, {{-20, 10, 50}, 3}}},
                      {"right external jugular vein", kVein, {{{9, 10, -50}, 1}, {{9, 10, 50}, 1}}},
                      {"right internal jugular vein", kVein, {{{0, 10, -50}, 7}, {{0, 10, 50}, 7}}}};
  return manifest;
}

TEST(VesselLocator, NamedVesselsAreToldApartByTheirWalls) {
  const VesselLocator vessels(named(), *loadProcedure("internal_jugular"), {0, 0, 0});
  EXPECT_THAT(vessels.names(),
              ElementsAre("right internal jugular vein", "right common carotid artery", "right external jugular vein"));
  EXPECT_EQ(vessels.vesselAt(kVein, {-6.5, 10, 0}, {}), 1);
  EXPECT_EQ(vessels.vesselAt(kVein, {6.5, 10, 0}, {}), 1)
      << "nearer to the middle of the small vein, yet in the wide one";
  EXPECT_EQ(vessels.vesselAt(kVein, {8.5, 10, 0}, {}), 3);
  EXPECT_EQ(vessels.vesselAt(kArtery, {-16.5, 10, 0}, {}), 2);
  EXPECT_EQ(vessels.vesselAt(kArtery, {0, 10, 0}, {}), kUnnamedVessel) << "far from the only artery with a name";
  EXPECT_THAT(vessels.distanceToCenterLine_mm({3, 10, 0}, {}), Optional(testing::DoubleNear(3, 1e-9)));
}

/// Only some veins have names, as after a guide's first steps.
TEST(VesselLocator, AVeinWithoutANameIsNotTheNearestNamedOne) {
  CaseManifest manifest = named();
  manifest.vessels.erase(manifest.vessels.begin() + 1);
  const VesselLocator vessels(manifest, *loadProcedure("internal_jugular"), {0, 0, 0});
  const std::vector<CenterLine> lines{{{0, 10, -50}, {0, 10, 0}, {0, 10, 50}}, {{9, 10, -50}, {9, 10, 0}, {9, 10, 50}}};
  EXPECT_EQ(vessels.vesselAt(kVein, {9, 10, 0}, lines), kUnnamedVessel);
  EXPECT_FALSE(vessels.isTarget({9, 10, 0}, lines));
  EXPECT_EQ(vessels.vesselAt(kVein, {-11, 10, 0}, lines), 1) << "the lumen of a flat vein reaches beyond the round one";
}

TEST(VesselLocator, AnotherVeinsNameIsNotTheTargets) {
  CaseManifest manifest = named();
  manifest.vessels = {{"left internal jugular vein", kVein, {{{40, 10, -50}, 5}, {{40, 10, 50}, 5}}}};
  const VesselLocator vessels(manifest, *loadProcedure("internal_jugular"), {0, 0, 0});
  EXPECT_EQ(vessels.names().front(), "right internal jugular vein");
  EXPECT_FALSE(vessels.isTarget({40, 10, 0}, kLines));
  EXPECT_TRUE(vessels.isTarget({1, 10, 0}, kLines));
}

}  // namespace
}  // namespace insonate
