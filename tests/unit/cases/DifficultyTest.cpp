#include <insonate/cases/Difficulty.h>
#include <insonate/cases/Phantom.h>
#include <insonate/tissue/Labels.h>

#include <gmock/gmock.h>
#include <support/AttemptBlock.h>

#include <map>
#include <string>

namespace insonate {
namespace {

using testing::HasSubstr;

/// A block of muscle below a flat skin at y = 0, with round vessels along z. Centres and radii in mm.
PatientCase vesselsInABlock(Vec3 vein_mm, double halfWidth_mm, double halfHeight_mm, Vec3 artery_mm, double radius_mm) {
  VolumeGeometry grid;
  grid.size = {161, 121, 61};
  grid.spacing_mm = {0.5, 0.5, 1};
  grid.origin_mm = {-40, -10, -30};
  PatientCase patient{{}, CtVolume(grid, 40), LabelMap(grid)};
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double x = grid.origin_mm.x + 0.5 * i, y = grid.origin_mm.y + 0.5 * j;
        if (y < 0) continue;
        std::uint8_t& label = patient.labels.at(i, j, k);
        label = y < 1.5 ? kSkin : kMuscle;
        if (std::hypot(x - artery_mm.x, y - artery_mm.y) <= radius_mm) label = kArtery;
        if (std::hypot((x - vein_mm.x) / halfWidth_mm, (y - vein_mm.y) / halfHeight_mm) <= 1) label = kVein;
      }
  patient.manifest.targets = {{"vein", kVein, vein_mm}};
  patient.manifest.startPoses = {{"over it", {vein_mm.x, 0, 0}, {0, 1, 0}, {1, 0, 0}}};
  return patient;
}

TEST(VeinMeasures, OfABlockAreThoseItWasMadeWith) {
  const PatientCase block = test::attemptBlock();
  const auto m = measureVein(block, block.manifest.targets[0]);
  ASSERT_TRUE(m) << m.error().message;
  EXPECT_NEAR(m->depth_mm, 12, 0.5);
  EXPECT_NEAR(m->area_mm2, 13 * 12, 8);
  // An ellipse with the second moments of a rectangle is longer by 4 / sqrt(12).
  EXPECT_NEAR(m->width_mm, 13 * 1.1547, 0.4);
  EXPECT_NEAR(m->height_mm, 12 * 1.1547, 0.4);
  EXPECT_NEAR(m->artery_mm.value(), 4, 0.5);
  EXPECT_EQ(m->overlap_percent.value(), 0);
  EXPECT_NEAR(m->angle_deg.value(), std::atan2(18, 9) * 180 / M_PI, 2);
  EXPECT_NEAR(m->lung_mm.value(), 16, 0.5);
  EXPECT_FALSE(m->second_mm);
}

TEST(VeinMeasures, EllipseAndArteryBehindItAreMet) {
  // Vein 14 x 8 mm with its middle 16 mm deep; artery 6 mm wide, its middle at the vein's right edge: half is behind
  // it.
  const PatientCase patient = vesselsInABlock({0, 16, 0}, 7, 4, {7, 25, 0}, 3);
  const auto m = measureVein(patient, patient.manifest.targets[0]);
  ASSERT_TRUE(m) << m.error().message;
  EXPECT_NEAR(m->depth_mm, 12, 0.6);
  EXPECT_NEAR(m->width_mm, 14, 0.5);
  EXPECT_NEAR(m->height_mm, 8, 0.5);
  EXPECT_NEAR(m->area_mm2, M_PI * 7 * 4, 4);
  EXPECT_NEAR(m->overlap_percent.value(), 50, 8);
  EXPECT_NEAR(m->angle_deg.value(), std::atan2(7, 9) * 180 / M_PI, 2);
}

/// A label that leaked into the depth, as from a few clicks in a CT with thick slices: 22 mm along the beam, 14 mm
/// long.
TEST(VeinMeasures, AThickShortLabelIsMeasuredAlongTheBeam) {
  PatientCase patient = vesselsInABlock({0, 30, 0}, 5, 11, {20, 30, 0}, 3);
  VolumeGeometry& grid = patient.labels.geometry;
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 0; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i)
        if (const double z = grid.origin_mm.z + k, y = grid.origin_mm.y + 0.5 * j;
            patient.labels.at(i, j, k) == kVein && std::abs(z - (y - 30)) > 7)
          patient.labels.at(i, j, k) = kMuscle;
  const auto m = measureVein(patient, patient.manifest.targets[0]);
  ASSERT_TRUE(m) << m.error().message;
  EXPECT_NEAR(m->depth_mm, 23, 4.5) << "not along the body, to its end";
}

