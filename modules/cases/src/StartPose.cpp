#include "NeckLevel.h"

#include <insonate/cases/StartPose.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {
namespace {

constexpr double kStep_mm = 0.2;

/// Length of a grid's diagonal, the maximum length of a ray.
double diagonal_mm(const VolumeGeometry& g) {
  return norm({g.size[0] * g.spacing_mm.x, g.size[1] * g.spacing_mm.y, g.size[2] * g.spacing_mm.z});
}

/// Distance along a ray from a place in the body to its last point before a sufficiently wide layer of air. Empty if
/// the ray leaves the volume inside the body, where there is no skin.
std::optional<double> depthOfSkin_mm(const PatientBody& body, Vec3 from_mm, Vec3 outward, double longest_mm) {
  std::optional<double> lastInside;
  for (double s = 0; s < longest_mm; s += kStep_mm) {
    const Vec3 p = from_mm + s * outward;
    if (!body.inGrid(p)) return lastInside && s - *lastInside > 1.5 * kStep_mm ? lastInside : std::nullopt;
    if (body.contains(p))
      lastInside = s;
    else if (lastInside && s - *lastInside > body.outsideWidth_mm())
      return lastInside;
  }
  return std::nullopt;
}

StartPose poseAt(std::string name, Vec3 position_mm, Vec3 axial) {
  const Vec3 left{1, 0, 0};
  return {std::move(name), position_mm, axial, normalized(left - dot(left, axial) * axial)};
}

/// Share of the face of a usual linear probe that meets skin once it is pressed lightly.
double contactOf(const PatientBody& body, const StartPose& pose) {
  constexpr double kHalfFace_mm = 19, kPressed_mm = 5;
  int touching = 0, all = 0;
  for (double x_mm = -kHalfFace_mm; x_mm <= kHalfFace_mm; x_mm += 1, ++all)
    touching += body.contains(pose.position_mm + x_mm * pose.lateral + kPressed_mm * pose.axial);
  return double(touching) / all;
}

/// Among poses whose face has enough contact the first wins; else the pose with the most contact.
class PoseChoice {
 public:
  explicit PoseChoice(const PatientBody& body) : body_(body) {}

  void offer(StartPose pose) {
    const double contact = std::min(contactOf(body_, pose), kEnough);
    if (best_ && contact <= contact_) return;
    contact_ = contact;
    best_ = std::move(pose);
  }
  bool isDone() const { return best_ && contact_ >= kEnough; }
  std::optional<StartPose> best() const { return best_; }

