#include "CaseSamples.h"
#include "check/VesselSizes.h"

#include <insonate/cases/CaseCheck.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

std::vector<Finding> findingsOf(const PatientCase& patient) {
  auto findings = checkCase(patient);
  EXPECT_TRUE(findings);
  return *findings;
}

bool has(const std::vector<Finding>& findings, const std::string& code, FindingSeverity severity) {
  return std::ranges::any_of(findings, [&](const Finding& f) { return f.code == code && f.severity == severity; });
}

std::string codes(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& f : findings) text += std::string(nameOf(f.severity)) + " " + f.code + ": " + f.text + "\n";
  return text;
}

void relabel(PatientCase& patient, Label from, Label to) {
  std::ranges::replace(patient.labels.voxels, std::uint8_t{from}, std::uint8_t{to});
}

TEST(CaseCheck, GoodCaseHasNoFindings) {
  const auto findings = findingsOf(test::cylinderNeck());
  EXPECT_TRUE(isFitForTraining(findings));
  EXPECT_EQ(codes(findings), "");
}

TEST(CaseCheck, LabelsOfTheAuthorsOwnAreWhatTheyAreMadeOf) {
  PatientCase patient = test::cylinderNeck();
  for (std::uint8_t& label : patient.labels.voxels)
    if (label == kVein) label = 100;
  EXPECT_TRUE(has(findingsOf(patient), "no_vein", FindingSeverity::kError));
  patient.manifest.ownLabels = {{100, {"right jugular", kVein}}};
  EXPECT_EQ(codes(findingsOf(patient)), "") << "the same case to a trainee";
}

/// One thing wrong with a good case, and what must be found.
struct Defect {
  const char* code;
  FindingSeverity severity;
  std::function<void(PatientCase&)> apply;
};

class CaseDefect : public testing::TestWithParam<Defect> {};

TEST_P(CaseDefect, IsFound) {
  PatientCase patient = test::cylinderNeck();
  GetParam().apply(patient);
  const auto findings = findingsOf(patient);
  EXPECT_TRUE(has(findings, GetParam().code, GetParam().severity)) << codes(findings);
  EXPECT_EQ(isFitForTraining(findings), GetParam().severity != FindingSeverity::kError) << codes(findings);
}

void fillVein(PatientCase& p, int fromK, int toK, std::uint8_t with) {
  for (int k = fromK; k < toK; ++k)
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i)
        if (p.labels.at(i, j, k) == kVein) p.labels.at(i, j, k) = with;
}

/// An ellipse of vein around the target, at the expense of muscle.
void widenVein(PatientCase& p, double halfWidth_mm, double halfHeight_mm) {
  const Vec3 center_mm = p.manifest.targets[0].position_mm + Vec3{5, 5, 0};
  for (int k = 0; k < 61; ++k)
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i) {
        const Vec3 from = p.labels.geometry.patientFromIndex() * Vec3{double(i), double(j), double(k)} - center_mm;
        if (std::hypot(from.x / halfWidth_mm, from.y / halfHeight_mm) < 1 && p.labels.at(i, j, k) == kMuscle)
          p.labels.at(i, j, k) = kVein;
      }
}

void setHu(PatientCase& p, Label label, std::int16_t hu) {
  for (std::size_t v = 0; v < p.ct.voxels.size(); ++v)
    if (p.labels.voxels[v] == label) p.ct.voxels[v] = hu;
}

