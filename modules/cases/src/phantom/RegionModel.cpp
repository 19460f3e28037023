#include "RegionModel.h"

#include "Noise.h"
#include "SliceLabels.h"

#include <oneapi/tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <string>

namespace insonate::phantom {
namespace {

constexpr double kWarp_mm = 1.0;  ///< amplitude of local irregularity
constexpr double kWarpCell_mm = 23;
constexpr double kShift_mm = 1.6;  ///< amplitude of regional shifts: an airway is rarely in the midline
constexpr double kShiftCell_mm = 48;
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

RegionModel::RegionModel(RegionParts parts) : parts_(std::move(parts)), surface_(parts_.layers) {}

Vec3 RegionModel::modelFromPatient(Vec3 p) const {
  const Vec3 turned = rotated(p, -twist(p.z));
  return turned + warp_mm(turned, parts_.seed);
}

Vec3 RegionModel::patientFromModel(Vec3 model_mm) const {
  // The warp has a slope below 0.15, so that a few fixed-point steps invert it.
  Vec3 turned = model_mm;
  for (int n = 0; n < 12; ++n) turned = model_mm - warp_mm(turned, parts_.seed);
  return rotated(turned, twist(turned.z));
}

double RegionModel::belowSkin_mm(Vec3 patient_mm) const {
  return surface_.belowSkin_mm(modelFromPatient(patient_mm));
}

std::vector<NamedVessel> RegionModel::namedVessels() const {
  constexpr double kApart_mm = 3;  // distance of points along a course
  std::vector<NamedVessel> vessels;
  for (const VesselCourse& course : parts_.vessels) {
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

Result<LabelMap> RegionModel::rasterise(const VolumeGeometry& g, const Progress& progress) const {
  LabelMap labels(g);
  std::mutex reporting;
  std::atomic<bool> cancelled{false};
  std::atomic<int> done{0};
  tbb::parallel_for(0, g.size[2], [&](int k) {
    if (cancelled) return;
    const double z = g.origin_mm.z + k * g.spacing_mm.z;
    SliceLabels slice(parts_.structures, surface_.slice(z), parts_.platysma,
                      {z, parts_.seed, g.origin_mm, g.spacing_mm, g.size[0], g.size[1]});
    slice.place([&](Vec3 p) { return modelFromPatient(p); });
    slice.paint(&labels.at(0, 0, k));
    const std::lock_guard lock(reporting);
    if (!report(progress, "Building the case", double(++done) / g.size[2])) cancelled = true;
  });
  if (cancelled) return fail(std::string(kCancelled));
  return labels;
}

}  // namespace insonate::phantom
