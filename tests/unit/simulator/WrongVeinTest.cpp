#include "support/TestData.h"

#include <insonate/cases/CaseFromLabels.h>
#include <insonate/cases/Import.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/TissueLabels.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/segmentation/AutoLabel.h>
#include <insonate/segmentation/LabelEdit.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/simulator/VesselNaming.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate {
namespace {

/// Shortest way out of the body from a point, toward the front half; `slant` toward the head for each mm outward.
struct WayOut {
  Vec3 outward;
  double length_mm = 0;
};
std::optional<WayOut> wayOut(const LabelMap& labels, Vec3 from_mm, double slant = 0) {
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  std::optional<WayOut> best;
  for (int degrees = -100; degrees <= 100; degrees += 10) {
    const double a = degrees * std::numbers::pi / 180;
    const Vec3 outward = normalized({std::sin(a), -std::cos(a), slant});
    for (double length_mm = 0; length_mm < 60; length_mm += 0.5) {
      const Vec3 index = indexFromPatient * (from_mm + outward * length_mm);
      const auto i = std::lround(index.x), j = std::lround(index.y), k = std::lround(index.z);
      if (!labels.geometry.contains(int(i), int(j), int(k))) break;
      if (labels.at(int(i), int(j), int(k)) != kBackground) continue;
      if (!best || length_mm < best->length_mm) best = WayOut{outward, length_mm};
      break;
    }
  }
  return best;
}

/// Point of a vessel nearest to the skin, among every third point of its course.
std::optional<std::pair<Vec3, WayOut>> nearestToSkin(const LabelMap& labels, const NamedVessel& vessel, double slant) {
  std::optional<std::pair<Vec3, WayOut>> best;
  for (std::size_t i = 0; i < vessel.course.size(); i += 3) {
    const Vec3 at_mm = vessel.course[i].position_mm;
    const Vec3 index = labels.geometry.indexFromPatient() * at_mm;
    if (!labels.geometry.contains(int(std::lround(index.x)), int(std::lround(index.y)), int(std::lround(index.z))))
      continue;
    const auto way = wayOut(labels, at_mm, slant);
    if (way && (!best || way->length_mm < best->second.length_mm)) best.emplace(at_mm, *way);
  }
  return best;
}

/// Drives a needle into vessels of a case, and aspirates there.
class WrongVein : public testing::Test {
 protected:
  struct Drive {
    int driven = 0, entered = 0;
  };

  Result<SessionOutcome> drive(const PatientCase& patient, const std::string& procedure, Vec3 to_mm,
                               const WayOut& way) {
    const Vec3 target_mm = patient.manifest.targets.front().position_mm;
    // The needle is first taken up beside the target, which makes this the one that is meant.
    SessionScript script;
    script.procedure = procedure;
    script.actions = {{ScriptAction::PlaceNeedle{target_mm - Vec3{0, 60, 0}, target_mm}},
                      {ScriptAction::PlaceNeedle{to_mm + way.outward * (way.length_mm + 5), to_mm}},
                      {ScriptAction::Aspirate{true}},
                      {ScriptAction::MoveNeedle{way.length_mm + 6}},
                      {ScriptAction::Wait{2}}};
    return runSession(script, patient, "insonate test", folder_ / std::to_string(++runs_));
  }

  /// The drive is known to work, since on the target it succeeds.
  void expectTheTargetCounts(const PatientCase& patient, const std::string& procedure) {
    const Vec3 target_mm = patient.manifest.targets.front().position_mm;
    const auto right = drive(patient, procedure, target_mm, *wayOut(patient.labels, target_mm));
    ASSERT_TRUE(right) << right.error().message;
    EXPECT_EQ(right->metrics[Metric::VeinPunctures], 1);
    EXPECT_EQ(right->metrics[Metric::TipInVein], 1);
  }

  /// Into each vein and artery of the case but the target: none is a success.
  Drive expectNoOtherCounts(const PatientCase& patient, const std::string& procedure) {
    const Target& target = patient.manifest.targets.front();
    Drive all;
    for (const NamedVessel& vessel : patient.manifest.vessels) {
      if (vessel.name == target.name) continue;
      SCOPED_TRACE(vessel.name);
      bool isDriven = false, isEntered = false;
      // The skin gives way only some millimeters deep, beyond a thin vein: another needle comes slanted along the vein.
      for (const double slant : {0.0, 3.0, -3.0}) {
        const auto place = nearestToSkin(patient.labels, vessel, slant);
        if (isEntered || !place || norm(place->first - target.position_mm) > 80) continue;
        const auto wrong = drive(patient, procedure, place->first, place->second);
        EXPECT_TRUE(wrong) << wrong.error().message;
        if (!wrong) continue;
        isDriven = true;
        EXPECT_FALSE(wrong->run.succeeded());
        isEntered = std::ranges::any_of(wrong->events, [&](const AttemptEvent& event) {
          return event.kind == AttemptEventKind::Entered && vesselName(event, wrong->run.vessels()) == vessel.name;
        });
      }
      if (isDriven) std::cout << (isEntered ? "entered: " : "not reached: ") << vessel.name << '\n';
      all.driven += isDriven, all.entered += isEntered;
    }
    std::cout << all.driven << " vessels, " << all.entered << " of them entered\n";
    return all;
  }

