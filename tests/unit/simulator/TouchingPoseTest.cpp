#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/TouchingPose.h>

#include <gmock/gmock.h>

#include <cstdio>
#include <string>

namespace insonate {
namespace {

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
  const auto plain = proposePlaces(patient);
  ASSERT_TRUE(plain);
  for (const StartPose& pose : plain->startPoses) print("plain " + pose.name, touchAt(patient, pose).value());
  const auto proposal = proposeTouchingPlaces(patient);
  ASSERT_TRUE(proposal) << proposal.error().message;
  for (const std::string& note : proposal->notes) std::printf("%s\n", note.c_str());
  for (const StartPose& pose : proposal->startPoses) {
    const auto touch = touchAt(patient, pose);
    ASSERT_TRUE(touch) << touch.error().message;
    print(pose.name, *touch);
    EXPECT_TRUE(touch->isLight()) << pose.name;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, TouchingPoses,
                         testing::Values("textbook", "deep-in-fat", "head-turned", "subclavian", "arm", "groin",
                                         "groin-obese"),
                         [](const auto& one) {
                           std::string name = one.param;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace insonate
