#include <insonate/simulator/AttemptStart.h>

#include <algorithm>
#include <array>
#include <limits>
#include <random>

namespace insonate {
namespace {

/// More than twice the distance within which a wide vein counts as centered (see VeinWatch).
constexpr std::array<double, kAttemptStarts> kAside_mm{14, -14, 29, -29};
/// At a smaller distance the vein is in the middle of the image.
constexpr double kLeast_mm = 9;
constexpr double kSearch_mm = 24, kAlong_mm = 8, kTurn_deg = 6, kDeep_mm = 60;

/// Distance from the middle line of the image to the center line of the target, with tissue at rest.
double offTarget_mm(const ProbePlacement& hand, const VesselLocator& vessels, std::span<const CenterLine> veins) {
  const Transform pose = hand.pose();
  double off_mm = std::numeric_limits<double>::infinity();
  for (double depth_mm = 0; depth_mm <= kDeep_mm; depth_mm += 1)
    if (const auto distance_mm = vessels.distanceToCenterLine_mm(pose * Vec3{0, 0, depth_mm}, veins))
      off_mm = std::min(off_mm, *distance_mm);
  return off_mm;
}

/// A slide over the skin, across the vein or along it.
struct Way {
  bool isAcrossElevation = false;  ///< in a long-axis image, the direction across the vein is the probe's elevation

  void across(ProbePlacement& hand, double mm) const { isAcrossElevation ? hand.slide(0, mm) : hand.slide(mm, 0); }
  void along(ProbePlacement& hand, double mm) const { isAcrossElevation ? hand.slide(mm, 0) : hand.slide(0, mm); }
};

}  // namespace

ProbePlacementState attemptStart(const ProbePlacement& home, const VesselLocator& vessels,
                                 std::span<const CenterLine> veins, int place, std::uint32_t seed) {
  const auto off_mm = [&](ProbePlacement hand, const Way& way, double mm) {
    way.across(hand, mm);
    return offTarget_mm(hand, vessels, veins);
  };
  constexpr double kProbe_mm = 10;
  const auto change_mm = [&](const Way& way) {
    return std::max(off_mm(home, way, kProbe_mm), off_mm(home, way, -kProbe_mm));
  };
  const Way way{change_mm(Way{true}) > change_mm(Way{false})};

  std::mt19937 random(seed);
  const auto within = [&](double most) { return std::uniform_real_distribution(-most, most)(random); };
  ProbePlacement beside = home;
  way.along(beside, within(kAlong_mm));
  const double turn_deg = within(kTurn_deg);
  double over_mm = 0;
  for (double mm = -kSearch_mm; mm <= kSearch_mm; mm += 1)
    if (off_mm(beside, way, mm) < off_mm(beside, way, over_mm)) over_mm = mm;
  const auto startAt = [&](int which) {
    ProbePlacement hand = beside;
    way.across(hand, over_mm + kAside_mm[static_cast<std::size_t>(which)]);
    hand.rotate(turn_deg);
    return hand;
  };
  ProbePlacement start = startAt(place);
  // If the skin ends too early, uses the other side.
  if (offTarget_mm(start, vessels, veins) < kLeast_mm) start = startAt(place ^ 1);
  return start.state();
}

}  // namespace insonate
