#include <insonate/cases/CtSynthesis.h>
#include <insonate/cases/Phantom.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/CenterLine.h>
#include <insonate/segmentation/Score.h>
#include <insonate/segmentation/VesselTracking.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

class PhantomScores : public testing::TestWithParam<CtContrast> {};

TEST_P(PhantomScores, BoneAirwayAndSkinAreFoundByThemselves) {
  const auto patient = makePhantom("textbook", 1, {}, GetParam());
  ASSERT_TRUE(patient) << patient.error().message;
  const auto labels = autoLabel(patient->ct, {});
  ASSERT_TRUE(labels) << labels.error().message;
  const auto scores = scoreLabels(*labels, patient->labels, {kBone, kAirway, kSkin});
  ASSERT_TRUE(scores) << scores.error().message;
  for (const LabelScore& score : *scores) EXPECT_GT(score.dice, 0.95) << labelName(score.label);
}

INSTANTIATE_TEST_SUITE_P(Contrast, PhantomScores, testing::Values(CtContrast::kNative, CtContrast::kArterial));

TEST(PhantomScores, StrongNoiseHidesNeitherSkinNorBone) {
  const auto patient = makePhantom("textbook", 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto ct = synthesizeCt(patient->labels, {.seed = 1, .noise_HU = 40});
  ASSERT_TRUE(ct) << ct.error().message;
  const auto labels = autoLabel(*ct, {});
  ASSERT_TRUE(labels) << labels.error().message;
  const auto scores = scoreLabels(*labels, patient->labels, {kBone, kAirway, kSkin});
  ASSERT_TRUE(scores) << scores.error().message;
  for (const LabelScore& score : *scores) EXPECT_GT(score.dice, 0.95) << labelName(score.label);
}

TEST(PhantomScores, ALongVesselWithContrastTakesFourClicks) {
  const auto patient = makePhantom("textbook", 1, {}, CtContrast::kArterial);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto lines = centerLines(patient->labels, kVein);
  ASSERT_TRUE(lines);
  const auto& line = *std::ranges::max_element(*lines, {}, [](const CenterLine& l) { return l.size(); });
  std::vector<Vec3> clicks_mm;
  for (std::size_t n = 0; n < 4; ++n) clicks_mm.push_back(line[(line.size() - 1) * n / 3]);
  const auto vessel = trackVessel(patient->ct, clicks_mm);
  ASSERT_TRUE(vessel) << vessel.error().message;
  // In the box of the lumen lies one vein; of the truth, what lies between the first and the last click.
  const auto [low_mm, high_mm] = std::minmax(clicks_mm.front().z, clicks_mm.back().z);
  std::size_t found = 0, truth = 0, both = 0;
  const VoxelBox& box = vessel->lumen.box;
  const Transform patientFromIndex = patient->ct.geometry.patientFromIndex();
  for (int k = box.first[2]; k < box.end[2]; ++k)
    for (int j = box.first[1]; j < box.end[1]; ++j)
      for (int i = box.first[0]; i < box.end[0]; ++i) {
        const Vec3 p = patientFromIndex * Vec3{double(i), double(j), double(k)};
        if (p.z < low_mm || p.z > high_mm) continue;
        const bool isFound = vessel->lumen.isSelected(i, j, k), isVein = patient->labels.at(i, j, k) == kVein;
        found += isFound, truth += isVein, both += isFound && isVein;
      }
  EXPECT_GT(2.0 * double(both) / double(found + truth), 0.9);
}

}  // namespace
}  // namespace insonate
