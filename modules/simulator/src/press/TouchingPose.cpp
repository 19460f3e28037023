#include "press/ScenePlane.h"

#include <insonate/cases/TissueLabels.h>
#include <insonate/deformation/FaceProfile.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/TouchingPose.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace insonate {
namespace {

constexpr double kFarGap_mm = std::numeric_limits<double>::infinity();

ImagingSetup touchingSetup() {
  // All presets are compiled in.
  ImagingSetup setup;
  setup.probe = loadProbe("linear").value();
  setup.settings = settingsFor(setup.probe);
  setup.tissues = loadAcousticTable(acousticPresetNames().front()).value();
  return setup;
}

Vec3 rotated(Vec3 v, Vec3 axis, double degrees) {
  const double a = degrees * std::numbers::pi / 180;
  return v * std::cos(a) + cross(axis, v) * std::sin(a) + axis * (dot(axis, v) * (1 - std::cos(a)));
}

Transform shiftedAlong(const Transform& patientFromProbe, double z_mm) {
  return {patientFromProbe.linear, patientFromProbe * Vec3{0, 0, z_mm}};
}

/// Motion of a pose that keeps its target in the image plane.
struct Motion {
  double swing_deg = 0;  ///< about the lateral axis through the target: around the vessel, or along it
  double rock_deg = 0;   ///< about the elevation axis through the target
  double turn_deg = 0;   ///< about the beam through the target
  double slide_mm = 0;   ///< along the image

  /// Distance from the unmoved pose, in our choice of units: a millimeter of indentation costs as much as 2.
  double cost() const {
    return std::abs(swing_deg) / 15 + std::abs(rock_deg) / 8 + std::abs(turn_deg) / 6 + std::abs(slide_mm) / 6;
  }
};

std::vector<Motion> allMotions() {
  std::vector<Motion> all;
  for (const double swing : {0., -6., 6., -12., 12., -18., 18., -24., 24., -30., 30.})
    for (const double rock : {0., -4., 4., -8., 8., -12., 12., -16., 16., -20., 20.})
      for (const double turn : {0., -8., 8.})
        for (const double slide : {0., -6., 6., -12., 12.}) all.push_back({swing, rock, turn, slide});
  return all;
}

/// A pose on the skin whose face is indented by as much as its contact needs.
struct Seat {
  Transform pose;
  double indentation_mm = 0;  ///< depth of the face below first contact
  double touching = 0;        ///< share of the array that touches undeformed skin
  double cost = 0;
};

/// Skin and tissue of one target, in a scene around its poses.
class Skin {
 public:
  Skin(const LabelMap& labels, const ImagingSetup& setup, std::shared_ptr<const AcousticScene> scene,
       CompressedTissue tissue)
      : labels_(labels),
        indexFromPatient_(labels.geometry.indexFromPatient()),
        scene_(std::move(scene)),
        tissue_(std::move(tissue)),
        plane_(deformationWindow(setup.probe, setup.settings, setup.mechanics)),
        face_(probeFaceOf(setup.probe, setup.mechanics)),
        halfArray_mm_(setup.probe.width_mm / 2),
        pressure_(bloodPressure({}, setup.mechanics.tissues)) {
    constexpr double kColumn_mm = 1;
    for (double x = -std::floor(face_.reach_mm()); x <= face_.reach_mm(); x += kColumn_mm) columns_mm_.push_back(x);
    for (const double x : columns_mm_)
      for (int row = 0; row < kRows; ++row) points_.push_back({float(x), float(rowAt(row))});
    samples_.resize(points_.size());
  }

  std::optional<Seat> seat(const StartPose& start, Vec3 target_mm, const Motion& motion);
  ProbeTouch measure(const Transform& pose);

 private:
  static constexpr int kRows = 41;
  static double rowAt(int row) { return row - kRows / 2; }

