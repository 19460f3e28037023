#include <insonate/cases/StartPose.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

constexpr double kStep_mm = 0.2;
constexpr int kBodyHu = -300;  // between air and fat

/// Answers whether a patient position lies in the body.
class Body {
 public:
  explicit Body(const PatientCase& patient)
      : patient_(patient),
        indexFromPatient_(patient.ct.geometry.indexFromPatient()),
        labelled_(std::ranges::any_of(patient.labels.voxels, [](std::uint8_t v) { return v != 0; })) {}

  bool contains(Vec3 p_mm) const {
    const Vec3 index = indexFromPatient_ * p_mm;
    if (labelled_) return sampleNearest(patient_.labels, index) != 0;
    return inGrid(p_mm) && sampleLinear(patient_.ct, index) > kBodyHu;
  }
  bool inGrid(Vec3 p_mm) const {
    const Vec3 index = indexFromPatient_ * p_mm;
    for (int a = 0; a < 3; ++a)
      if (!(index[a] >= -0.5 && index[a] <= patient_.ct.geometry.size[a] - 0.5)) return false;
    return true;
  }
  /// Air this wide is outside the patient. Without labels the windpipe looks like outside, and is up to 25 mm wide.
  double outsideWidth_mm() const { return labelled_ ? 5 : 30; }

 private:
  const PatientCase& patient_;
  Transform indexFromPatient_;
  bool labelled_;
};

/// Length of a grid's diagonal: no ray is longer.
double diagonal_mm(const VolumeGeometry& g) {
  return norm({g.size[0] * g.spacing_mm.x, g.size[1] * g.spacing_mm.y, g.size[2] * g.spacing_mm.z});
}

/// Distance from a place in the body to the last of it along a ray, just before air that is wide enough. Nothing when
/// the ray leaves the volume inside the body: there is no skin there.
std::optional<double> depthOfSkin_mm(const Body& body, Vec3 from_mm, Vec3 outward, double longest_mm) {
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

/// The nearest skin is where the line to the target meets it squarely.
std::optional<StartPose> overTarget(const Body& body, const Target& target, double longest_mm) {
  std::optional<StartPose> best;
  double nearest_mm = longest_mm;
  for (int degrees = -60; degrees <= 60; degrees += 2) {
    const double angle = degrees * std::numbers::pi / 180;
    const Vec3 outward{std::sin(angle), -std::cos(angle), 0};
    const auto depth = depthOfSkin_mm(body, target.position_mm, outward, longest_mm);
    if (!depth || *depth >= nearest_mm) continue;
    nearest_mm = *depth;
    best = poseAt("over " + (target.name.empty() ? "the target" : target.name), target.position_mm + *depth * outward,
                  -outward);
  }
  return best;
}

/// From the front, at the middle of the volume: the first place that is followed by 10 mm of body, which a blanket or
/// a tube is not.
std::optional<StartPose> onFront(const Body& body, const VolumeGeometry& g) {
  const double reach_mm = diagonal_mm(g) / 2;
  constexpr int kThick = static_cast<int>(10 / kStep_mm);
  for (double aside_mm : {0.0, 20.0, -20.0, 40.0, -40.0, 60.0, -60.0}) {
    const Vec3 middle = g.centre_mm() + Vec3{aside_mm, 0, 0};
    int thick = 0;
    for (double s = -reach_mm; s < reach_mm; s += kStep_mm) {
      thick = body.contains(middle + Vec3{0, s, 0}) ? thick + 1 : 0;
      if (thick == kThick) {
        const Vec3 surface = middle + Vec3{0, s - (kThick - 1) * kStep_mm, 0};
        if (!body.inGrid(surface - Vec3{0, 2 * kStep_mm, 0})) break;  // the volume's edge, not skin
        return poseAt("front", surface, {0, 1, 0});
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Result<StartPose> proposeStartPose(const PatientCase& patient) {
  if (patient.labels.geometry.size != patient.ct.geometry.size)
    return fail("The CT and the labels are on different grids; there is no telling where the skin is.");
  const Body body(patient);
  if (!patient.manifest.targets.empty()) {
    const Target& target = patient.manifest.targets.front();
    if (auto pose = overTarget(body, target, diagonal_mm(patient.ct.geometry))) return *pose;
    return fail("No skin was found in front of the target \"" + target.name +
                "\" within the volume. Correct its position or give a start pose in case.json.");
  }
  if (auto pose = onFront(body, patient.ct.geometry)) return *pose;
  return fail("No skin was found at the front of the volume's middle. Give a start pose in case.json.");
}

Result<StartPose> autoStartPose(const PatientCase& patient) {
  if (!patient.manifest.startPoses.empty()) return patient.manifest.startPoses.front();
  return proposeStartPose(patient);
}

}  // namespace insonate
