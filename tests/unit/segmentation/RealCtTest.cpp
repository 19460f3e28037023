#include "support/TestData.h"

#include <insonate/cases/Import.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/tissue/Labels.h>

#include <array>

namespace insonate {
namespace {

/// Litres of each label, and what lies outside the patient where it should not.
struct Tally {
  std::array<double, kLabelCount> litres{};
  int bare = 0;          ///< faces between background and tissue that is neither skin nor air
  int airAtTheSide = 0;  ///< air of the body at the sides of the scan
};

Tally tally(const LabelMap& labels) {
  Tally t;
  const auto& [ni, nj, nk] = labels.geometry.size;
  const auto& s = labels.geometry.spacing_mm;
  const auto bare = [](std::uint8_t a, std::uint8_t b) {
    return a == kBackground && b != kBackground && b != kSkin && b != kAirway;
  };
  for (int k = 0; k < nk; ++k)
    for (int j = 0; j < nj; ++j)
      for (int i = 0; i < ni; ++i) {
        const std::uint8_t label = labels.at(i, j, k);
        t.litres.at(label) += s.x * s.y * s.z * 1e-6;
        const bool side = i == 0 || j == 0 || i + 1 == ni || j + 1 == nj;
        t.airAtTheSide += side && label == kAirway;
        for (const auto& [x, y, z] : {std::array{i + 1, j, k}, std::array{i, j + 1, k}, std::array{i, j, k + 1}})
          if (labels.geometry.contains(x, y, z))
            t.bare += bare(label, labels.at(x, y, z)) || bare(labels.at(x, y, z), label);
      }
  return t;
}

TEST(AutoLabelOnRealCt, HeadNeckAndChestOfAWoman) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  const auto imported = importSeries(test::testData("neck-ct-dicom"));
  ASSERT_TRUE(imported) << imported.error().message;
  const auto labels = autoLabel(imported->ct, {});
  ASSERT_TRUE(labels) << labels.error().message;

  const Tally t = tally(*labels);
  EXPECT_EQ(t.bare, 0) << "the skin is a closed shell";
  EXPECT_EQ(t.airAtTheSide, 0);
  const double body = 0.977 * 0.977 * 4.25e-6 * double(labels->voxels.size()) - t.litres[kBackground];
  EXPECT_NEAR(body, 20.5, 1.5) << "litres of head, neck, arms and upper chest";
  EXPECT_GT(t.litres[kAirway], 0.8) << "the lungs are cut by the last slice";
  EXPECT_LT(t.litres[kAirway], 2.0);
  EXPECT_GT(t.litres[kBone] / body, 0.06);
  EXPECT_LT(t.litres[kBone] / body, 0.15);
  EXPECT_GT(t.litres[kFat] / body, 0.2);
  EXPECT_GT(t.litres[kMuscle] / body, 0.3);

  const auto at = [&](Vec3 patient_mm) {
    return sampleNearest(*labels, labels->geometry.indexFromPatient() * patient_mm, 255);
  };
  // Places read off the slices.
  EXPECT_EQ(at({-60.5, 26.4, -290}), kAirway) << "right lung";
  EXPECT_EQ(at({-15.6, -19.5, -256}), kAirway) << "trachea at the thoracic inlet";
  EXPECT_EQ(at({-14.6, -19.5, -230.5}), kAirway) << "larynx";
  EXPECT_EQ(at({0, -93.8, -77.5}), kMuscle) << "brain is soft tissue without bone";
  EXPECT_EQ(at({101.6, -103.5, -120}), kBackground) << "between head and raised arm";
  EXPECT_EQ(at({-5.9, 169.9, -196.5}), kBackground) << "couch";
}

}  // namespace
}  // namespace insonate
