#include "NeckAttempt.h"

#include <memory>

// Attempts on the neck that go another way than straight into the vein. All hands move at 10 mm/s.

namespace insonate {
namespace {

using namespace test;

class NeckTries : public NeckAttempt {
 protected:
  static void SetUpTestSuite() { neck_ = std::make_unique<PatientCase>(*makePhantom("textbook", 1)); }
  static void TearDownTestSuite() { neck_ = nullptr; }

  /// From one point to another of a probe's frame at its start pose.
  static Way way(const PatientCase& patient, std::size_t pose, Vec3 from_mm, Vec3 to_mm) {
    const Vec3 from = inProbe(patient, pose, from_mm);
    return {patient, from, normalized(inProbe(patient, pose, to_mm) - from)};
  }
  /// In the plane of the image along the vein, which was moved by 3.2 mm: to the vein's middle, as in CleanSuccess.
  static Way toVein() {
    const Vec3 from = inProbe(*neck_, kAlong, {-22.7, 3.2, -4});
    return {*neck_, from, normalized(neck_->manifest.targets[0].position_mm - from)};
  }
  static Transform moved(const PatientCase& patient, std::size_t pose, Vec3 by_mm) {
    Transform moved = startPose(patient, pose);
    moved.offset = moved * by_mm;
    return moved;
  }
  void expectTwoTries(const char* script, double usedNeedle, double compressing_s);

