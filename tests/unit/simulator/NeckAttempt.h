#pragma once

#include "MetricsByHand.h"
#include "support/TestData.h"

#include <insonate/cases/Phantom.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace insonate::test {

/// One of `count` directions all over a sphere, by the golden angle.
inline Vec3 onSphere(int n, int count) {
  const double z = 2 * (n + 0.5) / count - 1, turn = n * 2.399963;
  return {std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z};
}

/// Walls that a straight needle meets: mm from the place where its tip begins, along it, looked up voxel by voxel in
/// the label map, which is all that this needs of the case.
struct Way {
  /// Widening of a vein 13 mm high with the head 15 degrees down: areas grow by 18 to 48 % (Chest 2013;144:177, Anaesth
  /// Intensive Care 2008;36:65).
  static constexpr double kMinWidened_mm = 1.1, kMaxWidened_mm = 2.9;

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
    double min_mm = 1e9;
    for (int k = 0; k < g.size[2]; ++k)
      for (int j = 0; j < g.size[1]; ++j)
        for (int i = 0; i < g.size[0]; ++i) {
          if (patient.labels.at(i, j, k) != label) continue;
          const Vec3 off = patientFromIndex * Vec3{double(i), double(j), double(k)} - from_mm;
          const double along_mm = std::clamp(dot(off, axis), first_mm, last_mm);
          min_mm = std::min(min_mm, norm(off - axis * along_mm));
        }
    return min_mm - 0.25;
  }
  /// The most that the tip is within a structure on a part of its way, from the nearest voxel that is not.
  double deepestIn_mm(Label label, double first_mm, double last_mm) const {
    double max_mm = 0;
    for (double s_mm = first_mm; s_mm <= last_mm; s_mm += 0.2) {
      double wall_mm = 0;
      while (wall_mm < 10 && isAllAround(label, s_mm, wall_mm)) wall_mm += 0.1;
      max_mm = std::max(max_mm, wall_mm);
    }
    return max_mm;
  }
  /// From a place on the way to the line through the middles of a vessel's sections 4 mm on and back, for a vessel that
  /// runs about along `run`.
  double fromMiddle_mm(Label label, double s_mm, Vec3 run) const {
    const Vec3 tip = from_mm + axis * s_mm;
    const Vec3 on = middle_mm(label, tip + run * 4, run), back = middle_mm(label, tip - run * 4, run);
    return norm(cross(tip - back, normalized(on - back)));
  }
  /// Way of the tip within the image of a linear probe 38 mm wide, 40 mm deep: at most one slice thickness off its
  /// plane, which is 5.4 wavelengths at 7.5 MHz, 1.11 mm, at 20 mm, and grows by 0.085 mm per mm off that.
  double inPicture_mm(const Transform& patientFromProbe, double first_mm, double last_mm) const {
    constexpr double kStep_mm = 0.01, kFocus_mm = 5.4 * 1.54 / 7.5;
    const Transform probeFromPatient = inverted(patientFromProbe);
    const auto isShown = [&](double s_mm) {
      const Vec3 tip = probeFromPatient * (from_mm + axis * s_mm);
      return std::abs(tip.x) <= 19 && std::abs(tip.y) <= std::hypot(kFocus_mm, 0.085 * (tip.z - 20)) && tip.z >= 0 &&
             tip.z <= 40;
    };
    double way_mm = 0;
    for (double s_mm = first_mm; s_mm < last_mm; s_mm += kStep_mm) way_mm += isShown(s_mm) ? kStep_mm : 0;
    return way_mm;
  }
  /// Distance by which the needle meets the skin earlier than at rest, above a vein in the plane of a probe at this
  /// pose, head down: the vein widens, half of it or all of it upwards, and lifts the skin up to the face.
  double skinRaised_mm(const Transform& patientFromProbe) const {
    const Vec3 at = inverted(patientFromProbe) * (from_mm + axis * skin_mm());
    const double gap_mm = std::max(at.z, 0.0);
    const double min_mm = std::min(kMinWidened_mm / 2, gap_mm), max_mm = std::min(kMaxWidened_mm, gap_mm);
    return (min_mm + max_mm) / 2 / dot(axis, patientFromProbe.linear * Vec3{0, 0, 1});
  }
  /// The same for the vein's front wall: half as far as the skin, which the face holds above it.
  double veinRaised_mm(const Transform& patientFromProbe) const { return skinRaised_mm(patientFromProbe) / 2; }
  /// Between needle and the plane through the skin 7 mm about its entry.
  double angle_deg() const {
    const Vec3 entry = from_mm + axis * skin_mm();
    Vec3 outward;
    for (int n = 0; n < 400; ++n) {  // those that end in air point outwards
      const Vec3 way = onSphere(n, 400);
      if (labelAt(entry + way * 7) == kBackground) outward = outward + way;
    }
    return std::asin(-dot(normalized(outward), axis)) * 180 / std::numbers::pi;
  }

 private:
  bool isAllAround(Label label, double s_mm, double radius_mm) const {
    for (int n = 0; n < 200; ++n)
      if (labelAt(from_mm + axis * s_mm + onSphere(n, 200) * radius_mm) != label) return false;
    return true;
  }
  /// Middle of the label within 12 mm of a point, in the plane perpendicular to `run`.
  Vec3 middle_mm(Label label, Vec3 near_mm, Vec3 run) const {
    const Vec3 u = normalized(cross(run, std::abs(run.y) < 0.9 ? Vec3{0, 1, 0} : Vec3{1, 0, 0})), v = cross(run, u);
    Vec3 sum;
    int count = 0;
    for (double x = -12; x <= 12; x += 0.25)
      for (double y = -12; y <= 12; y += 0.25) {
        const Vec3 at = near_mm + u * x + v * y;
        if (std::hypot(x, y) > 12 || labelAt(at) != label) continue;
        sum = sum + at;
        ++count;
      }
    return sum * (1.0 / count);
  }
};

// Why values may be off.
inline constexpr double kVoxels_mm = 0.8;  // walls lie within a voxel of 0.5 x 0.5 x 0.75 mm, met aslant
inline constexpr double kVoxels_s = 0.1;   // the same at 10 mm/s, at one wall and at the other
inline constexpr double kMiddle_mm = 0.6;  // the needle aims at the model's middle of a vein, whose walls are uneven
inline constexpr double kTurn_mm = 1.5;    // ways are in steps of 0.5 mm: a turn loses one on either side; and a voxel
inline constexpr double kBack_mm = 0.3;    // pulled back as far behind its hole, the tip is out of it
inline constexpr double kSlant_deg = 8;    // of uneven skin
inline constexpr double kForce_N = 10;     // the probe's force is the tissue's, which is not worked out here

/// The probe lies against the skin: it presses with some force, whichever.
inline const MetricByHand kSomeForce{0, kForce_N};

class NeckAttempt : public testing::Test {
 protected:
  SessionOutcome play(const char* name, const PatientCase& patient) {
    auto outcome = runSession(*loadSessionScript(name, patient), patient, "insonate test", folder / name, {});
    if (!outcome) throw std::runtime_error(outcome.error().message);
    return std::move(*outcome);
  }
  static Transform startPose(const PatientCase& patient, std::size_t pose) {
    const StartPose& start = patient.manifest.startPoses[pose];
    return *patientFromProbe(start.position_mm, start.axial, start.lateral);
  }
  /// A point in the frame of a start pose, after the probe was moved in it.
  static Vec3 inProbe(const PatientCase& patient, std::size_t pose, Vec3 point_mm) {
    return startPose(patient, pose) * point_mm;
  }

  const TemporaryFolder folder;
};

}  // namespace insonate::test