const Defect kDefects[] = {
    {"vessel_too_large", FindingSeverity::kError, [](PatientCase& p) { widenVein(p, 20, 11); }},
    {"thyroid_large", FindingSeverity::kWarning,
     [](PatientCase& p) {
       const VolumeGeometry& g = p.labels.geometry;
       double missing_mm3 = 50'000;
       for (std::uint8_t& label : p.labels.voxels) {
         if (label != kMuscle || missing_mm3 < 0) continue;
         label = kThyroid;
         missing_mm3 -= g.spacing_mm.x * g.spacing_mm.y * g.spacing_mm.z;
       }
     }},
    {"vessel_large", FindingSeverity::kWarning, [](PatientCase& p) { widenVein(p, 12, 9.5); }},
    {"labels_empty", FindingSeverity::kError, [](PatientCase& p) { p.labels = LabelMap(p.ct.geometry); }},
    {"no_vein", FindingSeverity::kError, [](PatientCase& p) { relabel(p, kVein, kMuscle); }},
    {"no_artery", FindingSeverity::kError, [](PatientCase& p) { relabel(p, kArtery, kMuscle); }},
    {"no_skin", FindingSeverity::kError, [](PatientCase& p) { relabel(p, kSkin, kMuscle); }},
    {"no_bone", FindingSeverity::kWarning, [](PatientCase& p) { relabel(p, kBone, kSoftTissue); }},
    {"unknown_label", FindingSeverity::kError, [](PatientCase& p) { p.labels.at(60, 60, 30) = 77; }},
    {"hu_implausible", FindingSeverity::kError,
     [](PatientCase& p) {
       for (std::size_t v = 0; v < p.ct.voxels.size(); ++v)
         if (p.labels.voxels[v] == kBone) p.ct.voxels[v] = -1000;
     }},
    {"labels_in_air", FindingSeverity::kWarning,
     [](PatientCase& p) {
       for (int k = 0; k < 61; ++k)
         for (int j = 0; j < 5; ++j)
           for (int i = 0; i < 20; ++i) p.labels.at(i, j, k) = kMuscle;
     }},
    {"ct_flat", FindingSeverity::kError, [](PatientCase& p) { std::ranges::fill(p.ct.voxels, std::int16_t{40}); }},
    {"skin_open", FindingSeverity::kWarning,
     [](PatientCase& p) {
       for (int k = 20; k < 40; ++k)
         for (int i = 40; i < 80; ++i)
           for (int j = 0; j < 30; ++j)
             if (p.labels.at(i, j, k) == kSkin) p.labels.at(i, j, k) = kMuscle;
     }},
    {"background_inside", FindingSeverity::kWarning, [](PatientCase& p) { relabel(p, kAirway, kBackground); }},
    {"vein_broken", FindingSeverity::kWarning, [](PatientCase& p) { fillVein(p, 10, 14, kMuscle); }},
    {"vein_fragments", FindingSeverity::kWarning, [](PatientCase& p) { p.labels.at(80, 80, 30) = kVein; }},
    {"vein_thin", FindingSeverity::kWarning,
     [](PatientCase& p) {
       fillVein(p, 0, 61, kMuscle);
       for (int k = 0; k < 61; ++k) p.labels.at(30, 38, k) = kVein;
     }},
    {"no_target", FindingSeverity::kWarning, [](PatientCase& p) { p.manifest.targets.clear(); }},
    {"target_label", FindingSeverity::kError,
     [](PatientCase& p) {
       p.manifest.targets[0].position_mm = {0, 0, 0};
     }},
    {"target_outside", FindingSeverity::kError,
     [](PatientCase& p) {
       p.manifest.targets[0].position_mm = {0, 0, 500};
     }},
    {"no_vessel_names", FindingSeverity::kInfo, [](PatientCase& p) { p.manifest.vessels.clear(); }},
    {"target_without_vessel", FindingSeverity::kInfo,
     [](PatientCase& p) {
       for (auto& point : p.manifest.vessels[0].course) point.position_mm.x += 30;
     }},
    {"vessel_elsewhere", FindingSeverity::kWarning, [](PatientCase& p) { p.manifest.vessels[0].label = kArtery; }},
    {"wrong_side", FindingSeverity::kError,
     [](PatientCase& p) { p.manifest.targets[0].name = "left internal jugular vein"; }},
    {"vein_medial", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.vessels.push_back(
           {"right common carotid artery", kArtery, {{{-40, -22, -20}, 4}, {{-40, -22, 20}, 4}}});
     }},
    {"vessel_direction", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.vessels[0].course = {{{-45, -22, 0}, 6}, {{-20, -22, 2}, 6}};
     }},
    {"lumen_hu", FindingSeverity::kError, [](PatientCase& p) { setHu(p, kVein, -95); }},
    {"lumen_hu", FindingSeverity::kWarning, [](PatientCase& p) { setHu(p, kArtery, 700); }},
    {"click_outside", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.vessels[0].clicks_mm = {{-30, -22, -5}, {-30, -10, 5}};
     }},
    {"no_start_pose", FindingSeverity::kInfo, [](PatientCase& p) { p.manifest.startPoses.clear(); }},
    {"pose_off_skin", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.startPoses[0].position_mm = {0, -10, 0};
     }},
    {"pose_compresses", FindingSeverity::kInfo,
     [](PatientCase& p) {
       StartPose& pose = p.manifest.startPoses[0];
       pose.position_mm = pose.position_mm + 4 * pose.axial;
     }},
    {"pose_outside", FindingSeverity::kError,
     [](PatientCase& p) {
       p.manifest.startPoses[0].position_mm = {0, -90, 0};
     }},
    {"vein_short", FindingSeverity::kWarning,
     [](PatientCase& p) {
       fillVein(p, 0, 27, kMuscle);
       fillVein(p, 34, 61, kMuscle);
     }},
    {"no_wall", FindingSeverity::kWarning,
     [](PatientCase& p) {
       for (int k = 20; k < 40; ++k)
         for (int j = 38; j < 42; ++j)
           for (int i = 36; i < 42; ++i)
             if (p.labels.at(i, j, k) == kMuscle) p.labels.at(i, j, k) = kArtery;
     }},
    {"label_outside", FindingSeverity::kWarning,
     [](PatientCase& p) {
       for (int i = 0; i < 30; ++i) p.labels.at(i, 2, 30) = kMuscle;
     }},
    {"islands", FindingSeverity::kInfo,
     [](PatientCase& p) {
       for (int i = 40; i < 80; i += 2)
         for (int k = 2; k < 60; k += 4) p.labels.at(i, 90, k) = kThyroid;
     }},
    {"landmarks_missing", FindingSeverity::kInfo, [](PatientCase& p) { p.manifest.landmarks.pop_back(); }},
    {"landmark_outside", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.landmarks[1].position_mm = {0, 0, 300};
     }},
    {"landmark_off_skin", FindingSeverity::kWarning,
     [](PatientCase& p) {
       p.manifest.landmarks[0].position_mm = {0, 0, 0};
     }},
    {"difficulty_ungraded", FindingSeverity::kInfo, [](PatientCase& p) { p.manifest.difficulty.clear(); }},
    {"difficulty_differs", FindingSeverity::kInfo, [](PatientCase& p) { p.manifest.difficulty = "hard"; }},
    {"spacing_coarse", FindingSeverity::kWarning,
     [](PatientCase& p) { p.ct.geometry.spacing_mm.z = p.labels.geometry.spacing_mm.z = 4.25; }},
    {"spacing_coarse", FindingSeverity::kError,
     [](PatientCase& p) { p.ct.geometry.spacing_mm.z = p.labels.geometry.spacing_mm.z = 15; }},
};

