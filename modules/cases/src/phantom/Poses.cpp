#include "Poses.h"

#include <insonate/cases/Landmarks.h>

#include <cmath>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kTargetLevel_mm = 0;  ///< lower border of the cricoid
/// Steps for the direction of the skin: wide over the jugular vein, where fat is uneven, narrow in the hollow below the
/// clavicle.
constexpr double kOverVein_mm = 5, kBelowClavicle_mm = 3;
constexpr double kTilt = 0.25;       ///< tilt as a share of the angle from the skin's direction to the vein's
constexpr double kAxillary_mm = 75;  ///< from the midline: below the middle of the clavicle

/// Distance along a ray from inside the body to the skin, by bisection.
double toSkin_mm(const NeckModel& neck, Vec3 from_mm, Vec3 direction) {
  double inside = 0, outside = 80;
  for (int n = 0; n < 40; ++n) {
    const double middle = 0.5 * (inside + outside);
    (neck.belowSkin_mm(from_mm + direction * middle) > 0 ? inside : outside) = middle;
  }
  return inside;
}

/// Outward direction in the plane of the level toward the nearest skin, inclined to the front, where a probe is held.
Vec3 towardProbe(const NeckModel& neck, Vec3 vein_mm, Side side) {
  constexpr double kUsual_deg = 32, kSoftness_deg = 32;
  Vec3 best;
  double lowest = 1e9;
  for (int degrees = 5; degrees <= 75; ++degrees) {
    const double a = degrees * std::numbers::pi / 180, off = (degrees - kUsual_deg) / kSoftness_deg;
    const Vec3 direction{patientX(side, std::sin(a)), -std::cos(a), 0};
    const double cost = toSkin_mm(neck, vein_mm, direction) * (1 + off * off);
    if (cost < lowest) lowest = cost, best = direction;
  }
  return best;
}

/// Normal of the skin under a face, from differences over some mm to either side.
Vec3 inwardNormal(const NeckModel& neck, Vec3 at_mm, double step_mm) {
  Vec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step;
    step[axis] = step_mm;
    gradient[axis] = neck.belowSkin_mm(at_mm + step) - neck.belowSkin_mm(at_mm - step);
  }
  return normalized(gradient);
}

Vec3 orthogonalTo(Vec3 axial, Vec3 direction) {
  return normalized(direction - axial * dot(axial, direction));
}

}  // namespace

std::vector<Target> axillaryTargets(const NeckModel& neck) {
  return {{"right subclavian vein", kVein, neck.axillaryCenter_mm(Side::kRight, kAxillary_mm)}};
}

std::vector<StartPose> axillaryStartPoses(const NeckModel& neck) {
  const Vec3 vein = neck.axillaryCenter_mm(Side::kRight, kAxillary_mm);
  // Perpendicular to the skin on the line through the vein, so that both images show the vein.
  Vec3 axial{0, 1, 0}, skin;
  for (int n = 0; n < 8; ++n) {
    skin = vein - axial * toSkin_mm(neck, vein, -axial);
    if (n < 7) axial = inwardNormal(neck, skin, kBelowClavicle_mm);
  }
  const Vec3 towardHeart =
      neck.axillaryCenter_mm(Side::kRight, kAxillary_mm - 12) - neck.axillaryCenter_mm(Side::kRight, kAxillary_mm + 12);
  const Vec3 along = orthogonalTo(axial, towardHeart);
  const Vec3 across = cross(axial, along);
  return {{"below the right clavicle, transverse", skin, axial, across.z > 0 ? across : -across},
          {"below the right clavicle, longitudinal", skin, axial, along}};
}

std::vector<Target> jugularTargets(const NeckModel& neck) {
  return {{"right internal jugular vein", kVein, neck.jugularCenter_mm(Side::kRight, kTargetLevel_mm)},
          {"left internal jugular vein", kVein, neck.jugularCenter_mm(Side::kLeft, kTargetLevel_mm)}};
}

std::vector<StartPose> jugularStartPoses(const NeckModel& neck) {
  std::vector<StartPose> poses;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const Vec3 vein = neck.jugularCenter_mm(side, kTargetLevel_mm);
    const Vec3 outward = towardProbe(neck, vein, side);
    const Vec3 skin = vein + outward * toSkin_mm(neck, vein, outward);
    // The probe lies on the skin and tilts a little toward the vein.
    const Vec3 axial = normalized(inwardNormal(neck, skin, kOverVein_mm) * (1 - kTilt) - outward * kTilt);
    const Vec3 towardFeet =
        neck.jugularCenter_mm(side, kTargetLevel_mm - 10) - neck.jugularCenter_mm(side, kTargetLevel_mm + 10);
    const std::string neckSide = side == Side::kRight ? "right neck" : "left neck";
    poses.push_back({neckSide + ", transverse", skin, axial, orthogonalTo(axial, {1, 0, 0})});
    poses.push_back({neckSide + ", longitudinal", skin, axial, orthogonalTo(axial, towardFeet)});
  }
  return poses;
}

std::vector<Landmark> landmarks(const NeckModel& neck, const std::vector<StartPose>& poses) {
  constexpr double kArch_mm = -6;  // middle of the cricoid's arch, half an airway and a shell behind its front
  const auto mark = [&](const char* code, Vec3 model_mm) {
    return Landmark{code, std::string(landmarkKind(code)->name), neck.patientFromModel(model_mm)};
  };
  std::vector<Landmark> marks{mark("cricoid", {0, airwayCenter_mm(kArch_mm) - 10.4, kArch_mm}),
                              mark("sternal_notch", {0, -2, -54}),
                              mark("clavicle_right", {patientX(Side::kRight, 22), 3.5, -50}),
                              mark("clavicle_left", {patientX(Side::kLeft, 22), 3.5, -51.5})};
  for (const StartPose& pose : poses)
    if (const auto comma = pose.name.rfind(", transverse"); comma != std::string::npos)
      marks.push_back({"puncture_site", "puncture site, " + pose.name.substr(0, comma), pose.position_mm});
  return marks;
}

}  // namespace insonate::phantom
