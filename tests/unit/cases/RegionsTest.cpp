#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/Phantom.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace insonate {
namespace {

/// A case is made once for all tests of this program.
const PatientCase& regionNamed(const std::string& variant) {
  static std::map<std::string, PatientCase> made;
  const auto found = made.find(variant);
  if (found != made.end()) return found->second;
  auto patient = makePhantom(variant, 1);
  EXPECT_TRUE(patient) << patient.error().message;
  return made[variant] = std::move(*patient);
}

std::uint8_t labelIn(const PatientCase& p, Vec3 patient_mm) {
  return sampleNearest(p.labels, p.labels.geometry.indexFromPatient() * patient_mm);
}

const NamedVessel& vesselOf(const PatientCase& p, std::string_view name) {
  const auto found = std::ranges::find(p.manifest.vessels, name, &NamedVessel::name);
  EXPECT_NE(found, p.manifest.vessels.end()) << name;
  return *found;
}

Vec3 atLevel(const NamedVessel& vessel, double z_mm) {
  return std::ranges::min(vessel.course, {}, [&](const auto& p) { return std::abs(p.position_mm.z - z_mm); })
      .position_mm;
}

/// Diameter of a circle with the area of a vessel's cross-section in an axial slice.
double diameter_mm(const PatientCase& p, Vec3 inside_mm) {
  const std::uint8_t label = labelIn(p, inside_mm);
  double area_mm2 = 0;
  for (double x = -12; x <= 12; x += 0.25)
    for (double y = -12; y <= 12; y += 0.25)
      if (labelIn(p, inside_mm + Vec3{x, y, 0}) == label) area_mm2 += 0.0625;
  return 2 * std::sqrt(area_mm2 / M_PI);
}

/// Distance along the beam of the first start pose from the skin to the label, over a point.
double depthOf_mm(const PatientCase& p, Vec3 inside_mm) {
  const Vec3 axial = p.manifest.startPoses.front().axial;
  const std::uint8_t label = labelIn(p, inside_mm);
  double wall = 0;
  while (labelIn(p, inside_mm - axial * wall) == label) wall += 0.1;
  double skin = wall;
  while (labelIn(p, inside_mm - axial * skin) != kBackground && skin < 80) skin += 0.1;
  return skin - wall;
}

class RegionVariant : public testing::TestWithParam<std::string> {};

TEST_P(RegionVariant, IsFitForTraining) {
  const PatientCase& p = regionNamed(GetParam());
  const auto findings = checkCase(p);
  ASSERT_TRUE(findings) << findings.error().message;
  for (const Finding& finding : *findings)
    EXPECT_NE(finding.severity, FindingSeverity::kError) << finding.code << ": " << finding.text;
  EXPECT_EQ(p.manifest.difficulty, phantomVariant(GetParam())->difficulty);
  EXPECT_EQ(estimateDifficulty(p)->grade, p.manifest.difficulty);
}

TEST_P(RegionVariant, StartsOnTheSkinBesideTheVein) {
  const PatientCase& p = regionNamed(GetParam());
  ASSERT_EQ(p.manifest.targets.size(), 1U);
  const Vec3 target_mm = p.manifest.targets.front().position_mm;
  EXPECT_EQ(labelIn(p, target_mm), kVein);
  EXPECT_GE(p.manifest.startPoses.size(), 3U);
  for (const StartPose& pose : p.manifest.startPoses) {
    SCOPED_TRACE(pose.name);
    EXPECT_NEAR(norm(pose.axial), 1, 1e-9);
    EXPECT_NEAR(dot(pose.axial, pose.lateral), 0, 1e-9);
    EXPECT_EQ(labelIn(p, pose.position_mm + pose.axial * 0.75), kSkin);
    EXPECT_EQ(labelIn(p, pose.position_mm - pose.axial * 0.75), kBackground);
    const Vec3 toVein = target_mm - pose.position_mm;
    EXPECT_GT(norm(toVein - pose.axial * dot(toVein, pose.axial)), 3) << "the vein has to be found";
  }
}

/// The points of each named vessel lie in its label, and neighbors along a course are near each other.
TEST_P(RegionVariant, VesselsAreWhereTheirNamesAre) {
  const PatientCase& p = regionNamed(GetParam());
  const Vec3 target_mm = p.manifest.targets.front().position_mm;
  std::set<std::string> names;
  for (const NamedVessel& vessel : p.manifest.vessels) {
    EXPECT_TRUE(names.insert(vessel.name).second) << vessel.name;
    int here = 0, labeled = 0;
    for (const NamedVessel::Point& point : vessel.course) {
      const Vec3 index = p.labels.geometry.indexFromPatient() * point.position_mm;
      if (!p.labels.geometry.contains(int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))))
        continue;
      ++here;
      labeled += labelIn(p, point.position_mm) == vessel.label;
    }
    EXPECT_GE(labeled, 0.8 * here) << vessel.name;
    EXPECT_GT(here, 2) << vessel.name;
  }
  const std::string& target = p.manifest.targets.front().name;
  EXPECT_LT(distanceToWall_mm(vesselOf(p, target), target_mm), -1) << target;
}

INSTANTIATE_TEST_SUITE_P(All, RegionVariant,
                         testing::Values("arm", "groin", "groin-thrombus", "groin-overlap", "groin-obese"),
                         [](const auto& variant) {
                           std::string name = variant.param;
                           std::erase(name, '-');
                           return name;
                         });

