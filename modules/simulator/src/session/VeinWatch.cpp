#include "session/VeinWatch.h"

#include <insonate/simulator/LiveImaging.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

/// Maximum ratio of the distance between the image's middle line and the center line to the lumen's length along the
/// middle line.
constexpr double kOffCenter = 0.35;
/// A vein thinner than this is the border of a vein.
constexpr double kThinnest_mm = 1.5;
constexpr std::int64_t kStays_us = 1'000'000;
/// Share of the former thickness or area below which a vein counts as compressed. A dented vein keeps more; an artery
/// keeps its shape.
constexpr double kFlatShare = 0.4;
/// A smaller motion along the axis does not compress a vein, which may become smaller by breathing alone.
constexpr double kCompressed_mm = 1;
/// A probe that has moved farther beside its axis has been slid over the skin.
constexpr double kSlid_mm = 1;
/// A probe that has turned farther about any axis has been tilted or rotated. A hand that presses turns the probe less.
constexpr double kTurned_deg = 3;
/// Distance along the vein after which a compression counts as one at another place, and share of the former thickness
/// to which the vein has to open before.
constexpr double kOtherPlace_mm = 10, kOpenShare = 0.7;
constexpr double kAreaStep_mm = 1, kAreaHalf_mm = 24;

bool isIn(std::uint8_t vessel, Vec3 rest_mm, const VesselLocator& vessels, std::span<const CenterLine> veins) {
  return vessel == 1 ? vessels.isTarget(rest_mm, veins) : vessels.vesselAt(kVein, rest_mm, veins) == vessel;
}

/// Area of a vein in the image. Each line along the probe's axis is judged once for each vein on it, since
/// finding the vessel of a point takes microseconds.
double areaOf(const VeinWatch::Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
              std::span<const CenterLine> veins, std::uint8_t vessel) {
  const double depth_mm = kMiddleStep_mm * static_cast<double>(plane.middleAtRest_mm.size());
  double area_mm2 = 0;
  for (double x_mm = -kAreaHalf_mm; x_mm <= kAreaHalf_mm; x_mm += kAreaStep_mm) {
    int count = 0;
    Vec3 first_mm, last_mm;
    for (double z_mm = kAreaStep_mm / 2; z_mm < depth_mm + kAreaStep_mm; z_mm += kAreaStep_mm) {
      const Vec3 rest_mm = plane.patientFromProbe * (Vec3{x_mm, 0, z_mm} + shiftAt(plane.displacement, x_mm, z_mm));
      if (z_mm < depth_mm && grid.at(rest_mm).label == kVein) {
        if (count++ == 0) first_mm = rest_mm;
        last_mm = rest_mm;
        continue;
      }
      if (count > 0 && isIn(vessel, (first_mm + last_mm) * 0.5, vessels, veins))
        area_mm2 += count * kAreaStep_mm * kAreaStep_mm;
      count = 0;
    }
  }
  return area_mm2;
}

double angleBetween_deg(const Mat3& a, const Mat3& b) {
  double trace = 0;
  for (int i = 0; i < 3; ++i) trace += dot(a.column[i], b.column[i]);
  return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

bool isPressedFrom(const Transform& before, const Transform& now, double minimum_mm) {
  const Vec3 moved_mm = now.offset - before.offset, axial = before.linear.column[2];
  const double deeper_mm = dot(moved_mm, axial);
  return deeper_mm >= minimum_mm && norm(moved_mm - axial * deeper_mm) < kSlid_mm &&
         angleBetween_deg(before.linear, now.linear) < kTurned_deg;
}

VeinWatch::Sight VeinWatch::sightOf(const Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
                                    std::span<const CenterLine> veins, std::uint8_t vessel) {
  const std::span<const Vec3> middleAtRest_mm = plane.middleAtRest_mm;
  const auto isInVein = [&](Vec3 rest_mm) {
    return grid.at(rest_mm).label == kVein && isIn(vessel, rest_mm, vessels, veins);
  };
  Sight sight;
  double chord_mm = 0, off_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < middleAtRest_mm.size(); ++i) {
    if (isInVein(middleAtRest_mm[i])) sight.thickness_mm += kMiddleStep_mm;
    if (i == 0) continue;
    // The plane shows only the walls of a compressed lumen; at rest the lumen lies between them.
    const Vec3 step_mm = middleAtRest_mm[i] - middleAtRest_mm[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(step_mm) / kMiddleStep_mm)));
    for (int part = 0; part < parts; ++part) {
      const Vec3 at_mm = middleAtRest_mm[i - 1] + step_mm * (part / static_cast<double>(parts));
      if (!isInVein(at_mm)) continue;
      chord_mm += norm(step_mm) / parts;
      const auto distance_mm = vessels.distanceToCenterLine_mm(at_mm, veins, vessel);
      if (!distance_mm || *distance_mm >= off_mm) continue;
      off_mm = *distance_mm;
      sight.middle_mm = at_mm, sight.vessel = vessels.vesselAt(kVein, at_mm, veins);
      sight.depth_mm = kMiddleStep_mm * static_cast<double>(i);
    }
  }
  sight.isCentered = chord_mm >= kThinnest_mm && off_mm <= kOffCenter * chord_mm;
  sight.area_mm2 = areaOf(plane, grid, vessels, veins, vessel);
  return sight;
}

