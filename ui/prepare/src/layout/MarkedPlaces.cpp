#include "MarkedPlaces.h"

namespace insonate::prepare {
namespace {

/// Sizes of marks: arm of a cross in 3D, half the face of a linear probe, and length of its direction.
constexpr double kArm_mm = 5, kHalfFace_mm = 19, kLook_mm = 25;

void mark(MarkedPlaces& all, Vec3 at_mm, const std::string& name, views::Color color) {
  all.places.push_back({at_mm, name, color});
  addCross(all.paths, at_mm, color);
}

}  // namespace

void addCross(std::vector<views::ScenePath>& paths, Vec3 at_mm, views::Color color) {
  for (const Vec3 arm : {Vec3{kArm_mm, 0, 0}, Vec3{0, kArm_mm, 0}, Vec3{0, 0, kArm_mm}})
    paths.push_back({{at_mm - arm, at_mm + arm}, color});
}

MarkedPlaces markedPlaces(const CasePlaces& places) {
  namespace theme = views::theme;
  MarkedPlaces all;
  for (const Target& target : places.targets) mark(all, target.position_mm, target.name, theme::kCaution);
  for (const Landmark& landmark : places.landmarks) mark(all, landmark.position_mm, landmark.name, theme::kText);
  for (const StartPose& pose : places.startPoses) {
    const Vec3 at_mm = pose.position_mm, half_mm = pose.lateral * kHalfFace_mm;
    all.places.push_back({at_mm, pose.name, theme::kGood});
    all.paths.push_back({{at_mm - half_mm, at_mm + half_mm}, theme::kGood});
    all.paths.push_back({{at_mm, at_mm + pose.axial * kLook_mm}, theme::kGood});
  }
  return all;
}

}  // namespace insonate::prepare