INSTANTIATE_TEST_SUITE_P(Each, CaseDefect, testing::ValuesIn(kDefects), [](const auto& defect) {
  return std::string(defect.param.code) + "_" + std::string(nameOf(defect.param.severity));
});

TEST(CaseCheck, FindingsSayWhereTheyAre) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.targets = {{"vein", kBone, {1, 2, 3}}};
  patient.labels.at(60, 30, 20) = kBackground;
  patient.labels.at(61, 31, 21) = 99;
  const auto placeOf = [all = findingsOf(patient)](const std::string& code) {
    for (const Finding& finding : all)
      if (finding.code == code) return finding.place_mm.value_or(Vec3{1e9, 0, 0});
    return Vec3{2e9, 0, 0};
  };
  EXPECT_EQ(placeOf("target_label"), (Vec3{1, 2, 3}));
  EXPECT_EQ(placeOf("background_inside"), (Vec3{0, -30, -10}));
  EXPECT_EQ(placeOf("unknown_label"), (Vec3{1, -29, -9}));
}

TEST(CaseCheck, FindingsNameTheirStructure) {
  PatientCase patient = test::cylinderNeck();
  fillVein(patient, 10, 14, kMuscle);
  for (const Finding& finding : findingsOf(patient)) {
    EXPECT_EQ(finding.code, "vein_broken");
    EXPECT_EQ(finding.label, kVein);
  }
}

TEST(CaseCheck, AHeapOfPiecesIsOneFinding) {
  PatientCase patient = test::cylinderNeck();
  for (int k = 4; k + 2 < patient.labels.geometry.size[2]; k += 6) fillVein(patient, k, k + 2, kMuscle);
  const auto findings = findingsOf(patient);
  EXPECT_EQ(std::ranges::count(findings, "vein_broken", &Finding::code), 1) << codes(findings);
  const auto broken = std::ranges::find(findings, "vein_broken", &Finding::code);
  EXPECT_THAT(broken->text, testing::HasSubstr("pieces"));
  EXPECT_TRUE(broken->place_mm);
}

