#include "BlockAttempt.h"

#include <algorithm>

namespace insonate {
namespace {

using namespace test;
using MetricsByHand = BlockAttempt;

/// Advances to a depth of 30 mm, and withdraws to 20.
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

/// Advances to 12 mm, withdraws 4, advances 4, and withdraws: one redirection.
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

}  // namespace
}  // namespace insonate
