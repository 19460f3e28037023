#include "MetricsByHand.h"
#include "support/AttemptBlock.h"
#include "support/TestData.h"

#include <insonate/simulator/ScriptedSession.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

using test::bend_mm;
using test::expectMetrics;
using test::kMissing;

/// Whole attempts on the block, and each of their 26 metrics worked out by hand from the block's walls. All times are
/// those of hands at 10 mm/s, so that a millimetre is a tenth of a second.
///
const double kSkin_mm = bend_mm(kSkin);       // (0.24 - 0.1) / 0.16 = 0.875; + (1.8 - 0.149) / 0.24 = 7.755
const double kVein_mm = 12 + bend_mm(kVein);  // 1.6 + (0.6 - 0.256) / 0.24 = 3.033, below 12 mm
const double kBack_mm = 0.3;                  // pulled back as far behind its hole, the tip is out of it
const double kRoot2 = std::numbers::sqrt2;

// Why values may be off.
constexpr double kTicks_s = 0.004;  // events come with ticks of 1 ms, at a way of 0.01 mm; a needle put down is a tick
constexpr double kWay_mm = 0.05;    // the same, as a way
constexpr double kTurn_mm = 1;      // ways are in steps of 0.5 mm: a turn loses one on either side
constexpr double kMiddle_mm = 0.3;  // of a centre line found in voxels
constexpr double kWall_mm = 0.05;   // distances to flat walls are kept to 0.01 mm
constexpr double kEdge_mm = 0.3;    // the map rounds edges over a voxel
constexpr double kAngle_deg = 0.5;  // a normal is a difference of distances that are kept to 0.01 mm
double share(double way_mm) {       // a step of the way forward
  return 100 * 0.5 / way_mm;
}

