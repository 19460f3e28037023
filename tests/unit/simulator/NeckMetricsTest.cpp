#include "MetricsByHand.h"
#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

using test::bend_mm;
using test::expectMetrics;
using test::kMissing;

/// Where a straight needle meets walls: mm from where its tip begins, along it, looked up voxel by voxel in the label
/// map, which is all that is asked here about the case.
struct Way {
  const PatientCase& patient;
  Vec3 from_mm, axis;

  std::uint8_t labelAt(double s_mm) const { return labelAt(from_mm + axis * s_mm); }
  std::uint8_t labelAt(Vec3 patient_mm) const {
    return sampleNearest(patient.labels, patient.labels.geometry.indexFromPatient() * patient_mm);
  }
  /// The first place from `after_mm` on where what lies there is this label, or is not.
  double until(Label label, bool isThere = true, double after_mm = 0) const {
    double s_mm = after_mm;
    while (s_mm < 100 && (labelAt(s_mm) == label) != isThere) s_mm += 0.02;
    return s_mm;
  }
  double skin_mm() const { return until(kBackground, false); }
  /// Least distance of the voxels of a structure from the needle's tip on a part of its way; they are 0.5 mm wide.
  double nearest_mm(Label label, double first_mm, double last_mm) const {
    const VolumeGeometry& g = patient.labels.geometry;
    const Transform patientFromIndex = g.patientFromIndex();
    double least_mm = 1e9;
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          if (patient.labels.at(i, j, k) != label) continue;
          const Vec3 off = patientFromIndex * Vec3{double(i), double(j), double(k)} - from_mm;
          const double along_mm = std::clamp(dot(off, axis), first_mm, last_mm);
          least_mm = std::min(least_mm, norm(off - axis * along_mm));
        }
    return least_mm - 0.25;
  }
  /// Between needle and the plane through the skin 3 mm about its entry.
  double angle_deg() const {
    const Vec3 entry = from_mm + axis * skin_mm();
    Vec3 outward;
    for (int n = 0; n < 400; ++n) {  // directions all over a sphere; those that end in air point outwards
      const double z = (n + 0.5) / 200 - 1, turn = n * 2.399963;
      const Vec3 way{std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
      if (labelAt(entry + way * 3) == kBackground) outward = outward + way;
    }
    return std::asin(-dot(normalized(outward), axis)) * 180 / std::numbers::pi;
  }
};

// Why values may be off.
constexpr double kVoxels_mm = 0.8;  // walls lie within a voxel of 0.5 x 0.5 x 0.75 mm, met aslant
constexpr double kVoxels_s = 0.1;   // the same at 10 mm/s, at one wall and at the other
constexpr double kMiddle_mm = 0.6;  // the needle aims at the model's middle of a vein, whose walls are uneven
constexpr double kSlant_deg = 6;    // of uneven skin
constexpr double kForce_N = 10;     // the probe's force is the tissue's, which is not worked out here

/// The probe lies against the skin: it presses with some force, whichever.
const test::MetricByHand kSomeForce{0, kForce_N};