  std::uint8_t labelAt(Vec3 patient_mm) const { return sampleNearest(labels_, indexFromPatient_ * patient_mm); }
  std::optional<Vec3> skinOver(Vec3 place_mm, Vec3 axial) const;
  void findGaps(const Transform& pose);

  const LabelMap& labels_;
  Transform indexFromPatient_;
  std::shared_ptr<const AcousticScene> scene_;
  CompressedTissue tissue_;
  press::ScenePlane plane_;
  FaceProfile face_;
  double halfArray_mm_;
  BloodPressure pressure_;
  std::vector<double> columns_mm_, gaps_mm_;  ///< columns of the face, and the gap between face and skin in each
  std::vector<PlanePoint> points_;
  std::vector<PlaneTissue> samples_;
};

/// The skin in front of a place; empty if bone or air lies between, or if there is no skin within the volume.
std::optional<Vec3> Skin::skinOver(Vec3 place_mm, Vec3 axial) const {
  constexpr double kStep_mm = 0.25, kFarthest_mm = 80, kOutside_mm = 5;
  double inside_mm = 0;
  for (double s = 0; s < kFarthest_mm; s += kStep_mm) {
    const std::uint8_t label = labelAt(place_mm - s * axial);
    if (label == kBone || label == kAirway) return std::nullopt;
    if (label != kBackground)
      inside_mm = s;
    else if (s - inside_mm > kOutside_mm)
      return place_mm - inside_mm * axial;
  }
  return std::nullopt;
}

void Skin::findGaps(const Transform& pose) {
  plane_.look(*scene_, pose);
  plane_.sample(points_, samples_);
  gaps_mm_.assign(columns_mm_.size(), kFarGap_mm);
  for (std::size_t c = 0; c < columns_mm_.size(); ++c)
    for (int row = 0; row + 1 < kRows; ++row) {
      const float here = samples_[c * kRows + std::size_t(row)].skin_mm;
      const float next = samples_[c * kRows + std::size_t(row) + 1].skin_mm;
      if (!(here >= 0 && next < 0)) continue;
      const double skin_mm = rowAt(row) + here / (here - next);
      const double gap_mm = skin_mm - face_.at(float(columns_mm_[c])).z_mm;
      // A chin or a fold may lie above the face: the skin nearest to the face counts.
      if (std::abs(gap_mm) < std::abs(gaps_mm_[c])) gaps_mm_[c] = gap_mm;
    }
}

std::optional<Seat> Skin::seat(const StartPose& start, Vec3 target_mm, const Motion& motion) {
  Vec3 x = start.lateral, z = rotated(start.axial, start.lateral, motion.swing_deg);
  const Vec3 y = cross(z, x);
  x = rotated(x, y, motion.rock_deg), z = rotated(z, y, motion.rock_deg);
  x = rotated(x, z, motion.turn_deg);
  const auto skin_mm = skinOver(target_mm + motion.slide_mm * x, z);
  if (!skin_mm || !skinOver(target_mm, z)) return std::nullopt;
  const Transform onSkin{{{x, cross(z, x), z}}, *skin_mm};
  findGaps(onSkin);
  const double touch_mm = std::ranges::min(gaps_mm_);
  if (!std::isfinite(touch_mm)) return std::nullopt;
  std::vector<double> array;
  for (std::size_t c = 0; c < columns_mm_.size(); ++c)
    if (std::abs(columns_mm_[c]) <= halfArray_mm_) array.push_back(gaps_mm_[c] - touch_mm);
  std::ranges::sort(array);
  const double far_mm = array[std::size_t(std::ceil(ProbeTouch::kMinTouching * double(array.size()))) - 1];
  // Deeper than this, the probe no longer rests on the skin.
  constexpr double kMaxIndentation_mm = 3;
  Seat seat;
  seat.indentation_mm = std::clamp(far_mm - ProbeTouch::kGel_mm, 0.0, kMaxIndentation_mm);
  seat.pose = shiftedAlong(onSkin, touch_mm + seat.indentation_mm);
  const auto touches = [&](double gap_mm) { return gap_mm - seat.indentation_mm <= ProbeTouch::kGel_mm + 1e-9; };
  seat.touching = double(std::ranges::count_if(array, touches)) / double(array.size());
  constexpr double kPerIndentation = 2, kPerDepth = 0.3, kPerLost = 20;
  seat.cost = motion.cost() + kPerIndentation * seat.indentation_mm +
              kPerDepth * norm(*skin_mm - motion.slide_mm * x - target_mm) +
              kPerLost * std::max(0.0, ProbeTouch::kMinTouching - seat.touching);
  return seat;
}

ProbeTouch Skin::measure(const Transform& pose) {
  tissue_.release();
  tissue_.hold(*scene_, pose, pressure_);
  const Deformation& answer = tissue_.deformation();
  ProbeTouch touch;
  // A solution that does not converge stands for a compression without an equilibrium.
  touch.force_N = answer.converged ? answer.force_N : std::numeric_limits<double>::infinity();
  for (const LumenArea& lumen : answer.lumens)
    if (lumen.label == kVein && lumen.rest_mm2 > 0) touch.vein = lumen.area_mm2 / lumen.rest_mm2;
  int touching = 0, all = 0;
  if (answer.moved) {
    // The top row of the mesh is the displaced skin.
    for (int c = 0; c < answer.meshColumns; ++c) {
      const MeshNode& node = answer.mesh[std::size_t(c)];
      if (std::abs(node.x_mm) > halfArray_mm_) continue;
      ++all, touching += node.z_mm - face_.at(node.x_mm).z_mm <= ProbeTouch::kGel_mm;
    }
  } else {
    findGaps(pose);
    for (std::size_t c = 0; c < columns_mm_.size(); ++c)
      if (std::abs(columns_mm_[c]) <= halfArray_mm_) ++all, touching += gaps_mm_[c] <= ProbeTouch::kGel_mm;
  }
  touch.touching = all > 0 ? double(touching) / all : 0;
  return touch;
}

Transform poseOf(const StartPose& pose) {
  return patientFromProbe(pose.position_mm, pose.axial, pose.lateral).value_or(Transform{});
}

Region around(const Region& a, const Region& b) {
  Region both = a;
  for (int axis = 0; axis < 3; ++axis) {
    both.low_mm[axis] = std::min(a.low_mm[axis], b.low_mm[axis]);
    both.high_mm[axis] = std::max(a.high_mm[axis], b.high_mm[axis]);
  }
  return both;
}

/// Makes the skin around a pose and its motions; `reach_mm`: how far the motions carry the probe.
Result<Skin> skinAround(const SceneSource& source, const LabelMap& labels, const StartPose& pose, double reach_mm) {
  const ImagingSetup setup = touchingSetup();
  Region region = sceneRegion(setup, poseOf(pose), reach_mm);
  const Vec3 reach{reach_mm, reach_mm, reach_mm};
  region = around(region, {region.low_mm - reach, region.high_mm + reach});
  auto scene = makeScene(source, setup, region);
  if (!scene) return tl::unexpected(scene.error());
  auto tissue = CompressedTissue::make(setup.probe, setup.settings, setup.mechanics, 0, true);
  if (!tissue) return tl::unexpected(tissue.error());
  return Skin(labels, setup, std::move(*scene), std::move(*tissue));
}

/// The nearest pose at which the probe touches lightly; without one, the pose with the best contact.
struct Fitted {
  StartPose pose;
  ProbeTouch touch;
};

/// Badness of a contact that is not light.
double excess(const ProbeTouch& touch) {
  return std::max(0.0, ProbeTouch::kMinTouching - touch.touching) +
         std::max(0.0, touch.force_N / ProbeTouch::kMaxForce_N - 1) + std::max(0.0, ProbeTouch::kMinVein - touch.vein);
}

Fitted fitted(Skin& skin, const StartPose& start, Vec3 target_mm) {
  Fitted best{start, skin.measure(poseOf(start))};
  if (best.touch.isLight()) return best;
  std::vector<Seat> seats;
  for (const Motion& motion : allMotions())
    if (const auto seat = skin.seat(start, target_mm, motion)) seats.push_back(*seat);
  std::ranges::stable_sort(seats, {}, &Seat::cost);
  constexpr std::size_t kTried = 16;
  seats.resize(std::min(seats.size(), kTried));
  for (const Seat& seat : seats) {
    const ProbeTouch touch = skin.measure(seat.pose);
    if (excess(touch) >= excess(best.touch)) continue;
    best = {toStartPose(seat.pose), touch};
    best.pose.name = start.name;
    if (touch.isLight()) break;
  }
  return best;
}

std::string percentText(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

std::string noteAbout(const Fitted& fit) {
  std::array<char, 24> force;
  std::snprintf(force.data(), force.size(), "%.1f N", fit.touch.force_N);
  return "The start pose \"" + fit.pose.name +
         "\" is a compromise, since the skin is curved there: " + percentText(fit.touch.touching) +
         " of the face touch, with " + (std::isfinite(fit.touch.force_N) ? force.data() : "a large force") +
         ", and the vein keeps " + percentText(fit.touch.vein) +
         " of its area. Check the pose in the ultrasound image, or set another one.";
}

/// The target over which a pose lies.
std::optional<Vec3> targetUnder(const StartPose& pose, const std::vector<Target>& targets) {
  std::optional<Vec3> nearest;
  double nearest_mm = std::numeric_limits<double>::infinity();
  for (const Target& target : targets) {
    const Vec3 to = target.position_mm - pose.position_mm;
    const double off_mm = norm(to - dot(to, pose.axial) * pose.axial);
    if (dot(to, pose.axial) > 0 && off_mm < nearest_mm) nearest = target.position_mm, nearest_mm = off_mm;
  }
  return nearest;
}

}  // namespace

Result<ProbeTouch> touchAt(const CaseView& patient, const StartPose& pose) {
  const auto tissues = withTissueLabels(patient.manifest.ownLabels, patient.labels);
  const LabelMap& labels = tissues ? *tissues : patient.labels;
  const auto source = makeSceneSource({patient.manifest, patient.ct, labels});
  if (!source) return tl::unexpected(source.error());
  auto skin = skinAround(**source, labels, pose, 0);
  if (!skin) return tl::unexpected(skin.error());
  return skin->measure(poseOf(pose));
}

Result<PlaceProposal> proposeTouchingPlaces(const CaseView& patient, const Progress& progress) {
  auto proposal = proposePlaces(patient, progress);
  if (!proposal || proposal->startPoses.empty()) return proposal;
  const auto tissues = withTissueLabels(patient.manifest.ownLabels, patient.labels);
  const LabelMap& labels = tissues ? *tissues : patient.labels;
  const auto source = makeSceneSource({patient.manifest, patient.ct, labels});
  if (!source) return tl::unexpected(source.error());
  std::vector<Target> targets = patient.manifest.targets;
  targets.insert(targets.end(), proposal->targets.begin(), proposal->targets.end());
  std::size_t done = 0;
  for (StartPose& pose : proposal->startPoses) {
    if (!report(progress, "Placing the probe: " + pose.name, double(done++) / double(proposal->startPoses.size())))
      return fail(std::string(kCancelled));
    constexpr double kReach_mm = 20;
    const auto target_mm = targetUnder(pose, targets);
    auto skin = skinAround(**source, labels, pose, kReach_mm);
    if (!target_mm || !skin) continue;
    Fitted fit = fitted(*skin, pose, *target_mm);
    if (!fit.touch.isLight()) proposal->notes.push_back(noteAbout(fit));
    pose = std::move(fit.pose);
  }
  return proposal;
}

}  // namespace insonate