class MetricsByHand : public testing::Test {
 protected:
  SessionOutcome play(const std::string& acts, const std::string& more = "") {
    const auto script = readSessionScript("{" + more + "\"acts\": [" + acts + "]}", patient);
    EXPECT_TRUE(script) << script.error().message;
    auto outcome = runSession(*script, patient, "insonate test", folder / "attempt", {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  /// Square to the skin at (x, z), the tip 5 mm before it.
  static std::string needle(int x_mm, int z_mm = 0) {
    const std::string x = std::to_string(x_mm), z = std::to_string(z_mm);
    return "{\"needle\": {\"from_mm\": [" + x + ", -5.5, " + z + "], \"to\": [" + x + ", 17.5, " + z + "]}}";
  }

  const PatientCase patient = test::attemptBlock();
  const test::TemporaryFolder folder;
};

/// At 45 degrees in the plane of the picture. Along the needle, ways are those across the block times root 2: 7.071 to
/// the skin, 16.971 on to the vein's front wall, 25.456 to its middle.
TEST_F(MetricsByHand, CleanSuccess) {
  const auto outcome = play(R"({"probe": "along"}, {"needle": {"from_mm": [0, -5.5, -23], "to": "vein"}},
    {"aspirate": true}, {"advance_mm": 32.53}, {"wait_s": 1.5})");
  const double toAccess_mm = 12 * kRoot2 + bend_mm(kVein) - kSkin_mm;  // 16.971 + 3.033 - 7.755 = 12.249
  expectMetrics(outcome.metrics,
                {{/* vein, artery, double */ {1},
                  {0},
                  {0},
                  /* time to vein */ {toAccess_mm / 10, kTicks_s},
                  /* used needle */ {0},
                  /* time to access */ {toAccess_mm / 10, kTicks_s},
                  /* attempt: 32.53 mm, 1.5 s */ {4.753, kTicks_s},
                  /* passes, redirections, lung, bone */ {1},
                  {0},
                  {0},
                  {0},
                  /* path */ {toAccess_mm, kWay_mm},
                  /* inefficiency, deviation: straight */ {0, 0.1},
                  {0, kWay_mm},
                  /* angle */ {45, kAngle_deg},
                  /* tip in picture, aspiration */ {100},
                  {100},
                  /* vein's centre */ {0, kMiddle_mm},
                  /* tip in vein */ {1},
                  /* artery: 10.5 aside, 2 deeper than the tip at 17.5 */ {std::hypot(10.5, 2), kEdge_mm},
                  /* lung: 39.5 - 17.5 */ {22, kWall_mm},
                  /* probe's path, translations, rotations */ {0},
                  {0},
                  {0},
                  /* probe's force: it touches nothing */ kMissing,
                  kMissing}});
  EXPECT_TRUE(outcome.run.succeeded());
  EXPECT_EQ(outcome.run.metrics().needle(), NeedlePlace::Vein);
}

/// To a depth of 30 mm, and back to 20.
TEST_F(MetricsByHand, PosteriorWall) {
  const auto outcome =
      play(R"({"probe": "across"}, )" + needle(0) + R"(, {"advance_mm": 35}, {"withdraw_mm": 10}, {"wait_s": 1})");
  const double toAccess_mm = kVein_mm - kSkin_mm;  // 15.033 - 7.755 = 7.278
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   /* back wall at 24 + 3.033 */ {1},
                                   {toAccess_mm / 10, kTicks_s},
                                   {0},
                                   {toAccess_mm / 10, kTicks_s},
                                   /* 35 + 10 mm, 1 s */ {5.5, kTicks_s},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {toAccess_mm, kWay_mm},
                                   {0, 0.1},
                                   {0, kWay_mm},
                                   {90, 1},
                                   {100},
                                   /* not drawn */ {0},
                                   /* it rests at 19.5, 2 behind the middle */ {2, kMiddle_mm},
                                   {1},
                                   /* artery: beside it, 10.5 aside */ {10.5, kWall_mm},
                                   /* lung: 39.5 - 29.5 */ {10, kWall_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kMissing,
                                   kMissing}});
}

/// At x = 18, to a depth of 25 mm, and out again.
TEST_F(MetricsByHand, CarotidPuncture) {
  const auto outcome = play(R"({"probe": "across"}, )" + needle(18) +
                            R"(, {"aspirate": true}, {"advance_mm": 30}, {"wait_s": 1}, {"withdraw_mm": 30})");
  expectMetrics(outcome.metrics, {{{0},
                                   /* front wall at 20 + 4.183 */ {1},
                                   {0},
                                   kMissing,
                                   {0},
                                   kMissing,
                                   /* 30 + 30 mm, 1 s */ {7, kTicks_s},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   /* 25 - 7.755 in, 25.3 out */ {25 - kSkin_mm + 25 + kBack_mm, kTurn_mm},
                                   kMissing,
                                   kMissing,
                                   {90, 1},
                                   {100},
                                   {100},
                                   kMissing,
                                   {0},
                                   /* artery: the tip at 24.5 is 5 within */ {-5, kWall_mm},
                                   /* lung: 39.5 - 24.5 */ {15, kWall_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kMissing,
                                   kMissing}});
  EXPECT_FALSE(outcome.run.succeeded());
}

/// Beside the vein to a depth of 15 mm and out, then into its middle; drawing only then.
std::string missedOnce(const std::string& between) {
  return R"({"advance_mm": 20}, {"withdraw_mm": 20}, )" + between;
}

TEST_F(MetricsByHand, UsedNeedle) {
  const auto outcome = play(R"({"probe": "across"}, )" + needle(-10) + ", " + missedOnce(needle(0)) +
                            R"(, {"aspirate": true}, {"advance_mm": 23}, {"wait_s": 1})");
  const double last_mm = kVein_mm - kSkin_mm;                      // 7.278
  const double path_mm = 15 - kSkin_mm + 15 + kBack_mm + last_mm;  // 7.245 + 15.3 + 7.278 = 29.823
  const double toAccess_mm = 15 - kSkin_mm + 20 + 5 + kVein_mm;    // 7.245 + 20 + 20.033 = 47.278
  expectMetrics(outcome.metrics,
                {{{1},
                  {0},
                  {0},
                  {last_mm / 10, kTicks_s},
                  {1},
                  {toAccess_mm / 10, kTicks_s},
                  /* 20 + 20 + 23 mm, 1 s, and a tick as the needle is put down again */ {7.301, kTicks_s},
                  {2},
                  {0},
                  {0},
                  {0},
                  {path_mm, kTurn_mm},
                  /* 100 (29.823 / 7.278 - 1) */ {100 * (path_mm / last_mm - 1), 100 * kTurn_mm / last_mm},
                  {0, kWay_mm},
                  {90, 1},
                  {100},
                  /* 15.033 of 15 + 15.033 */ {100 * kVein_mm / (15 + kVein_mm), 2 * share(15 + kVein_mm)},
                  {0, kMiddle_mm},
                  {1},
                  {std::hypot(10.5, 2), kEdge_mm},
                  {22, kWall_mm},
                  {0},
                  {0},
                  {0},
                  kMissing,
                  kMissing}});
}

/// The same with a new needle, and the probe moved by 4 mm at 100 mm/s in between.
TEST_F(MetricsByHand, TwoPasses) {
  const auto outcome =
      play(R"({"probe": "across"}, )" + needle(-10) + ", " +
           missedOnce(R"({"replace_needle": true}, {"move_probe_mm": [4, 0, 0], "speed_mmps": 100}, )" + needle(0)) +
           R"(, {"aspirate": true}, {"advance_mm": 23}, {"wait_s": 1})");
  const double last_mm = kVein_mm - kSkin_mm;
  const double path_mm = 15 - kSkin_mm + 15 + kBack_mm + last_mm;
  const double toAccess_mm = 15 - kSkin_mm + 20 + 5 + kVein_mm;
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {last_mm / 10, kTicks_s},
                                   {0},
                                   /* and 0.04 s of the probe's way */ {toAccess_mm / 10 + 0.04, kTicks_s},
                                   {7.341, kTicks_s},
                                   {2},
                                   {0},
                                   {0},
                                   {0},
                                   {path_mm, kTurn_mm},
                                   {100 * (path_mm / last_mm - 1), 100 * kTurn_mm / last_mm},
                                   {0, kWay_mm},
                                   {90, 1},
                                   {100},
                                   {100 * kVein_mm / (15 + kVein_mm), 2 * share(15 + kVein_mm)},
                                   {0, kMiddle_mm},
                                   {1},
                                   {std::hypot(10.5, 2), kEdge_mm},
                                   {22, kWall_mm},
                                   /* probe's path, in steps of 1 mm */ {4, 1},
                                   /* one fast movement */ {1},
                                   {0},
                                   kMissing,
                                   kMissing}});
}