 private:
  const test::TemporaryFolder folder_;
  int runs_ = 0;
};

class WrongVeinOfVariants : public WrongVein, public testing::WithParamInterface<std::string> {};

std::string procedureFor(std::string_view variant) {
  switch (phantomVariant(variant)->region) {
    case PhantomRegion::kNeck:
      return "internal_jugular";
    case PhantomRegion::kChest:
      return std::string(variant);
    case PhantomRegion::kArm:
      return "basilic";
    case PhantomRegion::kGroin:
      return "femoral";
  }
  return {};
}

TEST_P(WrongVeinOfVariants, NonePasses) {
  auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  replaceOwnLabels(*patient);
  const std::string procedure = procedureFor(GetParam());
  expectTheTargetCounts(*patient, procedure);
  const Drive all = expectNoOtherCounts(*patient, procedure);
  EXPECT_GT(4 * all.entered, all.driven);
}

TEST_F(WrongVein, OfTheAtlasNonePasses) {
  INSONATE_NEEDS_DATA("neck-atlas-labels/HN-Atlas-labels.nrrd");
  const auto made =
      caseFromLabels(test::testData("neck-atlas-labels/HN-Atlas-labels.nrrd"),
                     std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/maps/spl-head-neck.json", {});
  ASSERT_TRUE(made) << made.error().message;
  expectTheTargetCounts(made->patient, "internal_jugular");
  const Drive all = expectNoOtherCounts(made->patient, "internal_jugular");
  EXPECT_GE(all.entered, 3);
}

/// A neck as an author labels it: vessels painted along clicks, the jugular veins and carotids by the guide's steps,
/// which name them, and a vein below the skin that has no name.
Result<PatientCase> labeledRealCt() {
  auto imported = importSeries(test::testData("neck-ct-dicom"));
  if (!imported) return tl::unexpected(imported.error());
  auto labels = autoLabel(imported->ct, {});
  if (!labels) return tl::unexpected(labels.error());
  PatientCase patient{{}, std::move(imported->ct), std::move(*labels)};
  Recipe recipe;
  const auto paint = [&](const char* of, std::uint8_t label, double radius_mm, Vec3 from_mm, Vec3 to_mm) {
    step::Paint tool{.points_mm = {}, .radius_mm = radius_mm};
    for (int n = 0; n <= 40; ++n) tool.points_mm.push_back(from_mm + (to_mm - from_mm) * (n / 40.0));
    LabelStep made;
    made.tool = std::move(tool), made.label = label, made.of = of;
    recipe.steps.push_back(std::move(made));
  };
  paint("vein-right", kVein, 5, {-46, -14, -252}, {-46, -14, -212});
  paint("artery-right", kArtery, 3, {-36, -16, -252}, {-36, -16, -212});
  paint("vein-left", kVein, 5, {18, -14, -252}, {18, -14, -212});
  paint("artery-left", kArtery, 3, {9, -16, -252}, {9, -16, -212});
  paint("", kVein, 2.5, {-62, -26, -252}, {-62, -26, -212});
  LabelEdit edit(patient.ct, patient.labels);
  if (const auto changes = perform(recipe, edit); !changes) return tl::unexpected(changes.error());
  auto vessels = vesselsFromGuide(*readGuide(guidePresets().front().text), recipe, patient.labels, {});
  if (!vessels) return tl::unexpected(vessels.error());
  patient.manifest.vessels = std::move(*vessels);
  patient.manifest.targets = {{"right internal jugular vein", kVein, {-46, -14, -230}}};
  return patient;
}

TEST_F(WrongVein, OfARealCtNonePasses) {
  INSONATE_NEEDS_DATA("neck-ct-dicom");
  const auto patient = labeledRealCt();
  ASSERT_TRUE(patient) << patient.error().message;
  ASSERT_EQ(patient->manifest.vessels.size(), 4u);
  expectTheTargetCounts(*patient, "internal_jugular");
  const Drive all = expectNoOtherCounts(*patient, "internal_jugular");
  EXPECT_GE(all.entered, 1);

  const Vec3 unnamed_mm{-62, -26, -230};
  const auto small = drive(*patient, "internal_jugular", unnamed_mm, *wayOut(patient->labels, unnamed_mm));
  ASSERT_TRUE(small) << small.error().message;
  EXPECT_EQ(small->metrics[Metric::OtherVeinPunctures], 1) << "a vein without a name is another vein";
  EXPECT_FALSE(small->run.succeeded());
}

std::vector<std::string> variants() {
  std::vector<std::string> names;
  for (const PhantomVariant& variant : phantomVariants()) names.emplace_back(variant.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, WrongVeinOfVariants, testing::ValuesIn(variants()), [](const auto& variant) {
  std::string name;
  for (const char c : variant.param)
    if (c != '-') name += c;
  return name;
});

}  // namespace
}  // namespace insonate
