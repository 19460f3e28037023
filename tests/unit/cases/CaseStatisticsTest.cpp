#include "CaseSamples.h"

#include <insonate/cases/CaseStatistics.h>

#include <gtest/gtest.h>

#include <numeric>

namespace insonate {
namespace {

TEST(CaseStatistics, CountsWhatIsThere) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({10, 10, 10}, {0.5, 2, 4}), -2000);
  patient.labels = LabelMap(patient.ct.geometry);
  for (int i = 0; i < 5; ++i) patient.ct.at(i, 1, 2) = 40, patient.labels.at(i, 1, 2) = kVein;
  patient.ct.at(9, 9, 9) = 4000, patient.labels.at(9, 9, 9) = 200;
  const auto s = caseStatistics(patient);
  ASSERT_TRUE(s) << s.error().message;
  EXPECT_EQ(s->min_HU, -2000);
  EXPECT_EQ(s->max_HU, 4000);
  EXPECT_DOUBLE_EQ(s->volume_ml(kVein), 0.02);
  EXPECT_EQ(s->voxels[200], 1U);
  EXPECT_EQ(s->voxels[kBackground], 994U);
  EXPECT_EQ(s->histogram.front(), 994U) << "the ends take the rest";
  EXPECT_EQ(s->histogram.back(), 1U);
  EXPECT_EQ(s->histogram[40 + 1024], 5U);
  EXPECT_EQ(std::accumulate(s->histogram.begin(), s->histogram.end(), std::uint64_t{0}), 1000U);
}

TEST(CaseStatistics, StopsWhenAskedAndRefusesWhatDoesNotFit) {
  PatientCase patient = test::noiseCase(test::grid({4, 4, 4}));
  const auto cancelled = caseStatistics(patient, [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
  patient.labels.voxels.pop_back();
  EXPECT_FALSE(caseStatistics(patient));
  EXPECT_FALSE(caseStatistics(PatientCase{}));
}

}  // namespace
}  // namespace insonate