/// To 12 mm, back by 4, on by 4, and out: one redirection.
TEST_F(MetricsByHand, Abandoned) {
  const auto outcome = play(R"({"probe": "across"}, )" + needle(0) +
                                R"(, {"aspirate": true}, {"advance_mm": 17}, {"withdraw_mm": 4}, {"advance_mm": 4},
                                   {"withdraw_mm": 17}, {"probe": null})",
                            R"("abandoned": true, )");
  EXPECT_EQ(outcome.status, AttemptStatus::Abandoned);
  expectMetrics(outcome.metrics,
                {{{0},
                  {0},
                  {0},
                  kMissing,
                  {0},
                  kMissing,
                  /* 17 + 4 + 4 + 17 mm */ {4.2, kTicks_s},
                  {1},
                  {1},
                  {0},
                  {0},
                  /* 12 - 7.755, 4, 4, 12.3, with three turns */ {12 - kSkin_mm + 8 + 12 + kBack_mm, 3 * kTurn_mm},
                  kMissing,
                  kMissing,
                  {90, 1},
                  {100},
                  {100},
                  kMissing,
                  {0},
                  /* artery: 10.5 aside, 19.5 - 11.5 deeper */ {std::hypot(10.5, 8), kEdge_mm},
                  /* lung: 39.5 - 11.5 */ {28, kWall_mm},
                  {0},
                  {0},
                  {0},
                  kMissing,
                  kMissing}});
  EXPECT_EQ(outcome.run.metrics().needle(), NeedlePlace::Used);
}

/// The probe shows z = 0; the needle goes in at z = 10.
TEST_F(MetricsByHand, NeverInThePicture) {
  const auto outcome =
      play(R"({"probe": "across"}, )" + needle(0, 10) + R"(, {"aspirate": true}, {"advance_mm": 23}, {"wait_s": 1})");
  const double toAccess_mm = kVein_mm - kSkin_mm;
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {toAccess_mm / 10, kTicks_s},
                                   {0},
                                   {toAccess_mm / 10, kTicks_s},
                                   /* 23 mm, 1 s */ {3.3, kTicks_s},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {toAccess_mm, kWay_mm},
                                   {0, 0.1},
                                   {0, kWay_mm},
                                   {90, 1},
                                   {0},
                                   {100},
                                   {0, kMiddle_mm},
                                   {1},
                                   {std::hypot(10.5, 2), kEdge_mm},
                                   {22, kWall_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kMissing,
                                   kMissing}});
}

