#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/procedure/AttemptScore.h>
#include <insonate/simulator/ScriptedSession.h>

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

/// Where a vessel is nearest to the skin, among every third point of its course.
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

class WrongVein : public testing::TestWithParam<std::string> {};

/// Drives the needle into each vein and artery but the target, and aspirates there: none passes. The same on the target
/// reaches it, so that the drive itself is known to work.
TEST_P(WrongVein, NonePasses) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const std::string procedure = GetParam() == "subclavian" ? "subclavian" : "internal_jugular";
  const Target& target = patient->manifest.targets.front();
  const test::TemporaryFolder folder;
  int runs = 0;
  const auto drive = [&](Vec3 to_mm, const WayOut& way) {
    // The needle is first taken up beside the target, which makes this the one that is meant.
    SessionScript script;
    script.procedure = procedure;
    script.acts = {{SessionAct::PutNeedle{target.position_mm - Vec3{0, 60, 0}, target.position_mm}},
                   {SessionAct::PutNeedle{to_mm + way.outward * (way.length_mm + 5), to_mm}},
                   {SessionAct::Aspirate{true}},
                   {SessionAct::MoveNeedle{way.length_mm + 6}},
                   {SessionAct::Wait{2}}};
    return runSession(script, *patient, "insonate test", folder / std::to_string(++runs));
  };

  const auto right = drive(target.position_mm, *wayOut(patient->labels, target.position_mm));
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_EQ(right->metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(right->metrics[Metric::TipInVein], 1);

  int driven = 0, entered = 0;
  for (const NamedVessel& vessel : patient->manifest.vessels) {
    if (vessel.name == target.name) continue;
    SCOPED_TRACE(vessel.name);
    bool isDriven = false, isEntered = false;
    // The skin gives way only some millimetres deep, beyond a thin vein: another needle comes slanted along the vein.
    for (const double slant : {0.0, 3.0, -3.0}) {
      const auto place = nearestToSkin(patient->labels, vessel, slant);
      if (isEntered || !place || norm(place->first - target.position_mm) > 80) continue;
      const auto wrong = drive(place->first, place->second);
      ASSERT_TRUE(wrong) << wrong.error().message;
      isDriven = true;
      EXPECT_FALSE(wrong->run.succeeded());
      isEntered = std::ranges::any_of(wrong->events, [&](const AttemptEvent& event) {
        return event.kind == AttemptEventKind::Entered && vesselName(event, wrong->run.vessels()) == vessel.name;
      });
    }
    if (isDriven) std::cout << (isEntered ? "entered: " : "not reached: ") << vessel.name << '\n';
    driven += isDriven, entered += isEntered;
  }
  std::cout << GetParam() << ": " << driven << " vessels, " << entered << " of them entered\n";
  EXPECT_GT(4 * entered, driven);
}

std::vector<std::string> variants() {
  std::vector<std::string> names;
  for (const PhantomVariant& variant : phantomVariants()) names.emplace_back(variant.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, WrongVein, testing::ValuesIn(variants()), [](const auto& variant) {
  std::string name;
  for (const char c : variant.param)
    if (c != '-') name += c;
  return name;
});

}  // namespace
}  // namespace insonate
