#include "support/TestData.h"

#include <insonate/cases/Import.h>
#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/LabelStep.h>
#include <insonate/simulator/TouchingPose.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cstdio>
#include <string>

namespace insonate {
namespace {

using testing::HasSubstr;

PatientCase withoutPlaces(const std::string& variant) {
  auto patient = makePhantom(variant, 3);
  EXPECT_TRUE(patient) << patient.error().message;
  patient->manifest.targets.clear(), patient->manifest.startPoses.clear(), patient->manifest.landmarks.clear();
  return std::move(*patient);
}

void print(const std::string& what, const ProbeTouch& touch) {
  std::printf("%s: %.0f %% touch, %.2f N, vein %.0f %%\n", what.c_str(), 100 * touch.touching, touch.force_N,
              100 * touch.vein);
}

class TouchingPoses : public testing::TestWithParam<std::string> {};

TEST_P(TouchingPoses, TouchWithoutCompressingTheVein) {
  const PatientCase patient = withoutPlaces(GetParam());
  const auto proposal = proposeTouchingPlaces(patient);
  ASSERT_TRUE(proposal) << proposal.error().message;
  EXPECT_THAT(proposal->notes, testing::IsEmpty());
  ASSERT_FALSE(proposal->startPoses.empty());
  for (const StartPose& pose : proposal->startPoses) {
    const auto touch = touchAt(patient, pose);
    ASSERT_TRUE(touch) << touch.error().message;
    print(pose.name, *touch);
    EXPECT_TRUE(touch->isLight()) << pose.name;
    EXPECT_NEAR(norm(pose.lateral), 1, 1e-9);
    EXPECT_NEAR(dot(pose.lateral, pose.axial), 0, 1e-9);
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TouchingPoses, testing::Values("textbook", "arm", "groin", "groin-obese"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::erase(name, '-');
                           return name;
                         });

/// A flat face along the hollow of a neck meets the skin with its ends.
TEST(TouchingPose, APoseThatIgnoresTheSkinCompressesTheVein) {
  const PatientCase patient = withoutPlaces("textbook");
  const auto plain = proposePlaces(patient);
  ASSERT_TRUE(plain);
  const auto along =
      std::ranges::find(plain->startPoses, "right internal jugular vein, longitudinal", &StartPose::name);
  ASSERT_NE(along, plain->startPoses.end());
  const auto touch = touchAt(patient, *along);
  ASSERT_TRUE(touch) << touch.error().message;
  print("without a search", *touch);
  EXPECT_LT(touch->touching, 0.6);
  EXPECT_LT(touch->vein, 0.9);
}

/// Slices of 4.25 mm, in which an author has labeled a vein.
TEST(TouchingPose, PosesOfARealNeckAreLightOrNamed) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  auto imported = importSeries(test::testData("neck-ct-dicom"));
  ASSERT_TRUE(imported) << imported.error().message;
  auto labels = autoLabel(imported->ct, {});
  ASSERT_TRUE(labels) << labels.error().message;
  PatientCase patient{{}, std::move(imported->ct), std::move(*labels)};
  NamedVessel vein{"right internal jugular vein", kVein, {}};
  LabelStep step;
  step.tool = step::Paint{.points_mm = {{-46, -14, -252}, {-46, -14, -212}}, .radius_mm = 5};
  step.label = kVein;
  LabelEdit edit(patient.ct, patient.labels);
  ASSERT_TRUE(perform(step, edit));
  for (int n = 0; n <= 40; ++n) vein.course.push_back({{-46, -14, -252.0 + n}, 5});
  patient.manifest.vessels = {vein};
  const auto proposal = proposeTouchingPlaces(patient);
  ASSERT_TRUE(proposal) << proposal.error().message;
  ASSERT_EQ(proposal->startPoses.size(), 2U);
  for (const StartPose& pose : proposal->startPoses) {
    const auto touch = touchAt(patient, pose);
    ASSERT_TRUE(touch) << touch.error().message;
    print(pose.name, *touch);
    if (!touch->isLight()) {
      EXPECT_THAT(proposal->notes, testing::Contains(HasSubstr(pose.name)));
    }
  }
  for (const std::string& note : proposal->notes) std::printf("%s\n", note.c_str());
}

TEST(TouchingPose, TheSearchCanBeCanceled) {
  const auto proposal = proposeTouchingPlaces(withoutPlaces("textbook"), [](auto, double) { return false; });
  ASSERT_FALSE(proposal);
  EXPECT_EQ(proposal.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
