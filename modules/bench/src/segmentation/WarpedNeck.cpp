#include "WarpedNeck.h"

#include <insonate/cases/Phantom.h>
#include <insonate/core/Hash.h>

#include <tbb/parallel_for.h>

#include <array>
#include <cmath>
#include <numbers>

namespace insonate::bench {
namespace {

constexpr Vec3 kLow_mm{-76, -36, -61}, kHigh_mm{76, 106, 49};  // of the CT of a built-in neck
constexpr Vec3 kMiddle_mm{0, 35, -6};
constexpr double kBeyond_mm = 30;  // sampled beyond the CT, so that a warp finds tissue there
constexpr double kWave_mm = 110;   // length of the waves of the bend

VolumeGeometry gridBetween(Vec3 low_mm, Vec3 high_mm, Vec3 spacing_mm) {
  VolumeGeometry g;
  for (int axis = 0; axis < 3; ++axis)
    g.size[axis] = static_cast<int>(std::lround((high_mm[axis] - low_mm[axis]) / spacing_mm[axis]));
  g.spacing_mm = spacing_mm, g.origin_mm = low_mm + spacing_mm / 2;
  return g;
}

Mat3 rotation(int axis, double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
  Mat3 m;
  const int a = (axis + 1) % 3, b = (axis + 2) % 3;
  m.column[a][a] = c, m.column[a][b] = s, m.column[b][a] = -s, m.column[b][b] = c;
  return m;
}

class Warp {
 public:
  explicit Warp(const NeckWarp& how) : how_(how) {
    Mat3 linear = rotation(2, how.turn_deg.z) * rotation(1, how.turn_deg.y) * rotation(0, how.turn_deg.x);
    for (Vec3& column : linear.column) column = column * how.scale;
    if (how.isMirrored) linear.column[0] = -linear.column[0];
    warpedFromModel_ = {linear, kMiddle_mm - linear * kMiddle_mm};
    modelFromWarped_ = inverted(warpedFromModel_);
  }

  Vec3 modelFromWarped(Vec3 warped_mm) const { return modelFromWarped_ * warped_mm + bend_mm(warped_mm); }
  Vec3 warpedFromModel(Vec3 model_mm) const {
    Vec3 warped_mm = warpedFromModel_ * model_mm;
    for (int n = 0; n < 20; ++n) warped_mm = warpedFromModel_ * (model_mm - bend_mm(warped_mm));
    return warped_mm;
  }

 private:
  Vec3 bend_mm(Vec3 at_mm) const {
    Vec3 sum;
    for (std::uint32_t wave = 0; wave < 2; ++wave)
      for (int axis = 0; axis < 3; ++axis) {
        const auto random = [&](std::uint32_t of) {
          return unitInterval(hash32(how_.seed * 977U + hash32(16 * wave + 4U * std::uint32_t(axis) + of)));
        };
        const double phase = 2 * std::numbers::pi * random(0);
        const Vec3 along = normalized({random(1) - 0.5, random(2) - 0.5, random(3) - 0.5});
        sum[axis] += how_.bend_mm / 2 * std::sin(2 * std::numbers::pi / kWave_mm * dot(along, at_mm) + phase);
      }
    return sum;
  }

  NeckWarp how_;
  Transform warpedFromModel_, modelFromWarped_;
};

std::string mirroredName(const std::string& name) {
  if (name.starts_with("right ")) return "left " + name.substr(6);
  if (name.starts_with("left ")) return "right " + name.substr(5);
  return name;
}

}  // namespace

Result<WarpedNeck> warpedNeck(const std::string& variant, const NeckWarp& how, const Progress& progress) {
  const Vec3 beyond_mm{kBeyond_mm, kBeyond_mm, kBeyond_mm};
  const auto neck =
      phantomLabels(variant, how.seed, gridBetween(kLow_mm - beyond_mm, kHigh_mm + beyond_mm, {0.8, 0.8, 1}), progress);
  if (!neck) return tl::unexpected(neck.error());
  const Warp warp(how);
  WarpedNeck result{LabelMap(gridBetween(kLow_mm, kHigh_mm, how.spacing_mm)), {}};
  const VolumeGeometry& g = result.labels.geometry;
  const Transform patientFromIndex = g.patientFromIndex(), modelIndex = neck->labels.geometry.indexFromPatient();
  tbb::parallel_for(0, g.size[2], [&](int k) {
    for (int j = 0; j < g.size[1]; ++j)
      for (int i = 0; i < g.size[0]; ++i) {
        const Vec3 at_mm = warp.modelFromWarped(patientFromIndex * Vec3{double(i), double(j), double(k)});
        result.labels.at(i, j, k) = sampleNearest(neck->labels, modelIndex * at_mm);
      }
  });
  for (NamedVessel vessel : neck->vessels) {
    if (how.isMirrored) vessel.name = mirroredName(vessel.name);
    for (auto& point : vessel.course)
      point.position_mm = warp.warpedFromModel(point.position_mm), point.radius_mm *= how.scale;
    result.vessels.push_back(std::move(vessel));
  }
  return result;
}

}  // namespace insonate::bench