/// Diameters and depths as in Groin.h; from lateral to medial nerve, artery, vein.
TEST(Groin, HasTheVesselsOfAnAdult) {
  const PatientCase& p = regionNamed("groin");
  const Vec3 vein_mm = p.manifest.targets.front().position_mm;
  const Vec3 artery_mm = atLevel(vesselOf(p, "right common femoral artery"), vein_mm.z);
  EXPECT_NEAR(diameter_mm(p, vein_mm), 11, 1.5);
  EXPECT_NEAR(diameter_mm(p, artery_mm), 9, 1);
  EXPECT_NEAR(depthOf_mm(p, vein_mm), 15, 3);
  EXPECT_GT(vein_mm.x, artery_mm.x + 9) << "the vein of the right side is nearer to the left";
  double nerve_mm = 0, count = 0;
  for (double x = -30; x < 30; x += 0.5)
    for (double y = -8; y < 12; y += 0.5)
      if (labelIn(p, artery_mm + Vec3{x, y, 0}) == kNerve) nerve_mm += x, ++count;
  ASSERT_GT(count, 0);
  EXPECT_LT(nerve_mm / count, -7);
  const NamedVessel& saphenous = vesselOf(p, "right great saphenous vein");
  const auto tubercle = std::ranges::find(p.manifest.landmarks, "pubic_tubercle_right", &Landmark::code);
  ASSERT_NE(tubercle, p.manifest.landmarks.end());
  EXPECT_EQ(labelIn(p, tubercle->position_mm), kBone);
  EXPECT_NEAR(tubercle->position_mm.x - saphenous.course.front().position_mm.x, 24, 8);
  EXPECT_NEAR(tubercle->position_mm.z - saphenous.course.front().position_mm.z, 10, 5);
}

TEST(Groin, VariantsDifferInWhatTheyPromise) {
  const auto targetOf = [](const char* variant) { return regionNamed(variant).manifest.targets.front().position_mm; };
  EXPECT_GT(depthOf_mm(regionNamed("groin-obese"), targetOf("groin-obese")), 24);
  const auto covered_percent = [&](const char* variant) {
    return measureVein(regionNamed(variant), regionNamed(variant).manifest.targets.front())->covered_percent.value();
  };
  EXPECT_GT(covered_percent("groin-overlap"), 50);
  EXPECT_EQ(covered_percent("groin"), 0);
}

/// In a case with a thrombus, the vein is open at the target and filled some centimeters below.
TEST(Groin, TheThrombusFillsTheVeinOverCentimeters) {
  const PatientCase& p = regionNamed("groin-thrombus");
  const NamedVessel& open = vesselOf(regionNamed("groin"), "right common femoral vein");
  const NamedVessel& thigh = vesselOf(regionNamed("groin"), "right femoral vein");
  int filled = 0;
  for (const NamedVessel* vessel : {&open, &thigh})
    for (const auto& point : vessel->course) filled += labelIn(p, point.position_mm) == kLabelCount;
  EXPECT_GE(3 * filled, 20) << "points are 3 mm apart";
  EXPECT_EQ(p.manifest.ownLabels.at(kLabelCount).name, "thrombus");
}

TEST(Arm, HasARoundArteryBetweenTwoVeinsAndASmallVeinBesideIt) {
  const PatientCase& p = regionNamed("arm");
  const Vec3 basilic_mm = p.manifest.targets.front().position_mm;
  const Vec3 artery_mm = atLevel(vesselOf(p, "right brachial artery"), basilic_mm.z);
  EXPECT_NEAR(diameter_mm(p, basilic_mm), 4.5, 0.7);
  EXPECT_NEAR(diameter_mm(p, artery_mm), 4.4, 0.6);
  EXPECT_NEAR(depthOf_mm(p, basilic_mm), 8.5, 2.5);
  const Vec3 front = atLevel(vesselOf(p, "right anterior brachial vein"), basilic_mm.z) - artery_mm;
  const Vec3 back = atLevel(vesselOf(p, "right posterior brachial vein"), basilic_mm.z) - artery_mm;
  EXPECT_LT(front.x * back.x, 0) << "one on each side";
  EXPECT_LT(front.y, 0) << "toward the probe, like the ears of a mouse";
  EXPECT_LT(back.y, 0);
  EXPECT_GT(norm(basilic_mm - artery_mm), 10);
}

/// The veins of a right arm may lie left of the arm's own middle.
TEST(Arm, HasNoMidlineOfTheBody) {
  const auto other = makePhantom("arm", 2);
  ASSERT_TRUE(other);
  EXPECT_GT(other->manifest.targets.front().position_mm.x, 0);
  const auto findings = checkCase(*other);
  ASSERT_TRUE(findings);
  EXPECT_THAT(*findings, testing::Not(testing::Contains(testing::Field(&Finding::code, "wrong_side"))));
}

TEST(Axillary, IsNamedLateralOfTheFirstRib) {
  const PatientCase &p = regionNamed("axillary"), &medial = regionNamed("subclavian");
  EXPECT_EQ(p.manifest.targets.front().name, "right axillary vein");
  EXPECT_LT(p.manifest.targets.front().position_mm.x, medial.manifest.targets.front().position_mm.x - 10);
  EXPECT_TRUE(p.labels.voxels == medial.labels.voxels) << "the same body";
  EXPECT_GT(vesselOf(p, "right subclavian vein").course.back().position_mm.x,
            vesselOf(p, "right axillary vein").course.back().position_mm.x);
}

}  // namespace
}  // namespace insonate
