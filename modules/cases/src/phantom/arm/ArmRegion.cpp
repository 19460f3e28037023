#include "Arm.h"
#include "phantom/Individual.h"
#include "phantom/SkinPoses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kSkinStep_mm = 4;

/// A round arm, flatter on its inner side, and a little thicker toward the shoulder; fat is thicker at the back.
const Outline& armOutline() {
  static const Outline kArm{{{-60, {{37.2, 37.4, 37.8, 37.6, 37, 37, 37.4, 37.2, 37}}},
                             {0, {{37.6, 38, 38.6, 38.6, 38, 38, 38.4, 38.2, 38}}},
                             {60, {{37.6, 38.6, 40, 40.4, 40, 40, 40, 39.6, 39.2}}}},
                            [](double angle, double) { return 1 + 0.25 * std::pow(std::sin(angle / 2), 2); }};
  return kArm;
}

ArmParameters individualArm(ArmParameters n, std::uint32_t seed) {
  const Individual vary(seed);
  n.seed = hash32(seed ^ 0x61U);
  n.skin_mm += 0.25 * vary(1);
  n.fat_mm *= 1 + 0.12 * vary(2);
  n.veinScale *= 1 + 0.06 * vary(3);
  return n;
}

RegionParts armParts(const ArmParameters& n, std::uint32_t seed) {
  RegionParts parts{.layers = {&armOutline(), n.fat_mm, n.skin_mm, 0, hash32(seed + 11)},
                    .platysma = {.halfThickness_mm = 0},
                    .structures = {},
                    .vessels = armVessels(n),
                    .seed = hash32(seed + 0x61726dU)};
  addArmVessels(parts.structures, n, hash32(seed + 2));
  addArmNerves(parts.structures, n, hash32(seed + 3));
  addArmMusclesAndBone(parts.structures, hash32(seed + 4));
  return parts;
}

VolumeGeometry armGrid() {
  VolumeGeometry g;
  g.size = {224, 232, 134};
  g.spacing_mm = {0.5, 0.5, 0.75};
  g.origin_mm = {-55.75, -18, -50};
  return g;
}

Vec3 basilicCenter_mm(const RegionModel& arm, const ArmParameters& n, double z_mm) {
  const auto line = centerLine(basilicVein(n));
  const auto off = [&](const Tube::Knot& knot) { return std::abs(knot.p_mm.z - z_mm); };
  const Vec3 at = std::ranges::min(line, {}, off).p_mm;
  return arm.patientFromModel({patientX(Side::kRight, at.x), at.y, at.z});
}

/// Each pose shows the vessels, but none has the vein in its middle.
std::vector<StartPose> armPoses(const RegionModel& arm, const ArmParameters& n, Vec3 vein) {
  const Vec3 towardElbow = basilicCenter_mm(arm, n, -12) - basilicCenter_mm(arm, n, 12);
  const auto transverse = [&](std::string name, Vec3 over_mm, double turn_deg) {
    const auto [skin, axial] = placeOver(arm, over_mm, kSkinStep_mm);
    const double turn = turn_deg * std::numbers::pi / 180;
    return StartPose{std::move(name), skin, axial, orthogonalTo(axial, {std::cos(turn), 0, std::sin(turn)})};
  };
  const auto [skin, axial] = placeOver(arm, vein + Vec3{-4, 0, 0}, kSkinStep_mm);
  return {
      transverse("right upper arm, transverse", vein + Vec3{-10, 3, 0}, 0),
      {"right upper arm, longitudinal", skin, axial, orthogonalTo(axial, towardElbow)},
      transverse("right upper arm toward the elbow, transverse", basilicCenter_mm(arm, n, -28) + Vec3{-7, 2, 0}, -7)};
}

}  // namespace

Region makeRegion(const ArmParameters& usual, std::uint32_t seed) {
  const ArmParameters n = individualArm(usual, hash32(seed + 0x41U));
  const RegionModel arm(armParts(n, seed));
  const Vec3 vein = basilicCenter_mm(arm, n, 0);
  Region region{arm, armGrid()};
  region.targets = {{"right basilic vein", kVein, vein}};
  region.startPoses = armPoses(arm, n, vein);
  region.landmarks = punctureSites(region.startPoses);
  return region;
}

}  // namespace insonate::phantom
