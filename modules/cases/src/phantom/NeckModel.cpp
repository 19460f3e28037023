#include "NeckModel.h"

#include "Noise.h"
#include "SliceLabels.h"
#include "Variation.h"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>
#include <string>

namespace insonate::phantom {
namespace {

constexpr double kWarp_mm = 1.0;  ///< amplitude of local irregularity
constexpr double kWarpCell_mm = 23;
constexpr double kShift_mm = 1.6;  ///< amplitude of regional shifts: an airway is rarely in the midline
constexpr double kShiftCell_mm = 48;
/// Chosen so that seed 1, the default, is close to the mean neck.
constexpr std::uint32_t kIndividual = 3964;
constexpr double kSpineY_mm = 45;  ///< the head turns about a vertical axis through the spine

/// Horizontal displacement that makes left and right differ.
Vec3 warp_mm(Vec3 p, std::uint32_t seed) {
  const Vec3 cell = p / kWarpCell_mm, region = p / kShiftCell_mm;
  return {kWarp_mm * smoothNoise(cell, seed ^ 0x1234567U) + kShift_mm * smoothNoise(region, seed ^ 0x2345678U),
          kWarp_mm * smoothNoise(cell, seed ^ 0x89abcdeU) + kShift_mm * smoothNoise(region, seed ^ 0x9abcdefU), 0};
}

Vec3 rotated(Vec3 p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), y = p.y - kSpineY_mm;
  return {c * p.x - s * y, s * p.x + c * y + kSpineY_mm, p.z};
}

}  // namespace

NeckModel::NeckModel(const NeckParameters& parameters, std::uint32_t seed)
    : parameters_(individualNeck(parameters, hash32(seed + kIndividual))),
      seed_(hash32(seed + 0x6e65636bU)),
      surface_({parameters_.fat_mm, parameters_.skin_mm, parameters_.girth_mm, hash32(seed + 11)}),
      structures_(makeAnatomy(parameters_, hash32(seed + 12))) {}

double NeckModel::twist(double z_mm) const {
  // The cervical spine takes part in the turn; the shoulders do not move.
  const double t = std::clamp((z_mm + 48) / 100, 0.0, 1.0);
  return parameters_.headTurn_deg * std::numbers::pi / 180 * t * t * (3 - 2 * t);
}

Vec3 NeckModel::modelFromPatient(Vec3 p) const {
  const Vec3 turned = rotated(p, -twist(p.z));
  return turned + warp_mm(turned, seed_);
}

Vec3 NeckModel::patientFromModel(Vec3 model_mm) const {
  // The warp has a slope below 0.15, so that a few fixed-point steps invert it.
  Vec3 turned = model_mm;
  for (int n = 0; n < 12; ++n) turned = model_mm - warp_mm(turned, seed_);
  return rotated(turned, twist(turned.z));
}

double NeckModel::belowSkin_mm(Vec3 patient_mm) const {
  return surface_.belowSkin_mm(modelFromPatient(patient_mm));
}

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

std::vector<NamedVessel> NeckModel::namedVessels() const {
  constexpr double kApart_mm = 3;  // distance of points along a course
  std::vector<NamedVessel> vessels;
  for (const VesselCourse& course : vesselCourses(parameters_, surface_)) {
    NamedVessel vessel{course.name, course.label, {}};
    for (std::size_t i = 0; i < course.line.size(); ++i) {
      const Tube::Knot& knot = course.line[i];
      const Vec3 at_mm = patientFromModel(knot.p_mm);
      const bool last = i + 1 == course.line.size();
      if (!last && !vessel.course.empty() && norm(at_mm - vessel.course.back().position_mm) < kApart_mm) continue;
      vessel.course.push_back({at_mm, knot.radius_mm});
    }
    vessels.push_back(std::move(vessel));
  }
  return vessels;
}

Result<LabelMap> NeckModel::rasterise(const VolumeGeometry& g, const Progress& progress) const {
  LabelMap labels(g);
  std::mutex reporting;
  std::atomic<bool> cancelled{false};
  std::atomic<int> done{0};
  tbb::parallel_for(0, g.size[2], [&](int k) {
    if (cancelled) return;
    const double z = g.origin_mm.z + k * g.spacing_mm.z;
    SliceLabels slice(structures_, surface_.slice(z), parameters_.platysma,
                      {z, seed_, g.origin_mm, g.spacing_mm, g.size[0], g.size[1]});
    slice.place([&](Vec3 p) { return modelFromPatient(p); });
    slice.paint(&labels.at(0, 0, k));
    const std::lock_guard lock(reporting);
    if (!report(progress, "Building the neck", double(++done) / g.size[2])) cancelled = true;
  });
  if (cancelled) return fail(std::string(kCancelled));
  return labels;
}

}  // namespace insonate::phantom
