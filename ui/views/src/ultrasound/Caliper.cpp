#include <insonate/views/Caliper.h>

#include <cmath>
#include <cstdio>
#include <numbers>

namespace insonate::views {
namespace {

ImagePoint operator-(ImagePoint a, ImagePoint b) {
  return {a.lateral_mm - b.lateral_mm, a.axial_mm - b.axial_mm};
}
double length(ImagePoint a) {
  return std::hypot(a.lateral_mm, a.axial_mm);
}
double crossed(ImagePoint a, ImagePoint b) {
  return a.lateral_mm * b.axial_mm - a.axial_mm * b.lateral_mm;
}

}  // namespace

CaliperValues measure(const Caliper& caliper) {
  const auto& p = caliper.points;
  CaliperValues values;
  if (caliper.kind == CaliperKind::Angle) {
    const ImagePoint a = p[0] - p[1], b = p[2] - p[1];
    const double along = a.lateral_mm * b.lateral_mm + a.axial_mm * b.axial_mm;
    if (length(a) > 0 && length(b) > 0)
      values.angle_deg = std::abs(std::atan2(crossed(a, b), along)) * 180 / std::numbers::pi;
    return values;
  }
  values.length_mm = length(p[1] - p[0]);
  if (caliper.kind == CaliperKind::Distance || values.length_mm == 0) return values;
  values.width_mm = 2 * std::abs(crossed(p[1] - p[0], p[2] - p[0])) / values.length_mm;
  const double a = values.length_mm / 2, b = values.width_mm / 2;
  const double h = (a - b) * (a - b) / ((a + b) * (a + b));
  values.area_mm2 = std::numbers::pi * a * b;
  values.circumference_mm = std::numbers::pi * (a + b) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
  return values;
}

std::vector<ImagePoint> outline(const Caliper& caliper) {
  std::vector<ImagePoint> ring;
  if (caliper.kind != CaliperKind::Ellipse) return ring;
  constexpr int kSides = 72;
  const auto& p = caliper.points;
  const CaliperValues values = measure(caliper);
  const double along = std::atan2(p[1].axial_mm - p[0].axial_mm, p[1].lateral_mm - p[0].lateral_mm);
  const double c = std::cos(along), s = std::sin(along);
  for (int k = 0; k < kSides; ++k) {
    const double turn = 2 * std::numbers::pi * k / kSides;
    const double a = values.length_mm / 2 * std::cos(turn), b = values.width_mm / 2 * std::sin(turn);
    ring.push_back(
        {(p[0].lateral_mm + p[1].lateral_mm) / 2 + a * c - b * s, (p[0].axial_mm + p[1].axial_mm) / 2 + a * s + b * c});
  }
  return ring;
}

std::string caliperText(const Caliper& caliper) {
  const CaliperValues values = measure(caliper);
  char text[96];
  switch (caliper.kind) {
    case CaliperKind::Distance:
      std::snprintf(text, sizeof text, "%.1f mm", values.length_mm);
      break;
    case CaliperKind::Ellipse:
      std::snprintf(text, sizeof text, "%.1f \u00d7 %.1f mm, %.0f mm\u00b2", values.length_mm, values.width_mm,
                    values.area_mm2);
      break;
    case CaliperKind::Angle:
      std::snprintf(text, sizeof text, "%.0f\u00b0", values.angle_deg);
      break;
  }
  return text;
}

}  // namespace insonate::views
