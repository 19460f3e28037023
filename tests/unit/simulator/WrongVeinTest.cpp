#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ScriptedSession.h>
#include <insonate/simulator/TargetVein.h>

#include <gmock/gmock.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

/// Shortest way out of the body from a point, in the transverse plane and toward the front half.
struct WayOut {
  Vec3 outward;
  double length_mm = 0;
};
std::optional<WayOut> wayOut(const LabelMap& labels, Vec3 from_mm) {
  const Transform indexFromPatient = labels.geometry.indexFromPatient();
  std::optional<WayOut> best;
  for (int degrees = -100; degrees <= 100; degrees += 10) {
    const double a = degrees * std::numbers::pi / 180;
    const Vec3 outward{std::sin(a), -std::cos(a), 0};
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

class WrongVein : public testing::TestWithParam<std::string> {};

/// Drives the needle into the middle of each line of each vein but the target's, and aspirates there: none passes. The
/// same on the target's line passes, so that the drive itself is known to work.
TEST_P(WrongVein, NonePasses) {
  const auto patient = makePhantom(GetParam(), 1);
  ASSERT_TRUE(patient) << patient.error().message;
  const std::string procedure = GetParam() == "subclavian" ? "subclavian" : "internal_jugular";
  const auto lines = centreLines(patient->labels, kVein);
  ASSERT_TRUE(lines) << lines.error().message;
  const Vec3 aim_mm = patient->manifest.targets.front().position_mm;
  const TargetVein target(patient->manifest, *loadProcedure(procedure), aim_mm);

  const test::TemporaryFolder folder;
  int runs = 0;
  const auto drive = [&](Vec3 to_mm, const WayOut& way) {
    // The needle starts beside the target's skin, then is put where it goes in: the attempt stays for this target.
    SessionScript script;
    script.procedure = procedure;
    script.acts = {{SessionAct::PutNeedle{aim_mm - Vec3{0, 60, 0}, aim_mm}},
                   {SessionAct::PutNeedle{to_mm + way.outward * (way.length_mm + 5), to_mm}},
                   {SessionAct::Aspirate{true}},
                   {SessionAct::MoveNeedle{way.length_mm + 6}},
                   {SessionAct::Wait{2}}};
    return runSession(script, *patient, "insonate test", folder / std::to_string(++runs));
  };

  const auto right = drive(aim_mm, *wayOut(patient->labels, aim_mm));
  ASSERT_TRUE(right) << right.error().message;
  EXPECT_EQ(right->metrics[Metric::VeinPunctures], 1);
  EXPECT_EQ(right->metrics[Metric::TipInVein], 1);

  int entered = 0;
  for (const CentreLine& line : *lines) {
    const Vec3 middle_mm = line[line.size() / 2];
    if (target.vesselAt(middle_mm, *lines) == 1) continue;
    const auto way = wayOut(patient->labels, middle_mm);
    if (!way || norm(middle_mm - aim_mm) > 80) continue;
    const auto wrong = drive(middle_mm, *way);
    ASSERT_TRUE(wrong) << wrong.error().message;
    EXPECT_FALSE(wrong->run.succeeded()) << "at " << middle_mm.x << ", " << middle_mm.y << ", " << middle_mm.z;
    if (*wrong->metrics[Metric::OtherVeinPunctures] > 0) ++entered;
  }
  std::cout << GetParam() << ": " << entered << " of " << lines->size() << " veins were entered beside the target\n";
  EXPECT_GT(entered, 0);
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