TEST(CaseCheck, SideNeedsAWholeWordAndANamedSide) {
  PatientCase patient = test::cylinderNeck();
  for (const char* name : {"leftover vein", "internal jugular vein", "vein left of the right lobe"}) {
    patient.manifest.vessels[0].name = patient.manifest.targets[0].name = name;
    EXPECT_EQ(codes(findingsOf(patient)), "") << name;
  }
}

TEST(CaseCheck, AVesselIsOnTheSideOfItsName) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels[0].name = "Left internal jugular vein";
  EXPECT_TRUE(has(findingsOf(patient), "wrong_side", FindingSeverity::kError));
}

TEST(CaseCheck, NamesInOtherLanguagesAreChecked) {
  for (const char* name : {"V. jugularis interna links", "veine jugulaire interne gauche",
                           "vena yugular interna izquierda", "Vena jugularis interna sinistra"}) {
    PatientCase patient = test::cylinderNeck();
    patient.manifest.vessels[0].name = name;
    EXPECT_TRUE(has(findingsOf(patient), "wrong_side", FindingSeverity::kError)) << name;
  }
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels[0].name = "Vena jugularis interna dextra";
  patient.manifest.vessels.push_back(
      {"A. carotis communis rechts", kArtery, {{{-40, -22, -20}, 4}, {{-40, -22, 20}, 4}}});
  EXPECT_TRUE(has(findingsOf(patient), "vein_medial", FindingSeverity::kWarning));
}

/// The center of a body that the volume cuts is not its midline.
TEST(CaseCheck, SidesAreNotJudgedInACutBody) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels[0].name = "Left internal jugular vein";
  for (int k = 0; k < patient.labels.geometry.size[2]; ++k) patient.labels.at(0, 0, k) = kMuscle;
  EXPECT_FALSE(has(findingsOf(patient), "wrong_side", FindingSeverity::kError));
}

TEST(CaseCheck, AVeinLateralOfItsCarotidIsAsExpected) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels.push_back(
      {"right common carotid artery", kArtery, {{{-20, -22, -20}, 4}, {{-20, -22, 20}, 4}}});
  EXPECT_FALSE(has(findingsOf(patient), "vein_medial", FindingSeverity::kWarning));
}

const Finding* findingOf(const std::vector<Finding>& findings, const std::string& code) {
  const auto found = std::ranges::find(findings, code, &Finding::code);
  return found == findings.end() ? nullptr : &*found;
}

TEST(CaseCheck, ALumenIsNamedWithItsMedianAndWhatHasSuchValues) {
  PatientCase patient = test::cylinderNeck();
  for (const auto& [hu, like] : {std::pair{std::int16_t{-95}, "like fat"},
                                 {std::int16_t{-900}, "like air or lung"},
                                 {std::int16_t{5}, "like water"},
                                 {std::int16_t{1200}, "like bone"}}) {
    setHu(patient, kVein, hu);
    const auto findings = findingsOf(patient);
    const Finding* lumen = findingOf(findings, "lumen_hu");
    ASSERT_TRUE(lumen) << hu;
    EXPECT_THAT(lumen->text, testing::HasSubstr("The lumen of the right internal jugular vein has a median of " +
                                                std::to_string(hu) + " HU, " + like));
    EXPECT_EQ(lumen->label, kVein);
    ASSERT_TRUE(lumen->place_mm);
    EXPECT_EQ(sampleNearest(patient.labels, patient.labels.geometry.indexFromPatient() * *lumen->place_mm), kVein);
  }
}

/// The voxels at the wall hold fat, too, and noise is symmetric.
TEST(CaseCheck, NoiseAndPartialVolumeDoNotChangeALumen) {
  PatientCase patient = test::cylinderNeck();
  const VolumeGeometry& g = patient.labels.geometry;
  for (int k = 0; k < g.size[2]; ++k)
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const double off_mm = std::hypot(i - 60 + 30, j - 60 + 22);
        if (patient.labels.at(i, j, k) != kVein) continue;
        patient.ct.at(i, j, k) = std::int16_t(off_mm > 6 ? -60 : 45 - 60 + (31 * i + 17 * j + 7 * k) % 121);
      }
  EXPECT_EQ(codes(findingsOf(patient)), "");
}