TEST(VeinMeasures, DoNotDependOnWhereTheProbeStandsAlongTheVein) {
  PatientCase patient = vesselsInABlock({0, 16, 0}, 7, 4, {7, 25, 0}, 3);
  // Looked at from 30 degrees above, across the same vein.
  patient.manifest.startPoses = {
      {"from above", Vec3{0, 16, 0} - 18.475 * Vec3{0, 0.866, -0.5}, {0, 0.866, -0.5}, {1, 0, 0}}};
  const auto m = measureVein(patient, patient.manifest.targets[0]);
  ASSERT_TRUE(m) << m.error().message;
  EXPECT_NEAR(m->height_mm, 8, 0.5) << "square to the vein, not to the beam";
  EXPECT_NEAR(m->depth_mm, 12, 0.6);
}

/// A mass that fills the surroundings of the target has no direction: it is measured in the image, not in any section.
TEST(VeinMeasures, AWideMassIsMeasuredInTheImage) {
  const PatientCase patient = vesselsInABlock({0, 20, 0}, 18, 10, {30, 40, 0}, 3);
  const auto m = measureVein(patient, patient.manifest.targets[0]);
  ASSERT_TRUE(m) << m.error().message;
  EXPECT_NEAR(m->depth_mm, 10, 0.6);
  EXPECT_NEAR(m->width_mm, 36, 0.6);
  EXPECT_NEAR(m->height_mm, 20, 0.6);
  EXPECT_NEAR(m->area_mm2, M_PI * 18 * 10, 8);
}

/// Figures of tests/unit/cases/vein_measures.py, a reader of the files of a case that shares nothing with the program.
struct IndependentMeasures {
  const char* variant;
  double depth_mm, area_mm2, width_mm, height_mm, artery_mm, overlap_percent;
};

class VeinMeasuresOf : public testing::TestWithParam<IndependentMeasures> {};

