#include "Groin.h"
#include "phantom/Individual.h"
#include "phantom/SkinPoses.h"

#include <insonate/cases/Landmarks.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace insonate::phantom {
namespace {

constexpr double kTarget_mm = -22;  ///< 14 mm below the ligament over the vein, in front of the femoral head
constexpr double kStep_mm = 5;      ///< for the direction of the skin

/// Radius about the region's axis of a round surface: a circle of this radius whose front lies `forward_mm` before
/// y = 0.
std::array<double, 9> roundFront(double radius_mm, double forward_mm) {
  const double behind_mm = radius_mm - forward_mm - BodySurface::kAxisY_mm;
  std::array<double, 9> radii{};
  for (std::size_t n = 0; n < radii.size(); ++n) {
    const double along = behind_mm * std::cos(double(n) * std::numbers::pi / 8);
    radii[n] = -along + std::sqrt(along * along - behind_mm * behind_mm + radius_mm * radius_mm);
  }
  return radii;
}

/// Thigh below, lower abdomen above; the crease of the groin lies between them, just below the ligament.
const Outline& groinOutline() {
  static const Outline kGroin{{{-100, roundFront(80, 0.5)},
                               {-70, roundFront(82, 0.6)},
                               {-40, roundFront(86, 0.4)},
                               {-14, roundFront(92, -0.4)},
                               {4, roundFront(104, -0.2)},
                               {20, roundFront(120, 2)},
                               {40, roundFront(135, 5)}},
                              [](double, double z_mm) { return 1 + 0.2 * std::clamp((z_mm - 4) / 24, 0.0, 1.0); }};
  return kGroin;
}

GroinParameters individualGroin(GroinParameters n, std::uint32_t seed) {
  const Individual vary(seed);
  n.seed = hash32(seed ^ 0x6772U);
  n.skin_mm += 0.4 * vary(1);
  n.fat_mm *= 1 + 0.1 * vary(2);
  n.veinScale *= 1 + 0.06 * vary(3);
  n.arteryScale *= 1 + 0.05 * vary(4);
  return n;
}

RegionParts partsOf(const GroinParameters& n, std::uint32_t seed) {
  RegionParts parts{.layers = {&groinOutline(), n.fat_mm, n.skin_mm, 0, hash32(seed + 11)},
                    .platysma = {.halfThickness_mm = 0},
                    .structures = {},
                    .vessels = groinVessels(n),
                    .seed = hash32(seed + 0x67726f69U)};
  addGroinVessels(parts.structures, n, hash32(seed + 2));
  addGroinSkeleton(parts.structures, hash32(seed + 3));
  addGroinNerves(parts.structures, hash32(seed + 4));
  addGroinMuscles(parts.structures, hash32(seed + 5));
  return parts;
}

VolumeGeometry groinGrid(const GroinParameters& n) {
  constexpr double kAir_mm = 14, kDeep_mm = 76;
  VolumeGeometry g;
  g.spacing_mm = {0.5, 0.5, 0.75};
  const double front_mm = 1.2 * n.fat_mm + n.skin_mm + kAir_mm;
  g.size = {244, static_cast<int>((front_mm + kDeep_mm) / g.spacing_mm.y), 146};
  g.origin_mm = {-58.75, -front_mm, -84};
  return g;
}

Vec3 veinCenter_mm(const RegionModel& groin, const GroinParameters& n, double z_mm) {
  const auto vein = femoralVeinAt(n, z_mm);
  return groin.patientFromModel({patientX(Side::kRight, vein[0]), vein[1], z_mm});
}

/// Each pose shows the vessels, but none has the vein in its middle.
std::vector<StartPose> startPoses(const RegionModel& groin, const GroinParameters& n) {
  const Vec3 vein = veinCenter_mm(groin, n, kTarget_mm);
  const Vec3 towardFeet = veinCenter_mm(groin, n, kTarget_mm - 12) - veinCenter_mm(groin, n, kTarget_mm + 12);
  const auto transverse = [&](std::string name, Vec3 over_mm, double turn_deg) {
    const auto [skin, axial] = placeOver(groin, over_mm, kStep_mm);
    const double turn = turn_deg * std::numbers::pi / 180;
    return StartPose{std::move(name), skin, axial, orthogonalTo(axial, {std::cos(turn), 0, std::sin(turn)})};
  };
  const auto [skin, axial] = placeOver(groin, vein + Vec3{-5, 0, 0}, kStep_mm);
  return {transverse("right groin, transverse", vein + Vec3{-11, 0, 2}, 0),
          {"right groin, longitudinal", skin, axial, orthogonalTo(axial, towardFeet)},
          transverse("right groin at the thigh, transverse", veinCenter_mm(groin, n, -50) + Vec3{-9, 0, 0}, 8)};
}

}  // namespace

Region makeRegion(const GroinParameters& usual, std::uint32_t seed) {
  const GroinParameters n = individualGroin(usual, hash32(seed + 0x69U));
  const RegionModel groin(partsOf(n, seed));
  Region region{groin, groinGrid(n)};
  region.targets = {{"right common femoral vein", kVein, veinCenter_mm(groin, n, kTarget_mm)}};
  region.startPoses = startPoses(groin, n);
  const auto mark = [&](const char* code, Vec3 model_mm) {
    region.landmarks.push_back({code, std::string(landmarkKind(code)->name), groin.patientFromModel(model_mm)});
  };
  mark("pubic_tubercle_right", {39, 21, -29});
  mark("inguinal_ligament_right", {0, 3.4, 0});
  std::ranges::copy(punctureSites(region.startPoses), std::back_inserter(region.landmarks));
  if (n.hasThrombus) region.ownLabels[kThrombus] = {"thrombus", kLymphNode};
  return region;
}

}  // namespace insonate::phantom