/// Starts over when the vein has left the middle, unless the probe has only compressed the tissue since.
void VeinWatch::follow(std::int64_t time_us, const Sight& sight, const Transform& patientFromProbe) {
  const bool isPressed = open_ && isPressedFrom(open_->patientFromProbe, patientFromProbe, 0);
  if (!sight.isCentered) {
    since_us_.reset();
    if (!isPressed) open_.reset(), max_mm_ = 0, isCompressedTold_ = false;
    return;
  }
  if (!since_us_) since_us_ = time_us;
  // The vein may be narrower farther along, where nothing compresses it.
  const bool isElsewhere = norm(sight.middle_mm - maxAt_mm_) >= kOtherPlace_mm;
  if (isElsewhere || sight.thickness_mm > max_mm_) max_mm_ = sight.thickness_mm, maxAt_mm_ = sight.middle_mm;
  if (isCompressedTold_ && norm(sight.middle_mm - toldAt_mm_) >= kOtherPlace_mm &&
      sight.thickness_mm >= kOpenShare * max_mm_)
    isCompressedTold_ = false;
  if (!isPressed || sight.area_mm2 >= open_->sight.area_mm2) open_ = {sight, patientFromProbe};
}

bool VeinWatch::isCompressed(const Sight& sight, const Transform& patientFromProbe) const {
  const bool isFlat = sight.isCentered && max_mm_ >= kThinnest_mm && sight.thickness_mm <= kFlatShare * max_mm_;
  if (isFlat && norm(sight.middle_mm - maxAt_mm_) < kOtherPlace_mm) return true;
  return open_->sight.area_mm2 >= kThinnest_mm * kThinnest_mm && sight.area_mm2 <= kFlatShare * open_->sight.area_mm2 &&
         isPressedFrom(open_->patientFromProbe, patientFromProbe, kCompressed_mm);
}

std::optional<AttemptEvent> VeinWatch::look(std::int64_t time_us, const std::optional<Sight>& sight,
                                            const Transform& patientFromProbe) {
  if (!sight) {
    since_us_.reset(), open_.reset();
    max_mm_ = 0, isCompressedTold_ = false;
    return std::nullopt;
  }
  follow(time_us, *sight, patientFromProbe);
  if (!open_) return std::nullopt;
  const Sight& at = sight->isCentered ? *sight : open_->sight;
  AttemptEvent event{.time_us = time_us,
                     .wall = kVein,
                     .into = kVein,
                     .vessel = at.vessel,
                     .tip_mm = at.middle_mm,
                     .axis = patientFromProbe.linear.column[2]};
  if (since_us_ && !isCenteredTold_ && time_us - *since_us_ >= kStays_us) {
    isCenteredTold_ = true;
    event.kind = AttemptEventKind::Centered;
    return event;
  }
  if (isCompressedTold_ || !isCompressed(*sight, patientFromProbe)) return std::nullopt;
  isCompressedTold_ = true, toldAt_mm_ = at.middle_mm;
  event.kind = AttemptEventKind::Compressed;
  return event;
}

}  // namespace insonate
