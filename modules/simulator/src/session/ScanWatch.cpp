#include "session/ScanWatch.h"

#include <insonate/simulator/LiveImaging.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace insonate {
namespace {

constexpr std::int64_t kColorStays_us = 1'000'000;

/// Number of the named vein other than the target that covers most of the middle line; 0: none.
std::uint8_t otherVeinIn(const VeinWatch::Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
                         std::span<const CenterLine> veins) {
  std::array<std::uint16_t, 256> points{};
  for (const Vec3& rest_mm : plane.middleAtRest_mm)
    if (grid.at(rest_mm).label == kVein) ++points[vessels.vesselAt(kVein, rest_mm, veins)];
  points[0] = points[1] = points[kUnnamedVessel] = 0;
  const auto most = std::ranges::max_element(points);
  return *most > 0 ? static_cast<std::uint8_t>(most - points.begin()) : std::uint8_t{0};
}

}  // namespace

void ScanWatch::see(const VeinWatch::Plane& plane, const TissueGrid& grid, const VesselLocator& vessels,
                    std::span<const CenterLine> veins) {
  target_ = VeinWatch::sightOf(plane, grid, vessels, veins);
  // A vein that is being compressed may have left the middle line.
  std::uint8_t other = otherWatch_.vessel();
  if (other == 0) other = otherVeinIn(plane, grid, vessels, veins);
  other_.reset();
  if (other == 0) return;
  other_ = VeinWatch::sightOf(plane, grid, vessels, veins, other);
  other_->vessel = other;
}

/// Tells whether the box contains the target on the middle line. Its borders are lines along the scanlines of color.
bool ScanWatch::isInColor(const ColorSettings& color, double width_mm) const {
  const double steering_rad = color.steering_deg * std::numbers::pi / 180;
  const double atFace = 0.5 - target_->depth_mm * std::tan(steering_rad) / width_mm;
  const double range_mm = target_->depth_mm / std::cos(steering_rad);
  return color.left <= atFace && atFace <= color.right && color.near_mm <= range_mm && range_mm <= color.far_mm;
}

std::optional<AttemptEvent> ScanWatch::lookAtColor(std::int64_t time_us, const Transform& patientFromProbe,
                                                   bool isCovered) {
  if (!isCovered) {
    colorSince_us_.reset();
    return std::nullopt;
  }
  if (!colorSince_us_) colorSince_us_ = time_us;
  if (time_us - *colorSince_us_ < kColorStays_us) return std::nullopt;
  colorSince_us_ = std::numeric_limits<std::int64_t>::max();  // reported once
  return AttemptEvent{.time_us = time_us,
                      .kind = AttemptEventKind::ColorShown,
                      .wall = kVein,
                      .into = kVein,
                      .vessel = target_->vessel,
                      .tip_mm = target_->middle_mm,
                      .axis = patientFromProbe.linear.column[2]};
}

std::span<const AttemptEvent> ScanWatch::look(std::int64_t time_us, bool isLive, const Transform& patientFromProbe,
                                              const ColorSettings* color, double width_mm) {
  std::size_t count = 0;
  const auto report = [&](const std::optional<AttemptEvent>& event) {
    if (event) events_[count++] = *event;
  };
  report(targetWatch_.look(time_us, isLive ? target_ : std::nullopt, patientFromProbe));
  const auto other = otherWatch_.look(time_us, isLive ? other_ : std::nullopt, patientFromProbe);
  if (other && other->kind == AttemptEventKind::Compressed) report(other);
  const bool isCovered = isLive && color && target_ && target_->isCentered && isInColor(*color, width_mm);
  report(lookAtColor(time_us, patientFromProbe, isCovered));
  return std::span(events_).first(count);
}

}  // namespace insonate