class NeckMetrics : public testing::Test {
 protected:
  SessionOutcome play(const char* name, const PatientCase& patient) {
    auto outcome = runSession(*loadSessionScript(name, patient), patient, "insonate test", folder / name, {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  /// A point in the frame of a start pose, after the probe was moved in it.
  static Vec3 inProbe(const PatientCase& patient, std::size_t pose, Vec3 point_mm) {
    const StartPose& start = patient.manifest.startPoses[pose];
    return *patientFromProbe(start.position_mm, start.axial, start.lateral) * point_mm;
  }

  const test::TemporaryFolder folder;
};

/// In the plane, which was moved by 3.2 mm; 32 mm on at 10 mm/s, back and out.
TEST_F(NeckMetrics, CleanSuccess) {
  const PatientCase patient = *makePhantom("textbook", 1);
  const auto outcome = play("clean-success", patient);
  const Vec3 from = inProbe(patient, 1, {-22.7, 3.2, -4}), vein = patient.manifest.targets[0].position_mm;
  const Way way{patient, from, normalized(vein - from)};
  const double skin = way.skin_mm(), front = way.until(kVein), in = skin + bend_mm(kSkin);
  ASSERT_GT(way.until(kVein, false, front), 32) << "the needle stops before the back wall";
  const double toAccess_mm = front + bend_mm(kVein) - in;
  expectMetrics(outcome.metrics, {{/* vein, artery, double */ {1},
                                   {0},
                                   {0},
                                   /* time to vein */ {toAccess_mm / 10, kVoxels_s},
                                   /* used needle */ {0},
                                   /* time to access */ {toAccess_mm / 10, kVoxels_s},
                                   /* attempt: waits of 1, 1, 1.5 and 1 s, 3.2 + 32 + 32 mm */ {11.22, 0.002},
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
                                   kSomeForce}});
}

/// The same way 46 mm on at 20 mm/s, through the back wall, and 10 back at 10 mm/s.
TEST_F(NeckMetrics, PosteriorWall) {
  const PatientCase patient = *makePhantom("textbook", 1);
  const auto outcome = play("posterior-wall", patient);
  const Vec3 from = inProbe(patient, 1, {-22.7, 3.2, -4}), vein = patient.manifest.targets[0].position_mm;
  const Way way{patient, from, normalized(vein - from)};
  const double skin = way.skin_mm(), front = way.until(kVein), back = way.until(kVein, false, front);
  const double in = skin + bend_mm(kSkin), toAccess_mm = front + bend_mm(kVein) - in;
  ASSERT_LT(back + bend_mm(kVein), 46);
  ASSERT_GT(back - 0.3, 36) << "pulled back into the vein";
  // The vein runs along the picture and rises by some degrees: as deep as it rests below the middle, less the slope.
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

/// Below the clavicle, 58 mm on at 10 mm/s: vein, its back wall, pleura, lung; and out again.
TEST_F(NeckMetrics, Pneumothorax) {
  const PatientCase patient = *makePhantom("subclavian", 1);
  const auto outcome = play("pneumothorax", patient);
  const Vec3 from = inProbe(patient, 1, {0, 0, -5}), to = inProbe(patient, 1, {9, 0, 45});
  const Way way{patient, from, normalized(to - from)};
  const double skin = way.skin_mm(), front = way.until(kVein), back = way.until(kVein, false, front);
  const double lung = way.until(kAirway), in = skin + bend_mm(kSkin), toAccess_mm = front + bend_mm(kVein) - in;
  ASSERT_LT(back, lung);
  ASSERT_LT(lung + bend_mm(kAirway), 58);
  // At the puncture the tip is 3 mm behind the front wall of a vein 12 mm wide, met at 80 degrees.
  const double fromMiddle_mm = (back - front) / 2 - bend_mm(kVein);
  expectMetrics(outcome.metrics, {{{1},
                                   {0},
                                   {1},
                                   {toAccess_mm / 10, kVoxels_s},
                                   {0},
                                   {toAccess_mm / 10, kVoxels_s},
                                   /* waits of 2 and 1 s, 58 + 58 mm */ {14.6, 0.002},
                                   {1},
                                   {0},
                                   {1},
                                   {0},
                                   {toAccess_mm, kVoxels_mm},
                                   {0, 0.1},
                                   {0, 0.05},
                                   {way.angle_deg(), kSlant_deg},
                                   {100},
                                   {100},
                                   {fromMiddle_mm, kMiddle_mm},
                                   /* blood of the vein was drawn in passing only */ {0},
                                   {way.nearest_mm(kArtery, in, 58), kVoxels_mm},
                                   /* within the lung by less than the way in it, since its wall is met aslant */
                                   {-0.8 * (58 - lung), 0.2 * (58 - lung) + kVoxels_mm},
                                   {0},
                                   {0},
                                   {0},
                                   kSomeForce,
                                   kSomeForce}});
}

}  // namespace
}  // namespace insonate
