#include "line/WireSight.h"

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Sines of the angles between vessel and image plane: minimum in short axis (45 degrees), maximum in long axis (30).
constexpr double kShort = 0.7071, kLong = 0.5;
constexpr double kAlong_mm = 10;
/// Amplitude below which a bubble is not told from the haze in a lumen; our choice.
constexpr double kFaint = 2;

/// Place in the probe frame at which the image shows tissue. The displacement is an inverse map; it is inverted by
/// fixed-point iteration, which converges since tissue does not fold.
Vec3 displayed(const WirePlane& plane, const Transform& probeFromPatient, Vec3 rest_mm) {
  const Vec3 rest = probeFromPatient * rest_mm;
  Vec3 shown = rest;
  if (plane.displacement.empty()) return shown;
  for (int i = 0; i < 12; ++i) shown = rest - shiftAt(plane.displacement, shown.x, shown.z);
  return shown;
}

}  // namespace

LineHands::Sight wireSightOf(const WirePlane& plane, const LineHands& line) {
  LineHands::Sight sight;
  const std::span<const Vec3> wire_mm = line.wire_mm();
  const Transform probeFromPatient = inverted(plane.patientFromProbe);
  const Vec3 across = plane.patientFromProbe.linear.column[1];
  double along_mm = 0;
  Vec3 last{};
  // The first point is the puncture of the skin; the wire leaves the needle at the second.
  for (std::size_t i = 1; i < wire_mm.size(); ++i) {
    const Vec3 now = displayed(plane, probeFromPatient, wire_mm[i]);
    if (i > 1) {
      const double sine = std::abs(dot(across, line.vesselAxisAt(wire_mm[i])));
      const bool isVisible = sine < kLong && isTipInView(plane.field, plane.depth_mm, now) &&
                             isTipInView(plane.field, plane.depth_mm, last);
      along_mm = isVisible ? along_mm + norm(now - last) : 0;
      if (along_mm >= kAlong_mm) sight.isInLongAxis = true, sight.at_mm = wire_mm[i];
      const bool isCrossing = last.y * now.y <= 0 && last.y != now.y;
      if (sine > kShort && isCrossing &&
          isTipInView(plane.field, plane.depth_mm, last + (now - last) * (last.y / (last.y - now.y))))
        sight.isInShortAxis = true, sight.at_mm = wire_mm[i];
    }
    last = now;
  }
  return sight;
}

int bubblesIn(const WirePlane& plane, LineHands& line, const LabelMap& labels) {
  const std::span<const Bubble> bubbles = line.bubbles();
  if (bubbles.empty()) return 0;
  const Label vessel = line.flush()->wall;
  const Transform probeFromPatient = inverted(plane.patientFromProbe);
  const Transform indexFromPatient = inverted(labels.geometry.patientFromIndex());
  return static_cast<int>(std::ranges::count_if(bubbles, [&](const Bubble& bubble) {
    if (bubble.amplitude < kFaint) return false;
    if (sampleNearest(labels, indexFromPatient * bubble.position_mm) != vessel) return false;
    Vec3 shown = displayed(plane, probeFromPatient, bubble.position_mm);
    shown.y *= 2;  // a needle is seen within a whole slice thickness
    return isTipInView(plane.field, plane.depth_mm, shown);
  }));
}

}  // namespace insonate