TEST(CaseCheck, EnhancedAndUnenhancedBloodAreAsExpected) {
  PatientCase patient = test::cylinderNeck();
  for (const std::int16_t hu : {30, 60, 180, 590}) {
    setHu(patient, kVein, hu);
    EXPECT_EQ(codes(findingsOf(patient)), "") << hu;
  }
}

TEST(CaseCheck, AVesselWithoutANameIsCheckedApartFromNamedOnes) {
  PatientCase patient = test::cylinderNeck();
  for (int k = 0; k < 61; ++k)
    for (int j = 60; j < 70; ++j)
      for (int i = 90; i < 100; ++i) patient.labels.at(i, j, k) = kVein, patient.ct.at(i, j, k) = -95;
  const auto findings = findingsOf(patient);
  const Finding* lumen = findingOf(findings, "lumen_hu");
  ASSERT_TRUE(lumen);
  EXPECT_THAT(lumen->text, testing::HasSubstr("the vein without a name"));
}

TEST(CaseCheck, AClickOutsideItsVesselIsNamedWithItsPosition) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels[0].clicks_mm = {{-30, -22, -5}, {-38, -22, 0}};  // the second is 1 mm beside the vein
  EXPECT_EQ(codes(findingsOf(patient)), "");
  patient.manifest.vessels[0].clicks_mm.push_back({-30, -10, 5});
  const auto findings = findingsOf(patient);
  const Finding* click = findingOf(findings, "click_outside");
  ASSERT_TRUE(click);
  EXPECT_THAT(click->text, testing::HasSubstr("(-30.0, -10.0, 5.0) mm lies on muscle, outside the vein"));
  EXPECT_EQ(click->place_mm, (Vec3{-30, -10, 5}));
}

/// Replaces the vein of the cylinder by an ellipse in the slices from one z to another.
void shapeVein(PatientCase& p, double halfWidth_mm, double halfHeight_mm, int from_mm = -30, int to_mm = 30) {
  for (int k = from_mm + 30; k <= to_mm + 30; ++k)
    for (int j = 0; j < 121; ++j)
      for (int i = 0; i < 121; ++i) {
        std::uint8_t& label = p.labels.at(i, j, k);
        if (label != kVein && label != kMuscle) continue;
        label = std::hypot((i - 30) / halfWidth_mm, (j - 38) / halfHeight_mm) < 1 ? kVein : kMuscle;
      }
}

TEST(CaseCheck, AVesselIsMeasuredAlongItsWholeCourse) {
  PatientCase patient = test::cylinderNeck();
  shapeVein(patient, 9, 22, 10, 20);
  const auto findings = findingsOf(patient);
  const Finding* size = findingOf(findings, "vessel_too_large");
  ASSERT_TRUE(size) << codes(findings);
  EXPECT_EQ(size->severity, FindingSeverity::kError);
  EXPECT_THAT(size->text, testing::HasSubstr("the right internal jugular vein measures 3"));
  EXPECT_THAT(size->text, testing::HasSubstr("mm from the target"));
  EXPECT_THAT(size->text, testing::HasSubstr("4 to 19.5 mm (Anaesth Intensive Care 2008;36:65)"));
  ASSERT_TRUE(size->place_mm);
  EXPECT_GE(size->place_mm->z, 10);
  EXPECT_LE(size->place_mm->z, 20);
}

/// Names the cylinder's vein; 14 mm wide and round.
std::vector<Finding> findingsOfVeinNamed(const std::string& name) {
  PatientCase patient = test::cylinderNeck();
  patient.manifest.vessels[0].name = patient.manifest.targets[0].name = name;
  return findingsOf(patient);
}

TEST(CaseCheck, EachVesselHasARangeOfItsOwn) {
  EXPECT_FALSE(findingOf(findingsOfVeinNamed("right femoral vein"), "vessel_large"));
  const auto basilic = findingsOfVeinNamed("right basilic vein");
  const Finding* large = findingOf(basilic, "vessel_large");
  ASSERT_TRUE(large) << codes(basilic);
  EXPECT_EQ(large->severity, FindingSeverity::kWarning);
  EXPECT_THAT(large->text, testing::HasSubstr("1.2 to 8.4 mm"));
  EXPECT_TRUE(findingOf(findingsOfVeinNamed("Vena cephalica dextra"), "vessel_too_large")) << "at most 12.8 mm";
}

