#include "NeckPoses.h"

#include "phantom/Region.h"
#include "phantom/SkinPoses.h"

#include <insonate/cases/Landmarks.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kTargetLevel_mm = 0;  ///< lower border of the cricoid
/// Steps for the direction of the skin: wide over the jugular vein, where fat is uneven, narrow in the hollow below the
/// clavicle.
constexpr double kOverVein_mm = 5, kBelowClavicle_mm = 3;
constexpr double kTilt = 0.25;  ///< tilt as a share of the angle from the skin's direction to the vein's
/// Distances from the midline: below the middle of the clavicle, where the vein passes from the axillary to the
/// subclavian vein, and lateral of the first rib.
constexpr double kSubclavian_mm = 75, kAxillary_mm = 90;

Vec3 chestTarget_mm(const NeckModel& chest, bool axillary, double toward_mm = 0) {
  return chest.axillaryCenter_mm(Side::kRight, (axillary ? kAxillary_mm : kSubclavian_mm) + toward_mm);
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

}  // namespace

std::vector<Target> chestTargets(const NeckModel& chest, bool axillary) {
  return {{axillary ? "right axillary vein" : "right subclavian vein", kVein, chestTarget_mm(chest, axillary)}};
}

std::vector<StartPose> chestStartPoses(const NeckModel& chest, bool axillary) {
  // Both images show the vein.
  const auto [skin, axial] = placeOver(chest, chestTarget_mm(chest, axillary), kBelowClavicle_mm);
  const Vec3 towardHeart = chestTarget_mm(chest, axillary, -12) - chestTarget_mm(chest, axillary, 12);
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
  std::ranges::copy(punctureSites(poses), std::back_inserter(marks));
  return marks;
}

}  // namespace insonate::phantom
