#include "session/VeinWatch.h"

#include <insonate/simulator/LiveImaging.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate {
namespace {

/// Maximum ratio of the distance between the image's middle line and the center line to the lumen's length along the
/// middle line.
constexpr double kOffCenter = 0.35;
/// A vein thinner than this is the border of a vein.
constexpr double kLeast_mm = 1.5;
constexpr std::int64_t kStays_us = 1'000'000;
/// Share of the former thickness below which a vein counts as compressed. A dented vein keeps more; an artery keeps its
/// shape.
constexpr double kFlat = 0.4;

}  // namespace

VeinWatch::Sight VeinWatch::sightOf(std::span<const Vec3> middleAtRest_mm, const TissueGrid& grid,
                                    const VesselLocator& vessels, std::span<const CenterLine> veins) {
  const auto inTarget = [&](Vec3 rest_mm) {
    return grid.at(rest_mm).label == kVein && vessels.isTarget(rest_mm, veins);
  };
  Sight sight;
  double chord_mm = 0, off_mm = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < middleAtRest_mm.size(); ++i) {
    if (inTarget(middleAtRest_mm[i])) sight.thickness_mm += kMiddleStep_mm;
    if (i == 0) continue;
    // The plane shows only the walls of a compressed lumen; at rest the lumen lies between them.
    const Vec3 step_mm = middleAtRest_mm[i] - middleAtRest_mm[i - 1];
    const int parts = std::max(1, static_cast<int>(std::ceil(norm(step_mm) / kMiddleStep_mm)));
    for (int part = 0; part < parts; ++part) {
      const Vec3 at_mm = middleAtRest_mm[i - 1] + step_mm * (part / static_cast<double>(parts));
      if (!inTarget(at_mm)) continue;
      chord_mm += norm(step_mm) / parts;
      const auto distance_mm = vessels.distanceToCenterLine_mm(at_mm, veins);
      if (!distance_mm || *distance_mm >= off_mm) continue;
      off_mm = *distance_mm;
      sight.middle_mm = at_mm, sight.vessel = vessels.vesselAt(kVein, at_mm, veins);
    }
  }
  sight.isCentered = chord_mm >= kLeast_mm && off_mm <= kOffCenter * chord_mm;
  return sight;
}

std::optional<AttemptEvent> VeinWatch::look(std::int64_t time_us, const std::optional<Sight>& sight, Vec3 axial) {
  if (!sight || !sight->isCentered) {
    since_us_.reset();
    max_mm_ = 0, isCompressedTold_ = false;
    return std::nullopt;
  }
  if (!since_us_) since_us_ = time_us;
  max_mm_ = std::max(max_mm_, sight->thickness_mm);
  AttemptEvent event{.time_us = time_us,
                     .wall = kVein,
                     .into = kVein,
                     .vessel = sight->vessel,
                     .tip_mm = sight->middle_mm,
                     .axis = axial};
  if (!isCenteredTold_ && time_us - *since_us_ >= kStays_us) {
    isCenteredTold_ = true;
    event.kind = AttemptEventKind::Centered;
    return event;
  }
  if (isCompressedTold_ || max_mm_ < kLeast_mm || sight->thickness_mm > kFlat * max_mm_) return std::nullopt;
  isCompressedTold_ = true;
  event.kind = AttemptEventKind::Compressed;
  return event;
}

}  // namespace insonate