 private:
  static constexpr double kEnough = 0.9;
  const PatientBody& body_;
  std::optional<StartPose> best_;
  double contact_ = 0;
};

/// The nearest skin is where the line to the target is perpendicular to it.
std::optional<StartPose> overTarget(const PatientBody& body, const Target& target, double longest_mm) {
  struct Way {
    double depth_mm;
    Vec3 outward;
  };
  std::vector<Way> ways;
  for (int degrees = -60; degrees <= 60; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 outward{std::sin(angle), -std::cos(angle), 0};
    if (const auto depth_mm = depthOfSkin_mm(body, target.position_mm, outward, longest_mm))
      ways.push_back({*depth_mm, outward});
  }
  std::ranges::stable_sort(ways, {}, &Way::depth_mm);
  const std::string name = "over " + (target.name.empty() ? "the target" : target.name);
  PoseChoice choice(body);
  for (const auto& [depth_mm, outward] : ways) {
    choice.offer(poseAt(name, target.position_mm + depth_mm * outward, -outward));
    if (choice.isDone()) break;
  }
  return choice.best();
}

/// The first place from the front with 10 mm of body behind it, which excludes blankets and tubes.
std::optional<Vec3> frontOfSkin(const PatientBody& body, Vec3 center_mm, double x_mm, double z_mm, double reach_mm) {
  constexpr int kThick = static_cast<int>(10 / kStep_mm);
  int thick = 0;
  for (double s = -reach_mm; s < reach_mm; s += kStep_mm) {
    thick = body.contains({x_mm, center_mm.y + s, z_mm}) ? thick + 1 : 0;
    if (thick < kThick) continue;
    const Vec3 surface{x_mm, center_mm.y + s - (kThick - 1) * kStep_mm, z_mm};
    // The edge of the volume cuts the body and is not skin.
    return body.inGrid(surface - Vec3{0, 2 * kStep_mm, 0}) ? std::optional(surface) : std::nullopt;
  }
  return std::nullopt;
}

/// Direction toward the body's share of a small ball. Along the body it is limited to 20 degrees, so that the image
/// stays transverse.
Vec3 inwardNormal(const PatientBody& body, Vec3 surface_mm) {
  constexpr int kCells = 4;
  constexpr double kCell_mm = 2, kTan20 = 0.364;
  Vec3 sum;
  for (int k = -kCells; k <= kCells; ++k)
    for (int j = -kCells; j <= kCells; ++j)
      for (int i = -kCells; i <= kCells; ++i) {
        const Vec3 offset_mm = kCell_mm * Vec3{double(i), double(j), double(k)};
        if (norm(offset_mm) <= kCells * kCell_mm && body.contains(surface_mm + offset_mm)) sum = sum + offset_mm;
      }
  const double across = std::hypot(sum.x, sum.y);
  if (!(sum.y > 0.3 * across)) return {0, 1, 0};
  return normalized({sum.x, sum.y, std::clamp(sum.z, -kTan20 * across, kTan20 * across)});
}

/// A place to the right of the midline, where the vessels of the neck are.
std::optional<StartPose> onFront(const PatientBody& body, const VolumeGeometry& g) {
  const auto [level, isNeck] = neckOrMiddle(bodyLevels(body, g));
  const Vec3 center_mm = g.center_mm();
  const double middle_mm = level.area_mm2 > 0 ? level.middle_mm : center_mm.x;
  PoseChoice choice(body);
  for (const double up_mm : {0.0, 8.0, 16.0, -8.0, 24.0, -16.0})
    for (const double aside_mm : {-25.0, -15.0, 0.0, 15.0, 25.0, -40.0, 40.0, -60.0, 60.0}) {
      const double z_mm = level.z_mm + up_mm;
      const auto skin = frontOfSkin(body, center_mm, middle_mm + aside_mm, z_mm, diagonal_mm(g));
      if (!skin) continue;
      choice.offer(poseAt(std::string(isNeck ? "front of the neck" : "front at the middle of the scan") +
                              ", z = " + std::to_string(std::lround(z_mm)) + " mm",
                          *skin, inwardNormal(body, *skin)));
      if (choice.isDone()) return choice.best();
    }
  return choice.best();
}

}  // namespace

Result<StartPose> proposeStartPoseOver(const CaseView& patient, const Target& target) {
  if (auto pose = overTarget(PatientBody(patient), target, diagonal_mm(patient.ct.geometry))) return *pose;
  return fail("No skin was found in front of the target \"" + target.name +
              "\" within the volume. Correct the position of the target, or mark a start pose.");
}

Result<StartPose> proposeStartPose(const CaseView& patient) {
  if (patient.labels.geometry.size != patient.ct.geometry.size)
    return fail("The CT and the labels are on different grids; the skin cannot be located.");
  if (!patient.manifest.targets.empty()) return proposeStartPoseOver(patient, patient.manifest.targets.front());
  const PatientBody body(patient);
  if (auto pose = onFront(body, patient.ct.geometry)) return *pose;
  return fail("No skin was found in front of the middle of the volume. Mark a start pose.");
}

Result<StartPose> autoStartPose(const CaseView& patient) {
  if (!patient.manifest.startPoses.empty()) return patient.manifest.startPoses.front();
  return proposeStartPose(patient);
}

}  // namespace insonate
