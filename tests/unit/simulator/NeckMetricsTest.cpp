#include "NeckAttempt.h"

namespace insonate {
namespace {

using namespace test;
using NeckMetrics = NeckAttempt;

/// In the plane, which was moved by 3.2 mm; 32 mm on at 10 mm/s, back and out.
TEST_F(NeckMetrics, CleanSuccess) {
  const PatientCase patient = *makePhantom("textbook", 1);
  const auto outcome = play("clean-success", patient);
  const Vec3 from = inProbe(patient, 1, {-22.7, 3.2, -4}), vein = patient.manifest.targets[0].position_mm;
  const Way way{patient, from, normalized(vein - from)};
  const Transform probe = startPose(patient, 1);
  const double skin = way.skin_mm(), front = way.until(kVein);
  const double in = skin - way.skinRaised_mm(probe) + bend_mm(kSkin);
  ASSERT_GT(way.until(kVein, false, front), 32) << "the needle stops before the back wall";
  const double toAccess_mm = front - way.veinRaised_mm(probe) + bend_mm(kVein) - in;
  expectMetrics(
      outcome.metrics,
      {{/* vein, artery, double */ {1},
        {0},
        {0},
        /* time to vein */ {toAccess_mm / 10, kVoxels_s},
        /* used needle */ {0},
        /* time to access */ {toAccess_mm / 10, kVoxels_s},
        /* attempt: waits of 1, 1.2, 0.2, 0.3, 1, 1, 1.5 and 1 s, 3.2 + 9 + 9 + 3.2 + 32 + 32 mm */ {16.04, 0.002},
        /* passes, redirections, lung, bone */ {1},
        {0},
        {0},
        {0},
        /* path */ {toAccess_mm, kVoxels_mm},
        /* inefficiency, deviation: straight */ {0, 0.1},
        {0, 0.05},
        /* angle */ {way.angle_deg(), kSlant_deg},
        /* tip in picture, aspiration */ {100},
        {100},
        /* it rests in the middle */ {0, kMiddle_mm},
        /* drawn back after blood was drawn */ {1},
        /* artery, lung and airway */ {way.nearest_mm(kArtery, in, 32), kVoxels_mm},
        {way.nearest_mm(kAirway, in, 32), kVoxels_mm},
        /* probe's path, translations, rotations */ {0},
        {0},
        {0},
        kSomeForce,
        kSomeForce}},
      {.veinChecks = 1});
}

/// The same way 46 mm on at 20 mm/s, through the back wall, and 10 back at 10 mm/s.
TEST_F(NeckMetrics, PosteriorWall) {
  const PatientCase patient = *makePhantom("textbook", 1);
  const auto outcome = play("posterior-wall", patient);
  const Vec3 from = inProbe(patient, 1, {-22.7, 3.2, -4}), vein = patient.manifest.targets[0].position_mm;
  const Way way{patient, from, normalized(vein - from)};
  const double skin = way.skin_mm(), front = way.until(kVein), back = way.until(kVein, false, front);
  const Transform probe = startPose(patient, 1);
  const double in = skin - way.skinRaised_mm(probe) + bend_mm(kSkin);
  const double toAccess_mm = front - way.veinRaised_mm(probe) + bend_mm(kVein) - in;
  ASSERT_LT(back + bend_mm(kVein), 46);
  ASSERT_GT(back - 0.3, 36) << "pulled back into the vein";
  // The vein runs along the image and rises by some degrees: as deep as it rests below the middle, less the slope.
  const double off_mm = norm(cross(way.axis, Vec3{0, 0, 1})) * (36 - norm(vein - from));
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {1},
                                   {toAccess_mm / 20, kVoxels_s},
                                   {0},
                                   {toAccess_mm / 20, kVoxels_s},
                                   /* waits of 1, 1, 1 and 1.5 s, 3.2 mm, 46 mm at 20 mm/s, 10 mm */ {8.12, 0.002},
                                   {1},
                                   {0},
                                   {0},
                                   {0},
                                   {toAccess_mm, kVoxels_mm},
                                   {0, 0.1},
                                   {0, 0.05},
                                   {way.angle_deg(), kSlant_deg},
                                   {100},
                                   {100},
                                   {off_mm, kMiddle_mm + 0.5},
                                   {1},
                                   {way.nearest_mm(kArtery, in, 46), kVoxels_mm},
                                   {way.nearest_mm(kAirway, in, 46), kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

/// Below the clavicle beside the probe, 64 mm on at 10 mm/s: vein, its back wall, pleura, lung; and out again.
TEST_F(NeckMetrics, Pneumothorax) {
  const PatientCase patient = *makePhantom("subclavian", 1);
  const auto outcome = play("pneumothorax", patient);
  const Vec3 from = inProbe(patient, 1, {-24, 0, -5}), to = inProbe(patient, 1, {-14, 0, 45});
  const Way way{patient, from, normalized(to - from)};
  const double skin = way.skin_mm(), front = way.until(kVein), back = way.until(kVein, false, front);
  const double lung = way.until(kAirway), in = skin + bend_mm(kSkin), toAccess_mm = front + bend_mm(kVein) - in;
  ASSERT_LT(back, lung);
  ASSERT_LT(lung + bend_mm(kAirway), 64);
  const Transform probe = startPose(patient, 1);
  const double access = front + bend_mm(kVein), in_mm = skin + bend_mm(kSkin);
  const double seen_mm = way.inPicture_mm(probe, in_mm, access);
  expectMetrics(outcome.metrics,
                {{{1},
                  {0},
                  {1},
                  {toAccess_mm / 10, kVoxels_s},
                  {0},
                  {toAccess_mm / 10, kVoxels_s},
                  /* waits of 2 and 1 s, 64 + 64 mm */ {15.8, 0.002},
                  {1},
                  {0},
                  {1},
                  {0},
                  {toAccess_mm, kVoxels_mm},
                  {0, 0.1},
                  {0, 0.05},
                  {way.angle_deg(), kSlant_deg},
                  /* from the edge of the image on; the skin and the vein a voxel off */
                  {100 * seen_mm / (access - in_mm), 200 * kVoxels_mm / (access - in_mm)},
                  {100},
                  {way.fromMiddle_mm(kVein, access, probe * Vec3{1, 0, 0} - probe.offset), kMiddle_mm},
                  /* blood of the vein was drawn in passing only */ {0},
                  {way.nearest_mm(kArtery, in, 64), kVoxels_mm},
                  /* within the lung by less than the way in it, since its wall is met aslant */
                  {-0.8 * (64 - lung), 0.2 * (64 - lung) + kVoxels_mm},
                  {0},
                  {0},
                  {0},
                  kSomeForce,
                  kSomeForce}},
                {.pneumothoraces = 1});
}

}  // namespace
}  // namespace insonate
