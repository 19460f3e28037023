#include "LensDerivative.h"

#include <insonate/camera/LensModel.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kMaxSize = 16384, kMaxDistortion = 10;

/// Distorted place of a direction (x', y'), and its derivative, which is symmetric.
struct Distorted {
  double x, y, xx, xy, yy;
};

Distorted distort(const LensModel& lens, double x, double y) {
  const double r2 = x * x + y * y;
  const double radial = 1 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double slope = 2 * (lens.k1 + r2 * (2 * lens.k2 + 3 * r2 * lens.k3));  // derivative of radial: slope * (x, y)
  Distorted d{};
  d.x = x * radial + 2 * lens.p1 * x * y + lens.p2 * (r2 + 2 * x * x);
  d.y = y * radial + lens.p1 * (r2 + 2 * y * y) + 2 * lens.p2 * x * y;
  d.xx = radial + x * x * slope + 2 * lens.p1 * y + 6 * lens.p2 * x;
  d.xy = x * y * slope + 2 * lens.p1 * x + 2 * lens.p2 * y;
  d.yy = radial + y * y * slope + 6 * lens.p1 * y + 2 * lens.p2 * x;
  return d;
}

/// Tells whether the radial distortion grows with the distance from the axis all the way to r.
bool isMonotonic(const LensModel& lens, double r2) {
  constexpr int kSteps = 8;
  for (int i = 1; i <= kSteps; ++i) {
    const double s = r2 * i / kSteps;
    if (1 + s * (3 * lens.k1 + s * (5 * lens.k2 + s * 7 * lens.k3)) <= 0) return false;
  }
  return true;
}

}  // namespace

std::optional<camera::Projection> camera::projectWithDerivative(const LensModel& lens, Vec3 p) {
  constexpr double kNearest_mm = 1;
  if (!(p.z > kNearest_mm)) return std::nullopt;
  const double x = p.x / p.z, y = p.y / p.z;
  if (!isMonotonic(lens, x * x + y * y)) return std::nullopt;
  const Distorted d = distort(lens, x, y);
  const auto derivative = [&](double f, double by_x, double by_y) {
    return Vec3{by_x, by_y, -by_x * x - by_y * y} * (f / p.z);
  };
  return Projection{{lens.fx_px * d.x + lens.cx_px, lens.fy_px * d.y + lens.cy_px},
                    derivative(lens.fx_px, d.xx, d.xy),
                    derivative(lens.fy_px, d.xy, d.yy)};
}

std::optional<FramePoint> project(const LensModel& lens, Vec3 point_camera) {
  const auto projected = camera::projectWithDerivative(lens, point_camera);
  return projected ? std::optional(projected->pixel) : std::nullopt;
}

Vec3 rayThrough(const LensModel& lens, FramePoint pixel) {
  const double u = (pixel.x - lens.cx_px) / lens.fx_px, v = (pixel.y - lens.cy_px) / lens.fy_px;
  double x = u, y = v;
  constexpr int kIterations = 20;
  constexpr double kPrecision = 1e-12;
  for (int i = 0; i < kIterations; ++i) {
    const Distorted d = distort(lens, x, y);
    const double du = u - d.x, dv = v - d.y, determinant = d.xx * d.yy - d.xy * d.xy;
    if (std::abs(du) + std::abs(dv) < kPrecision || !(std::abs(determinant) > 1e-3)) break;
    x += (d.yy * du - d.xy * dv) / determinant;
    y += (d.xx * dv - d.xy * du) / determinant;
  }
  return {x, y, 1};
}

LensModel lensWithoutDistortion(int width, int height, double horizontal_deg) {
  const double f = 0.5 * width / std::tan(horizontal_deg * std::numbers::pi / 360);
  return {.width = width, .height = height, .fx_px = f, .fy_px = f, .cx_px = 0.5 * width, .cy_px = 0.5 * height};
}

LensModel scaledLens(const LensModel& lens, int width, int height) {
  LensModel scaled = lens;
  const double sx = double(width) / lens.width, sy = double(height) / lens.height;
  scaled.width = width, scaled.height = height;
  scaled.fx_px *= sx, scaled.cx_px *= sx, scaled.fy_px *= sy, scaled.cy_px *= sy;
  return scaled;
}

std::string lensText(const LensModel& lens) {
  const nlohmann::ordered_json json{{"width", lens.width}, {"height", lens.height}, {"fx_px", lens.fx_px},
                                    {"fy_px", lens.fy_px}, {"cx_px", lens.cx_px},   {"cy_px", lens.cy_px},
                                    {"k1", lens.k1},       {"k2", lens.k2},         {"k3", lens.k3},
                                    {"p1", lens.p1},       {"p2", lens.p2}};
  return json.dump(2) + "\n";
}

Result<LensModel> parseLens(std::string_view text) {
  const auto json = parsedJson(text, "The lens");
  if (!json) return tl::unexpected(json.error());
  JsonEntry entry(*json, "The lens",
                  {"width", "height", "fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "k3", "p1", "p2"});
  LensModel lens;
  lens.width = entry.integer("width", 16, int(kMaxSize)), lens.height = entry.integer("height", 16, int(kMaxSize));
  lens.fx_px = entry.number("fx_px", 1, 10 * kMaxSize), lens.fy_px = entry.number("fy_px", 1, 10 * kMaxSize);
  lens.cx_px = entry.number("cx_px", -kMaxSize, 2 * kMaxSize),
  lens.cy_px = entry.number("cy_px", -kMaxSize, 2 * kMaxSize);
  lens.k1 = entry.number("k1", -kMaxDistortion, kMaxDistortion);
  lens.k2 = entry.number("k2", -kMaxDistortion, kMaxDistortion);
  lens.k3 = entry.number("k3", -kMaxDistortion, kMaxDistortion);
  lens.p1 = entry.number("p1", -1, 1), lens.p2 = entry.number("p2", -1, 1);
  if (!entry.error().empty()) return fail(entry.error());
  return lens;
}

Result<LensModel> readLens(const std::filesystem::path& file) {
  const auto text = readTextFile(file);
  if (!text) return tl::unexpected(text.error());
  auto lens = parseLens(*text);
  if (!lens) return fail(file.string() + ": " + lens.error().message);
  return lens;
}

Result<void> writeLens(const LensModel& lens, const std::filesystem::path& file) {
  return writeAtomically(file, lensText(lens));
}

}  // namespace insonate