  static constexpr std::size_t kAcross = 0, kAlong = 1;
  static inline std::unique_ptr<PatientCase> neck_;
};

/// 12 mm beside the image 25 mm on and out again, undrawn; then in its plane into the vein.
void NeckTries::expectTwoTries(const char* script, double usedNeedle, double compressing_s) {
  const auto outcome = play(script, *neck_);
  const Way first = way(*neck_, kAlong, {-22.7, 15.2, -4}, {0, 15.2, 18.7}), last = toVein();
  const Transform probe = startPose(*neck_, kAlong);
  const double in_mm = first.skin_mm() + bend_mm(kSkin);
  const double lastIn_mm = last.skin_mm() - last.skinRaised_mm(probe) + bend_mm(kSkin);
  const double access_mm = last.until(kVein) - last.veinRaised_mm(probe) + bend_mm(kVein),
               there_mm = access_mm - lastIn_mm;
  const double path_mm = 25 - in_mm + 25 - first.skin_mm() + kBack_mm + there_mm;
  const double forward_mm = 25 - first.skin_mm() + access_mm - last.skin_mm();
  const double drawn = 100 * (access_mm - last.skin_mm()) / forward_mm;
  const double seen = 100 * there_mm / (25 - in_mm + 25 - first.skin_mm() + there_mm);
  const auto nearest_mm = [&](Label label) {
    return std::min(first.nearest_mm(label, in_mm, 25), last.nearest_mm(label, lastIn_mm, 32));
  };
  expectMetrics(outcome.metrics,
                {{{1},
                  {0},
                  {0},
                  {there_mm / 10, kVoxels_s},
                  {usedNeedle},
                  /* 25 on but for the way to the hole, 25 back, 1 s */
                  {(25 - in_mm + 25 + access_mm) / 10 + 1, 2 * kVoxels_s},
                  /* waits of 1, 1, 1 and 1.5 s, 3.2 + 25 + 25 + 32 mm */
                  {13.02 + compressing_s, 0.003},
                  {2},
                  {0},
                  {0},
                  {0},
                  {path_mm, 2 * kTurn_mm},
                  {100 * (path_mm / there_mm - 1), 100 * (2 * kTurn_mm + kVoxels_mm) / there_mm},
                  {0, 0.05},
                  {last.angle_deg(), kSlant_deg},
                  {seen, 4},
                  {drawn, 4},
                  {0, kMiddle_mm},
                  {1},
                  {nearest_mm(kArtery), kVoxels_mm},
                  {nearest_mm(kAirway), kVoxels_mm},
                  {0},
                  {0},
                  {0},
                  kSomeForce,
                  kSomeForce}},
                {.veinChecks = compressing_s > 0 ? 1.0 : 0.0});
}

TEST_F(NeckTries, UsedNeedle) {
  expectTwoTries("used-needle", 1, 0);
}

TEST_F(NeckTries, TwoPasses) {
  expectTwoTries("two-passes", 0, /* 3.2 + 9 + 9 mm, 1, 1.2, 0.2 and 0.3 s */ 4.82);
}

/// 18 mm on, which is before the vein, 2 s there, and out.
TEST_F(NeckTries, Abandoned) {
  const auto outcome = play("abandoned", *neck_);
  const Way in = toVein();
  const double skin_mm = in.skin_mm() - in.skinRaised_mm(startPose(*neck_, kAlong));
  const double in_mm = skin_mm + bend_mm(kSkin);
  ASSERT_GT(in.until(kVein), 18);
  expectMetrics(outcome.metrics, {{{0},
                                   {0},
                                   {0},
                                   kMissing,
                                   {0},
                                   kMissing,
                                   /* waits of 1, 1 and 2 s, 3.2 + 18 + 18 mm */ {7.92, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {18 - in_mm + 18 - skin_mm + kBack_mm, kTurn_mm},
                                   kMissing,
                                   kMissing,
                                   {in.angle_deg(), kSlant_deg},
                                   /* the skin that is drawn to the face lies on its edge */ {100, 0.2},
                                   {100},
                                   kMissing,
                                   {0},
                                   {in.nearest_mm(kArtery, in_mm, 18), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 18), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// The probe goes away 16 mm on; as far again it is blind.
TEST_F(NeckTries, ProbeLifted) {
  const auto outcome = play("probe-lifted", *neck_);
  const Way in = toVein();
  const double skin_mm = in.skin_mm() - in.skinRaised_mm(startPose(*neck_, kAlong));
  const double in_mm = skin_mm + bend_mm(kSkin);
  const double access_mm = in.until(kVein) - in.veinRaised_mm(startPose(*neck_, kAlong)) + bend_mm(kVein),
               there_mm = access_mm - in_mm;
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {there_mm / 10, kVoxels_s},
                                   {0},
                                   {there_mm / 10, kVoxels_s},
                                   /* waits of 1, 1 and 1.5 s, 3.2 + 16 + 16 mm */ {7.02, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {there_mm, kVoxels_mm},
                                   {0, 0.1},
                                   {0, 0.05},
                                   {in.angle_deg(), kSlant_deg},
                                   {100 * (16 - in_mm) / there_mm, 8},
                                   {100},
                                   {0, kMiddle_mm},
                                   {1},
                                   {in.nearest_mm(kArtery, in_mm, 32), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 32), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// Across the vein, 20 mm nearer to the head than the image: 33 mm on.
TEST_F(NeckTries, NeverInThePicture) {
  const auto outcome = play("never-in-picture", *neck_);
  const Way in = way(*neck_, kAcross, {-3.2, -36, -4}, {-3.2, -20, 18.7});
  const double in_mm = in.skin_mm() + bend_mm(kSkin), front_mm = in.until(kVein);
  const double there_mm = front_mm + bend_mm(kVein) - in_mm;
  ASSERT_GT(in.until(kVein, false, front_mm), 33) << "the needle stops before the back wall";
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {there_mm / 10, kVoxels_s},
                                   {0},
                                   {there_mm / 10, kVoxels_s},
                                   /* waits of 1, 1 and 1.5 s, 3.2 + 33 mm */ {7.12, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {there_mm, kVoxels_mm},
                                   {0, 0.1},
                                   {0, 0.05},
                                   {in.angle_deg(), kSlant_deg},
                                   {0},
                                   {100},
                                   {in.fromMiddle_mm(kVein, 33, {0, 0, 1}), kMiddle_mm},
                                   {1},
                                   {in.nearest_mm(kArtery, in_mm, 33), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 33), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// From below and from the middle, 55 mm on, past the vein into the artery, 1 s there, and out.
TEST_F(NeckTries, CarotidPuncture) {
  const auto outcome = play("carotid-puncture", *neck_);
  const Way in = way(*neck_, kAcross, {14.8, 33, -6}, {1.9, 0, 33});
  const double skin_mm = in.skin_mm(), in_mm = skin_mm + bend_mm(kSkin), front_mm = in.until(kArtery);
  ASSERT_LT(front_mm + bend_mm(kArtery), 55);
  ASSERT_GT(in.until(kVein), 55) << "never in the vein";
  // In, a second at its end (10 mm of way), and out to the skin.
  const Transform probe = moved(*neck_, kAcross, {-3.2, 0, 0});
  const double seen_mm = in.inPicture_mm(probe, in_mm, 55) + 1000 * in.inPicture_mm(probe, 55, 55.01) +
                         in.inPicture_mm(probe, skin_mm, 55);
  const double under_mm = 55 - in_mm + 10 + 55 - skin_mm;
  expectMetrics(outcome.metrics, {{{0},
                                   {1},
                                   {0},
                                   kMissing,
                                   {0},
                                   kMissing,
                                   /* three waits of 1 s, 3.2 + 55 + 55 mm */ {14.32, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {55 - in_mm + 55 - skin_mm + kBack_mm, kTurn_mm},
                                   kMissing,
                                   kMissing,
                                   {in.angle_deg(), kSlant_deg},
                                   /* as it comes through the image, in and out */
                                   {100 * seen_mm / under_mm, 100 * 2 * kVoxels_mm / under_mm},
                                   {100},
                                   kMissing,
                                   {0},
                                   {-in.deepestIn_mm(kArtery, front_mm, 55), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 55), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// In the image's plane beside the probe, far too steep, until it meets the spine; undrawn.
TEST_F(NeckTries, Bone) {
  const auto outcome = play("bone", *neck_);
  const Way in = way(*neck_, kAcross, {-27.2, 0, -5}, {-15.2, 0, 40});
  const double skin_mm = in.skin_mm(), in_mm = skin_mm + bend_mm(kSkin), bone_mm = in.until(kBone);
  ASSERT_LT(bone_mm, 55);
  // In, a second at its end (10 mm of way), and out to the skin.
  const Transform probe = moved(*neck_, kAcross, {-3.2, 0, 0});
  const double seen_mm = in.inPicture_mm(probe, in_mm, 55) + 1000 * in.inPicture_mm(probe, 55, 55.01) +
                         in.inPicture_mm(probe, skin_mm, 55);
  const double under_mm = 55 - in_mm + 10 + 55 - skin_mm;
  expectMetrics(outcome.metrics, {{{0},
                                   {0},
                                   {0},
                                   kMissing,
                                   {0},
                                   kMissing,
                                   /* three waits of 1 s, 3.2 + 55 + 55 mm */ {14.32, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {1},
                                   {55 - in_mm + 55 - skin_mm + kBack_mm, kTurn_mm},
                                   kMissing,
                                   kMissing,
                                   {in.angle_deg(), kSlant_deg},
                                   {100 * seen_mm / under_mm, 100 * 2 * kVoxels_mm / under_mm},
                                   {0},
                                   kMissing,
                                   {0},
                                   {in.nearest_mm(kArtery, in_mm, 55), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 55), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// Below the clavicle in the plane of an image that was moved by 12 mm and pressed by 1: 55 mm on.
TEST_F(NeckTries, SubclavianSuccess) {
  const PatientCase chest = *makePhantom("subclavian", 1);
  const auto outcome = play("subclavian-success", chest);
  const Vec3 alongVein = startPose(chest, kAlong) * Vec3{1, 0, 0} - startPose(chest, kAlong).offset;
  const Vec3 from = inProbe(chest, kAlong, {-48, 0, -3});
  const Way in{chest, from, normalized(chest.manifest.targets[0].position_mm - from)};
  const double skin_mm = in.skin_mm(), in_mm = skin_mm + bend_mm(kSkin), front_mm = in.until(kVein);
  const double access_mm = front_mm + bend_mm(kVein), there_mm = access_mm - in_mm;
  // The face stands 1 mm lower than at its start pose: what lies under it gives way by as much, the needle being at 30
  // degrees to it.
  const double pressed_mm = kVoxels_mm + 1 / std::sin(std::numbers::pi / 6);
  ASSERT_GT(in.until(kVein, false, front_mm), 55) << "the needle stops before the back wall";
  const double seen_mm = in.inPicture_mm(moved(chest, kAlong, {-12, 0, 1}), in_mm, access_mm);
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {0},
                                   {there_mm / 10, pressed_mm / 10},
                                   {0},
                                   {there_mm / 10, pressed_mm / 10},
                                   /* waits of 1, 1 and 1.5 s, 12.04 + 55 mm */ {10.204, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {there_mm, pressed_mm},
                                   {0, 0.1},
                                   {0, 0.05},
                                   {in.angle_deg(), kSlant_deg},
                                   {100 * seen_mm / there_mm, 8},
                                   {100},
                                   {in.fromMiddle_mm(kVein, 55, alongVein), kMiddle_mm},
                                   {1},
                                   {in.nearest_mm(kArtery, in_mm, 55), kVoxels_mm},
                                   {in.nearest_mm(kAirway, in_mm, 55), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

}  // namespace
}  // namespace insonate
