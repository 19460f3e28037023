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
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {
namespace {

/// One of `count` directions all over a sphere, by the golden angle.
Vec3 directionOf(int n, int count) {
  const double z = 2 * (n + 0.5) / count - 1, turn = n * 2.399963;
  return {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
}

/// A straight way of the needle from a point of a vessel out through the skin.
struct WayOut {
  Vec3 at_mm, outward;
  double radius_mm = 0;  ///< radius of the vessel there
  double length_mm = 0;
  int others = 0;  ///< steps of half a millimeter through other vessels, lung or cartilage
};

constexpr double kStep_mm = 0.5;
/// The skin gives way only some millimeters deep, thus the needle must meet a shallow vessel aslant; a needle of 70 mm
/// stays in the hand.
constexpr double kShortest_mm = 13, kLongest_mm = 58;
/// A needle slides along a wall that it meets flatter than this.
constexpr double kLeastSteepness = 0.4;
constexpr double kBend_mm = 5.5;

std::uint8_t labelAt(const LabelMap& labels, const Transform& indexFromPatient, Vec3 at_mm) {
  const Vec3 index = indexFromPatient * at_mm;
  const auto i = int(std::lround(index.x)), j = int(std::lround(index.y)), k = int(std::lround(index.z));
  return labels.geometry.contains(i, j, k) ? labels.at(i, j, k) : std::uint8_t{255};
}

/// The way in one direction; none if it meets bone or leaves the map, or if it is too short or too long.
std::optional<WayOut> wayOut(const LabelMap& labels, Vec3 at_mm, Vec3 outward, double radius_mm) {
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  WayOut way{at_mm, outward, radius_mm};
  for (; way.length_mm < kLongest_mm; way.length_mm += kStep_mm) {
    const std::uint8_t label = labelAt(labels, indexFromPatient, at_mm + outward * way.length_mm);
    if (label == 255 || label == kBone) return std::nullopt;
    if (label == kBackground) return way.length_mm < kShortest_mm ? std::nullopt : std::optional(way);
    const bool isVessel = label == kVein || label == kArtery;
    way.others += (isVessel && way.length_mm > 1.5 * radius_mm + 1) || label == kAirway || label == kCartilage;
  }
  return std::nullopt;
}

/// Angle of a way to the skin: the skin is nearer beside a way that meets it flatly.
bool isSteepAtSkin(const LabelMap& labels, const WayOut& way) {
  constexpr double kInside_mm = 4;
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  const Vec3 inside_mm = way.at_mm + way.outward * (way.length_mm - kInside_mm);
  double nearest_mm = kInside_mm;
  for (int n = 0; n < 100; ++n)
    for (double mm = kStep_mm; mm < nearest_mm; mm += kStep_mm)
      if (labelAt(labels, indexFromPatient, inside_mm + directionOf(n, 100) * mm) == kBackground) nearest_mm = mm;
  return nearest_mm >= 0.45 * kInside_mm;
}

/// Ways into a vessel near a place, the ones through least other vessels first, of these the shortest first.
std::vector<WayOut> waysInto(const LabelMap& labels, const NamedVessel& vessel, Vec3 near_mm) {
  constexpr double kFarthest_mm = 140;
  std::vector<WayOut> ways;
  const auto& course = vessel.course;
  for (std::size_t i = 1; i + 1 < course.size(); i += 2) {
    const Vec3 at_mm = course[i].position_mm;
    if (norm(at_mm - near_mm) > kFarthest_mm) continue;
    const Vec3 along = normalized(course[i + 1].position_mm - course[i - 1].position_mm);
    for (int n = 0; n < 150; ++n) {
      const Vec3 outward = directionOf(n, 150);
      if (norm(cross(outward, along)) < kLeastSteepness) continue;
      if (auto way = wayOut(labels, at_mm, outward, course[i].radius_mm)) ways.push_back(*way);
    }
  }
  std::ranges::sort(ways, {}, [](const WayOut& way) { return std::pair(way.others, way.length_mm); });
  return ways;
}

/// Some of the ways that meet the skin steeply, the best ones first.
std::vector<WayOut> steepWays(const LabelMap& labels, const std::vector<WayOut>& ways) {
  constexpr std::size_t kTries = 6;
  std::vector<WayOut> steep;
  for (std::size_t i = 0; i < ways.size() && steep.size() < kTries; i += 1 + ways.size() / 40)
    if (isSteepAtSkin(labels, ways[i])) steep.push_back(ways[i]);
  return steep;
}

/// Drives a needle into vessels of a case, and aspirates there.
class WrongVein : public testing::Test {
 protected:
  Result<SessionOutcome> drive(const PatientCase& patient, const std::string& procedure, const WayOut& way) {
    const Vec3 target_mm = patient.manifest.targets.front().position_mm;
    // The wall bends by some millimeters before it gives way, behind the middle of a thin vessel.
    const double beyond_mm = std::max(1.0, kBend_mm - way.radius_mm);
    // The needle is first taken up nearer to this target than to another one, which makes this the one that is meant;
    // the session has tissue around this place.
    const Vec3 first_mm = target_mm * 0.55 + way.at_mm * 0.45 - Vec3{0, 30, 0};
    SessionScript script;
    script.procedure = procedure;
    script.actions = {{ScriptAction::PlaceNeedle{first_mm, first_mm + Vec3{0, 1, 0}}},
                      {ScriptAction::PlaceNeedle{way.at_mm + way.outward * (way.length_mm + 5), way.at_mm}},
                      {ScriptAction::Aspirate{true}},
                      {ScriptAction::MoveNeedle{way.length_mm + 5 + beyond_mm}},
                      {ScriptAction::Wait{2}}};
    return runSession(script, patient, "insonate test", folder_ / std::to_string(++runs_));
  }

  /// The drive is known to work, since on the target it succeeds.
  void expectTheTargetCounts(const PatientCase& patient, const std::string& procedure) {
    const Target& target = patient.manifest.targets.front();
    const auto vessel = std::ranges::find(patient.manifest.vessels, target.name, &NamedVessel::name);
    ASSERT_NE(vessel, patient.manifest.vessels.end());
    bool isReached = false;
    for (const WayOut& way : steepWays(patient.labels, waysInto(patient.labels, *vessel, target.position_mm))) {
      const auto right = drive(patient, procedure, way);
      ASSERT_TRUE(right) << right.error().message;
      isReached = right->metrics[Metric::VeinPunctures] == 1 && right->metrics[Metric::TipInVein] == 1;
      if (isReached) break;
    }
    EXPECT_TRUE(isReached);
  }

  /// Into each vein and artery of the case but the target: none is a success. Returns the vessels that a needle cannot
  /// reach, since they lie behind bone or too deep.
  std::vector<std::string> expectNoOtherCounts(const PatientCase& patient, const std::string& procedure) {
    const Target& target = patient.manifest.targets.front();
    std::vector<std::string> outOfReach;
    for (const NamedVessel& vessel : patient.manifest.vessels) {
      if (vessel.name == target.name) continue;
      SCOPED_TRACE(vessel.name);
      const auto ways = steepWays(patient.labels, waysInto(patient.labels, vessel, target.position_mm));
      bool isEntered = false;
      for (const WayOut& way : ways) {
        const auto wrong = drive(patient, procedure, way);
        EXPECT_TRUE(wrong) << wrong.error().message;
        if (!wrong) continue;
        EXPECT_FALSE(wrong->run.succeeded());
        isEntered = std::ranges::any_of(wrong->events, [&](const AttemptEvent& event) {
          return event.kind == AttemptEventKind::Entered && vesselName(event, wrong->run.vessels()) == vessel.name;
        });
        if (isEntered) break;
      }
      std::cout << (ways.empty() ? "out of reach: "
                    : isEntered  ? "entered: "
                                 : "NOT ENTERED: ")
                << vessel.name << std::endl;
      if (ways.empty())
        outOfReach.push_back(vessel.name);
      else
        EXPECT_TRUE(isEntered);
    }
    return outOfReach;
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
  const auto outOfReach = expectNoOtherCounts(*patient, procedure);
  EXPECT_LE(3 * outOfReach.size(), patient->manifest.vessels.size()) << "most are driven";
}

TEST_F(WrongVein, OfTheAtlasNonePasses) {
  INSONATE_NEEDS_DATA("neck-atlas-labels/HN-Atlas-labels.nrrd");
  const auto made =
      caseFromLabels(test::testData("neck-atlas-labels/HN-Atlas-labels.nrrd"),
                     std::filesystem::path(INSONATE_SOURCE_DIR) / "resources/maps/spl-head-neck.json", {});
  ASSERT_TRUE(made) << made.error().message;
  expectTheTargetCounts(made->patient, "internal_jugular");
  EXPECT_LE(expectNoOtherCounts(made->patient, "internal_jugular").size(), 1U) << "the superior vena cava";
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
  EXPECT_TRUE(expectNoOtherCounts(*patient, "internal_jugular").empty());

  const NamedVessel unnamed{"", kVein, {{{-62, -26, -233}, 2.5}, {{-62, -26, -230}, 2.5}, {{-62, -26, -227}, 2.5}}};
  const auto ways = waysInto(patient->labels, unnamed, patient->manifest.targets.front().position_mm);
  ASSERT_FALSE(ways.empty());
  const auto small = drive(*patient, "internal_jugular", ways.front());
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
