#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/Difficulty.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/PlaceProposal.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace insonate {
namespace {

using testing::HasSubstr;

PatientCase made(std::string_view variant) {
  auto patient = makePhantom(variant, 3);
  EXPECT_TRUE(patient) << patient.error().message;
  return std::move(*patient);
}

PatientCase withoutPlaces(PatientCase patient) {
  patient.manifest.targets.clear(), patient.manifest.startPoses.clear(), patient.manifest.landmarks.clear();
  return patient;
}

double costOf(const PatientCase& patient, const Target& target) {
  const auto measured = measureVein(patient, target);
  EXPECT_TRUE(measured) << measured.error().message;
  return measured ? measured->depth_mm + measured->overlap_percent.value_or(0) / 10 : 1e9;
}

class PlacesOfBuiltInCase : public testing::TestWithParam<std::string> {};

TEST_P(PlacesOfBuiltInCase, AreFitForTraining) {
  const PatientCase original = made(GetParam());
  PatientCase patient = withoutPlaces(original);
  auto proposal = proposePlaces(patient);
  ASSERT_TRUE(proposal) << proposal.error().message;
  EXPECT_THAT(proposal->notes, testing::IsEmpty());
  ASSERT_FALSE(proposal->targets.empty());
  EXPECT_EQ(proposal->startPoses.size(), 2 * proposal->targets.size());
  EXPECT_EQ(proposal->landmarks.size(), 1U);
  addPlaces(std::move(*proposal), patient.manifest);
  const auto findings = checkCase(patient);
  ASSERT_TRUE(findings);
  // The mechanics decide if the probe compresses the vein: simulator/TouchingPose.h.
  for (const Finding& finding : *findings)
    EXPECT_FALSE(finding.severity == FindingSeverity::kError ||
                 (finding.code.starts_with("pose_") && finding.code != "pose_compresses") ||
                 finding.code.starts_with("target_"))
        << finding.code << ": " << finding.text;
  // In the scans of the chest the internal jugular vein is easier than the vein that the case is made for.
  const Target& chosen = original.manifest.targets.front();
  if (phantomVariant(GetParam())->region == PhantomRegion::kChest) return;
  EXPECT_EQ(patient.manifest.targets.front().name, chosen.name);
  PatientCase measured = original;
  measured.manifest.startPoses.clear();
  EXPECT_LT(costOf(measured, patient.manifest.targets.front()), costOf(measured, chosen) + 4)
      << "not much harder than the place that the author of the case chose";
}

INSTANTIATE_TEST_SUITE_P(Each, PlacesOfBuiltInCase,
                         testing::Values("textbook", "deep-in-fat", "vein-over-artery", "small-vein", "head-turned",
                                         "low-bifurcation", "subclavian", "axillary", "arm", "groin", "groin-obese"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST(PlaceProposal, BothSidesOfANeckTheRightSideFirst) {
  const PatientCase patient = withoutPlaces(made("textbook"));
  const auto proposal = proposePlaces(patient);
  ASSERT_TRUE(proposal);
  ASSERT_EQ(proposal->targets.size(), 2U);
  EXPECT_THAT(proposal->targets[0].name, HasSubstr("right"));
  EXPECT_LT(proposal->targets[0].position_mm.x, 0);
  EXPECT_THAT(proposal->targets[1].name, HasSubstr("left"));
  EXPECT_GT(proposal->targets[1].position_mm.x, 0);
  ASSERT_EQ(proposal->startPoses.size(), 4U);
  EXPECT_EQ(proposal->startPoses[0].name, proposal->targets[0].name + ", transverse");
  EXPECT_GT(proposal->startPoses[0].lateral.x, 0.7) << "the patient's right is on the left of the image";
  EXPECT_EQ(proposal->startPoses[1].name, proposal->targets[0].name + ", longitudinal");
  EXPECT_LT(proposal->startPoses[1].lateral.z, -0.7) << "the head is on the left of the image";
}

TEST(PlaceProposal, ALongVesselAcrossTheBodyIsSeenInTwoPlanes) {
  const PatientCase patient = withoutPlaces(made("axillary"));
  const auto proposal = proposePlaces(patient);
  ASSERT_TRUE(proposal);
  ASSERT_GE(proposal->startPoses.size(), 2U);
  const StartPose &across = proposal->startPoses[0], &along = proposal->startPoses[1];
  EXPECT_LT(std::abs(dot(across.lateral, along.lateral)), 0.5);
  for (const StartPose& pose : {across, along}) {
    EXPECT_NEAR(norm(pose.lateral), 1, 1e-9);
    EXPECT_NEAR(dot(pose.lateral, pose.axial), 0, 1e-9);
  }
}

TEST(PlaceProposal, WhatTheAuthorPlacedStays) {
  const PatientCase patient = made("textbook");
  const auto nothing = proposePlaces(patient);
  ASSERT_TRUE(nothing);
  EXPECT_TRUE(nothing->targets.empty()) << nothing->targets.front().name;
  PatientCase without = patient;
  without.manifest.startPoses.clear();
  const auto poses = proposePlaces(without);
  ASSERT_TRUE(poses);
  EXPECT_TRUE(poses->targets.empty());
  EXPECT_EQ(poses->startPoses.size(), 2 * patient.manifest.targets.size());
}

TEST(PlaceProposal, AVesselThatIsNotLabeledIsReported) {
  PatientCase patient = withoutPlaces(made("textbook"));
  std::ranges::replace(patient.labels.voxels, std::uint8_t(kVein), std::uint8_t(kMuscle));
  const auto proposal = proposePlaces(patient);
  ASSERT_TRUE(proposal);
  EXPECT_TRUE(proposal->targets.empty() && proposal->startPoses.empty() && proposal->landmarks.empty());
  ASSERT_EQ(proposal->notes.size(), 2U);
  EXPECT_THAT(proposal->notes[0], HasSubstr("No target was found in the right internal jugular vein"));
}

TEST(PlaceProposal, AVeinThatTheAuthorDefinedCounts) {
  PatientCase patient = withoutPlaces(made("textbook"));
  patient.manifest.ownLabels[20] = {"my vein", kVein};
  std::ranges::replace(patient.labels.voxels, std::uint8_t(kVein), std::uint8_t(20));
  const auto proposal = proposePlaces(patient);
  ASSERT_TRUE(proposal);
  EXPECT_EQ(proposal->targets.size(), 2U);
}

TEST(PlaceProposal, CanBeCanceled) {
  const auto proposal = proposePlaces(withoutPlaces(made("textbook")), [](auto, double) { return false; });
  ASSERT_FALSE(proposal);
  EXPECT_EQ(proposal.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
