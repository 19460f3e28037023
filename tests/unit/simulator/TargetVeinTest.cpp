#include <insonate/procedure/AttemptEvent.h>
#include <insonate/simulator/TargetVein.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::ElementsAre;
using testing::Optional;

const std::vector<CentreLine> kLines{
    {{0, 10, -50}, {0, 10, 50}}, {{40, 10, -50}, {40, 10, 50}}, {{6, 2, -50}, {6, 2, 50}}};

CaseManifest twoSides() {
  CaseManifest manifest;
  manifest.targets = {{"carotid", kArtery, {5, 10, 0}},
                      {"right internal jugular vein", kVein, {1, 10, 0}},
                      {"left internal jugular vein", kVein, {39, 10, 0}}};
  return manifest;
}

TEST(TargetVein, TheNearestTargetIsMeant) {
  const Procedure procedure = *loadProcedure("internal_jugular");
  EXPECT_THAT(TargetVein(twoSides(), procedure, {0, 0, 0}).names(),
              ElementsAre("right internal jugular vein", "left internal jugular vein"));
  EXPECT_THAT(TargetVein(twoSides(), procedure, {50, 0, 0}).names(),
              ElementsAre("left internal jugular vein", "right internal jugular vein"));
}

TEST(TargetVein, ATargetOfTheProcedureComesBeforeANearerOne) {
  CaseManifest manifest = twoSides();
  manifest.targets.push_back({"external jugular vein", kVein, {6, 2, 0}});
  EXPECT_EQ(TargetVein(manifest, *loadProcedure("internal_jugular"), {6, 0, 0}).names().front(),
            "right internal jugular vein");
}

TEST(TargetVein, VeinsAreToldApartByTheirLines) {
  const TargetVein target(twoSides(), *loadProcedure("internal_jugular"), {0, 0, 0});
  EXPECT_EQ(target.vesselAt({-4, 12, 30}, kLines), 1);
  EXPECT_EQ(target.vesselAt({36, 8, -30}, kLines), 2);
  EXPECT_EQ(target.vesselAt({6, 3, 0}, kLines), kUnnamedVessel) << "the small one in between";
  EXPECT_EQ(target.vesselAt({0, 10, 0}, {}), kUnnamedVessel) << "without lines nothing passes";
  EXPECT_THAT(target.distanceToCentre_mm({6, 2, 0}, kLines), Optional(testing::DoubleNear(10, 1e-9)));
}

TEST(TargetVein, ACaseWithoutATargetNamesNone) {
  const TargetVein target(CaseManifest{}, *loadProcedure("internal_jugular"), {});
  EXPECT_TRUE(target.names().empty());
  EXPECT_EQ(target.vesselAt({0, 10, 0}, kLines), 0);
  EXPECT_THAT(target.distanceToCentre_mm({6, 2, 0}, kLines), Optional(testing::DoubleNear(0, 1e-9)));
}

}  // namespace
}  // namespace insonate
