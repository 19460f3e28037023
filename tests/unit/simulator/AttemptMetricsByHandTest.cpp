#include "BlockAttempt.h"

namespace insonate {
namespace {

using namespace test;
using MetricsByHand = BlockAttempt;

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
                                   /* until 10 mm, from 7.755 to 15.033 */
                                   {100 * (10 - kSkin_mm) / (kVein_mm - kSkin_mm), 0.2},
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