TEST_P(VeinMeasuresOf, ABuiltInCaseAreThoseOfAnIndependentReader) {
  const IndependentMeasures& known = GetParam();
  const auto patient = makePhantom(known.variant, 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const auto m = measureVein(*patient, patient->manifest.targets.front());
  ASSERT_TRUE(m) << m.error().message;
  // The program samples a wall every 0.25 mm, the reader every 0.1 mm: a length differs by one step of each. The
  // perimeter of a vein of 15 mm2 (arm) is 14 mm: a shift of the wall by 0.03 mm, about a tenth of a step on average,
  // changes its area by 3 %.
  constexpr double kWall_mm = 0.35, kArea = 0.03, kOverlap_percent = 5;
  EXPECT_NEAR(m->depth_mm, known.depth_mm, kWall_mm);
  EXPECT_NEAR(m->area_mm2, known.area_mm2, kArea * known.area_mm2);
  EXPECT_NEAR(m->width_mm, known.width_mm, kWall_mm);
  EXPECT_NEAR(m->height_mm, known.height_mm, kWall_mm);
  EXPECT_NEAR(m->artery_mm.value(), known.artery_mm, kWall_mm);
  EXPECT_NEAR(m->overlap_percent.value(), known.overlap_percent, kOverlap_percent);
}

INSTANTIATE_TEST_SUITE_P(Independent, VeinMeasuresOf,
                         testing::Values(IndependentMeasures{"textbook", 12.1, 108.6, 13.5, 10.4, 6.8, 0},
                                         IndependentMeasures{"vein-over-artery", 15.1, 97.9, 13.2, 9.6, 2.2, 54},
                                         IndependentMeasures{"arm", 7.0, 14.5, 4.7, 4.0, 10.5, 0},
                                         IndependentMeasures{"groin", 13.6, 104.3, 13.2, 10.3, 2.8, 0}),
                         [](const auto& known) {
                           std::string name(known.param.variant);
                           std::erase(name, '-');
                           return name;
                         });

TEST(Difficulty, BuiltInNecksRankAsTheyAreGraded) {
  std::map<std::string_view, std::vector<double>> points;
  for (const PhantomVariant& variant : phantomVariants()) {
    const auto patient = makePhantom(variant.name, 1);
    ASSERT_TRUE(patient);
    const auto estimate = estimateDifficulty(*patient);
    ASSERT_TRUE(estimate) << variant.name << ": " << estimate.error().message;
    EXPECT_EQ(estimate->grade, variant.difficulty) << variant.name << ": " << estimate->sentence;
    points[variant.difficulty].push_back(estimate->points);
  }
  EXPECT_LT(std::ranges::max(points["easy"]), std::ranges::min(points["moderate"]));
  EXPECT_LT(std::ranges::max(points["moderate"]), std::ranges::min(points["hard"]));
}

TEST(Difficulty, GrowsWithEachThingThatMakesItHard) {
  const auto pointsOf = [](const PatientCase& patient) { return estimateDifficulty(patient).value().points; };
  const Vec3 aside{20, 16, 0};
  const double easy = pointsOf(vesselsInABlock({0, 14, 0}, 7, 5.5, aside, 3));
  EXPECT_LT(easy, 0.25);
  EXPECT_GT(pointsOf(vesselsInABlock({0, 24, 0}, 7, 5.5, aside, 3)), easy + 0.5) << "deeper";
  EXPECT_GT(pointsOf(vesselsInABlock({0, 14, 0}, 3, 3, aside, 3)), easy + 0.5) << "smaller";
  EXPECT_GT(pointsOf(vesselsInABlock({0, 12, 0}, 8, 1.8, aside, 3)), easy + 0.5) << "flat";
  EXPECT_GT(pointsOf(vesselsInABlock({0, 14, 0}, 7, 5.5, {0, 24, 0}, 3)), easy + 0.5) << "artery straight behind";
}

TEST(Difficulty, SentenceGivesGradeAndReasons) {
  const auto hard = estimateDifficulty(vesselsInABlock({0, 26, 0}, 7, 2, {20, 16, 0}, 3));
  ASSERT_TRUE(hard);
  EXPECT_EQ(hard->grade, "hard");
  EXPECT_THAT(hard->sentence, HasSubstr("Hard: "));
  EXPECT_THAT(hard->sentence, HasSubstr("mm below the skin"));
  EXPECT_THAT(hard->sentence, HasSubstr("mm high"));
}

TEST(Difficulty, AuthorsGradeCountsBeforeTheEstimate) {
  PatientCase patient = vesselsInABlock({0, 14, 0}, 7, 5.5, {20, 16, 0}, 3);
  EXPECT_EQ(gradeOf(patient), "easy");
  patient.manifest.difficulty = "hard";
  EXPECT_EQ(gradeOf(patient), "hard");
}

TEST(Difficulty, WithoutATargetInItsVeinThereIsNoneAndWhy) {
  PatientCase patient = vesselsInABlock({0, 14, 0}, 7, 5.5, {20, 16, 0}, 3);
  patient.manifest.targets[0].position_mm = {0, 40, 0};
  auto none = estimateDifficulty(patient);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("is not in vein"));
  patient.manifest.targets.clear();
  none = estimateDifficulty(patient);
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("no target"));
}

}  // namespace
}  // namespace insonate