/// At x = -20, until 2 mm after the bone was met 30 mm deep, and out.
TEST_F(MetricsByHand, Bone) {
  const auto outcome = play(R"({"probe": "across"}, {"move_probe_mm": [-10, 0, 0]}, )" + needle(-20) +
                            R"(, {"advance_mm": 37}, {"wait_s": 1}, {"withdraw_mm": 37})");
  expectMetrics(outcome.metrics,
                {{{0},
                  {0},
                  {0},
                  kMissing,
                  {0},
                  kMissing,
                  /* 10 + 37 + 37 mm, 1 s; the probe moves before the needle is there */ {9.4, kTicks_s},
                  {1},
                  {0},
                  {0},
                  {1},
                  /* 32 - 7.755 in, 32.3 out */ {32 - kSkin_mm + 32 + kBack_mm, kTurn_mm},
                  kMissing,
                  kMissing,
                  {90, 1},
                  {100},
                  {0},
                  kMissing,
                  {0},
                  /* artery: 20 + 10.5 aside */ {30.5, kWall_mm},
                  /* lung: -14.5 + 20 aside, 39.5 - 31.5 deeper */ {std::hypot(5.5, 8), kEdge_mm},
                  {0},
                  {0},
                  {0},
                  kMissing,
                  kMissing}});
}

/// Through the vein and into the lung, 45 mm deep, and out.
TEST_F(MetricsByHand, Pneumothorax) {
  const auto outcome = play(R"({"probe": "across"}, )" + needle(0) + R"(, {"advance_mm": 50}, {"withdraw_mm": 50})",
                            R"("procedure": "subclavian", )");
  const double toAccess_mm = kVein_mm - kSkin_mm;
  expectMetrics(outcome.metrics,
                {{{1},
                  {0},
                  {1},
                  {toAccess_mm / 10, kTicks_s},
                  {0},
                  {toAccess_mm / 10, kTicks_s},
                  /* 50 + 50 mm */ {10, kTicks_s},
                  {1},
                  {0},
                  /* at 40 + 2.492 */ {1},
                  {0},
                  {toAccess_mm, kWay_mm},
                  {0, 0.1},
                  {0, kWay_mm},
                  {90, 1},
                  {100},
                  {0},
                  /* it never rests: at the puncture, 15.033 deep, with the middle at 18 */ {18 - kVein_mm, kMiddle_mm},
                  {0},
                  {10.5, kWall_mm},
                  /* lung: the tip at 44.5 is 5 within */ {-5, kWall_mm},
                  {0},
                  {0},
                  {0},
                  kMissing,
                  kMissing}});
  const auto& rules = outcome.run.procedure().rules;
  EXPECT_TRUE(std::ranges::any_of(outcome.run.findings(), [&](const ProcedureRun::Finding& finding) {
    return rules[finding.rule].name == "lung" && rules[finding.rule].severity == Severity::Critical;
  }));
  EXPECT_FALSE(outcome.run.succeeded());
}

/// The probe goes away when the tip is 10 mm deep.
TEST_F(MetricsByHand, ProbeLifted) {
  const auto outcome =
      play(R"({"probe": "across"}, )" + needle(0) +
           R"(, {"aspirate": true}, {"advance_mm": 15}, {"probe": null}, {"advance_mm": 8}, {"wait_s": 1})");
  const double toAccess_mm = kVein_mm - kSkin_mm;
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {toAccess_mm / 10, kTicks_s},
                                   {0},
                                   {toAccess_mm / 10, kTicks_s},
                                   {3.3, kTicks_s},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {toAccess_mm, kWay_mm},
                                   {0, 0.1},
                                   {0, kWay_mm},
                                   {90, 1},
                                   /* 10 of 15.033 */ {100 * 10 / kVein_mm, 2 * share(kVein_mm)},
                                   {100},
                                   {0, kMiddle_mm},
                                   {1},
                                   {std::hypot(10.5, 2), kEdge_mm},
                                   {22, kWall_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kMissing,
                                   kMissing}});
}

}  // namespace
}  // namespace insonate