TEST(CaseCheck, AVesselThatIsTooSmallIsAWarning) {
  PatientCase patient = test::cylinderNeck();
  shapeVein(patient, 1.6, 1.6, -4, 8);
  const auto findings = findingsOf(patient);
  const Finding* small = findingOf(findings, "vessel_small");
  ASSERT_TRUE(small) << codes(findings);
  EXPECT_EQ(small->severity, FindingSeverity::kWarning);
  EXPECT_THAT(small->text, testing::HasSubstr("Check that the whole lumen is labeled as vein"));
}

TEST(CaseCheck, AnArteryHasARange) {
  PatientCase patient = test::cylinderNeck();
  const auto named = [&](const std::string& name) {
    patient.manifest.vessels.resize(1);
    patient.manifest.vessels.push_back({name, kArtery, {{{-16, -20, -20}, 4}, {{-16, -20, 20}, 4}}});
    return findingsOf(patient);
  };
  EXPECT_EQ(codes(named("right common carotid artery")), "");
  const auto brachial = named("right brachial artery");
  const Finding* large = findingOf(brachial, "vessel_large");
  ASSERT_TRUE(large) << codes(brachial);
  EXPECT_EQ(large->label, kArtery);
}

/// A section at one place is not enough, since a branch may join there.
TEST(CaseCheck, ABranchIsNoSizeOfAVessel) {
  PatientCase patient = test::cylinderNeck();
  for (int k = 44; k < 46; ++k)
    for (int j = 38; j < 70; ++j)
      for (int i = 24; i < 36; ++i)
        if (patient.labels.at(i, j, k) == kMuscle) patient.labels.at(i, j, k) = kVein;
  const auto findings = findingsOf(patient);
  EXPECT_FALSE(findingOf(findings, "vessel_large")) << codes(findings);
  EXPECT_FALSE(findingOf(findings, "vessel_too_large")) << codes(findings);
}

TEST(CaseCheck, VesselSizesAreOrderedAndHaveSources) {
  EXPECT_EQ(check::vesselSizes().size(), 16U);
  for (const check::VesselSizes& sizes : check::vesselSizes()) {
    EXPECT_LT(0, sizes.smallest_mm) << sizes.source;
    EXPECT_LT(sizes.smallest_mm, sizes.largest_mm) << sizes.source;
    EXPECT_LT(sizes.largest_mm, sizes.impossible_mm) << sizes.source;
    EXPECT_FALSE(sizes.source.empty());
  }
}

TEST(CaseCheck, OneSliceIsTooThin) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({64, 64, 1}), 40);
  patient.labels = LabelMap(patient.ct.geometry, kMuscle);
  const auto findings = findingsOf(patient);
  EXPECT_TRUE(has(findings, "volume_thin", FindingSeverity::kError)) << codes(findings);
}

TEST(CaseCheck, SmallVolumeIsTooSmall) {
  PatientCase patient;
  patient.ct = CtVolume(test::grid({64, 64, 10}), 40);
  patient.labels = LabelMap(patient.ct.geometry, kMuscle);
  const auto findings = findingsOf(patient);
  EXPECT_TRUE(has(findings, "volume_small", FindingSeverity::kError)) << codes(findings);
  EXPECT_TRUE(has(findings, "cut_at_side", FindingSeverity::kInfo)) << codes(findings);
}

TEST(CaseCheck, TwoVesselsSideBySideAreNotBroken) {
  PatientCase patient = test::cylinderNeck();
  for (int k = 0; k < 61; ++k)
    for (int j = 60; j < 70; ++j)
      for (int i = 90; i < 100; ++i) patient.labels.at(i, j, k) = kVein;
  EXPECT_FALSE(has(findingsOf(patient), "vein_broken", FindingSeverity::kWarning));
}

TEST(CaseCheck, CancelsWhenAsked) {
  const auto findings = checkCase(test::cylinderNeck(), [](std::string_view, double) { return false; });
  ASSERT_FALSE(findings);
  EXPECT_EQ(findings.error().message, kCancelled);
}

}  // namespace
}  // namespace insonate
