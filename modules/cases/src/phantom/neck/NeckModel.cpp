#include "NeckModel.h"

#include <insonate/core/Hash.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::phantom {
namespace {

/// Chosen so that seed 1, the default, is close to the mean neck.
constexpr std::uint32_t kIndividual = 3964;

NeckParameters ofSeed(const NeckParameters& parameters, std::uint32_t seed) {
  return individualNeck(parameters, hash32(seed + kIndividual));
}

/// The cervical spine takes part in the turn of the head; the shoulders do not move.
double turnAt(double headTurn_deg, double z_mm) {
  const double t = std::clamp((z_mm + 48) / 100, 0.0, 1.0);
  return headTurn_deg * std::numbers::pi / 180 * t * t * (3 - 2 * t);
}

RegionParts partsOf(const NeckParameters& parameters, std::uint32_t seed) {
  const LayerOptions layers{&neckOutline(), parameters.fat_mm, parameters.skin_mm, parameters.girth_mm,
                            hash32(seed + 11)};
  return {layers,
          parameters.platysma,
          makeAnatomy(parameters, hash32(seed + 12)),
          vesselCourses(parameters, BodySurface(layers)),
          hash32(seed + 0x6e65636bU),
          [turn = parameters.headTurn_deg](double z_mm) { return turnAt(turn, z_mm); }};
}

}  // namespace

NeckModel::NeckModel(const NeckParameters& parameters, std::uint32_t seed)
    : RegionModel(partsOf(ofSeed(parameters, seed), seed)), parameters_(ofSeed(parameters, seed)) {}

Vec3 NeckModel::jugularCenter_mm(Side side, double z_mm) const {
  const auto vein = jugularVeinAt(parameters_, side, z_mm);
  return patientFromModel({patientX(side, vein[0]), vein[1], z_mm});
}

Vec3 NeckModel::axillaryCenter_mm(Side side, double lateral_mm) const {
  const auto line = centerLine(axillaryVein());
  const auto off = [&](const Tube::Knot& knot) { return std::abs(knot.p_mm.x - lateral_mm); };
  const Vec3 at = std::ranges::min(line, {}, off).p_mm;
  return patientFromModel({patientX(side, at.x), at.y, at.z});
}

}  // namespace insonate::phantom
