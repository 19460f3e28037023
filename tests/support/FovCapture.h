#pragma once

#include <insonate/ultrasound/FovFit.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace insonate::test {

/// A made-up screen capture of a machine, whose field of view is known.
struct FovCapture {
  FovShape shape;
  int width = 960, height = 720;
  double ground = 0, slope = 0;  ///< gray of the surroundings, and how much it rises across the image
  double noise = 0;              ///< SD over the whole image
  bool text = false, bars = false, artefacts = false, darkOnLight = false;
  bool darkLeft = false, darkEnd = false, shadows = false;  ///< echo-free tissue that touches the border
  double cutRight = 0, cutEnd = 0;                          ///< share of the half width, of the depth, that is cut off
  double mark_px = 0;                                       ///< between the depth scale's marks; 0 for none
  int longEvery = 0;
  unsigned seed = 1;
};

class CapturePainter {
 public:
  explicit CapturePainter(const FovCapture& capture) : c_(capture), state_(capture.seed * 2654435761U + 12345U) {
    picture_.assign(std::size_t(c_.width) * c_.height, 0);
  }

  GrayImage paint() {
    for (int y = 0; y < c_.height; ++y)
      for (int x = 0; x < c_.width; ++x) at(x, y) = c_.ground + c_.slope * x / c_.width;
    tissue();
    if (c_.mark_px > 0) marks();
    if (c_.text) letters();
    if (c_.bars) bars();
    for (double& value : picture_) value = std::clamp(value + c_.noise * normal(), 0.0, 255.0);
    if (c_.artefacts) blocks();
    GrayImage result{c_.width, c_.height, {}};
    for (const double value : picture_) {
      const long gray = std::clamp(std::lround(value), 0L, 255L);
      result.gray.push_back(std::uint8_t(c_.darkOnLight ? 255 - gray : gray));
    }
    return result;
  }

 private:
  double& at(int x, int y) { return picture_[std::size_t(y) * c_.width + x]; }
  double uniform() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return double(state_ >> 40) / double(1ULL << 24);
  }
  double normal() { return std::sqrt(-2 * std::log(uniform() + 1e-9)) * std::cos(2 * std::numbers::pi * uniform()); }

  /// Along and across the axis, from the origin.
  PixelPoint local(double x, double y) const {
    const double t = c_.shape.rotation_deg * std::numbers::pi / 180, dx = x - c_.shape.origin.x;
    const double dy = (y - c_.shape.origin.y) * (c_.shape.upsideDown ? -1 : 1);
    return {std::cos(t) * dx - std::sin(t) * dy, std::sin(t) * dx + std::cos(t) * dy};
  }

  /// Distance beyond the border of what is on display (below 0 inside), and place in it: across -1..1, down 0..1.
  double place(double x, double y, double& across, double& down) const {
    const PixelPoint p = local(x, y);
    double beyond = 0;
    const FovShape& s = c_.shape;
    if (s.shape == ProbeShape::Linear) {
      across = p.x / (s.width_px / 2), down = p.y / s.depth_px;
      beyond = std::max({std::abs(p.x) - s.width_px / 2, -p.y, p.y - s.depth_px});
    } else {
      const double radius = std::hypot(p.x, p.y), angle = std::atan2(p.x, p.y);
      const double half = s.alpha_deg / 2 * std::numbers::pi / 180;
      across = angle / half, down = (radius - s.r1_px) / (s.r2_px - s.r1_px);
      beyond = std::max({radius * std::sin(std::min(std::abs(angle) - half, 1.5)), s.r1_px - radius, radius - s.r2_px});
    }
    // The screen cuts straight, whichever way the probe is turned.
    if (c_.cutRight > 0) beyond = std::max(beyond, x - (s.origin.x + (1 - c_.cutRight) * widest()));
    const double end = s.shape == ProbeShape::Linear ? s.depth_px : s.r2_px;
    const double below = (y - s.origin.y) * (s.upsideDown ? -1 : 1);
    if (c_.cutEnd > 0) beyond = std::max(beyond, below - (1 - c_.cutEnd) * end);
    return beyond;
  }
  double widest() const {
    return c_.shape.shape == ProbeShape::Linear
               ? c_.shape.width_px / 2
               : c_.shape.r2_px * std::sin(c_.shape.alpha_deg / 2 * std::numbers::pi / 180);
  }

  /// Speckle of some pixels' size: a complex field, summed over a box.
  std::vector<double> speckle() {
    std::vector<double> sum(picture_.size(), 0);
    for (int part = 0; part < 2; ++part) {
      std::vector<double> field(picture_.size());
      for (double& value : field) value = normal();
      for (int y = 2; y + 2 < c_.height; ++y)
        for (int x = 2; x + 2 < c_.width; ++x) {
          double box = 0;
          for (int j = -1; j <= 1; ++j)
            for (int i = -2; i <= 2; ++i) box += field[std::size_t(y + j) * c_.width + x + i];
          sum[std::size_t(y) * c_.width + x] += box * box / 30;
        }
    }
    return sum;
  }

  double echo(double across, double down) const {
    double level = 150 - 70 * down + 12 * std::sin(40 * down + 3 * across);
    const auto hole = [&](double u, double v, double a, double b) {
      if (std::hypot((across - u) / a, (down - v) / b) < 1) level = -200;
    };
    hole(0.15, 0.45, 0.25, 0.12);
    if (c_.darkLeft) hole(-1, 0.5, 0.35, 0.2), hole(1, 0.8, 0.2, 0.12);
    if (c_.darkEnd) hole(-0.2, 1, 0.45, 0.16), level -= 50 * down;
    if (c_.shadows && (std::abs(across + 0.5) < 0.06 || std::abs(across - 0.8) < 0.1) && down > 0.3) level = -200;
    return level;
  }

  void tissue() {
    const std::vector<double> amplitude = speckle();
    for (int y = 0; y < c_.height; ++y)
      for (int x = 0; x < c_.width; ++x) {
        double across = 0, down = 0;
        const double inside = std::clamp(0.5 - place(x, y, across, down), 0.0, 1.0);
        if (inside == 0) continue;
        const double power = amplitude[std::size_t(y) * c_.width + x] + 1e-4;
        const double gray = std::clamp(echo(across, down) + 22 * std::log(power), 0.0, 255.0);
        at(x, y) += inside * (std::max(gray, at(x, y)) - at(x, y));
      }
  }

  void marks() {
    const FovShape& s = c_.shape;
    const bool fan = s.shape != ProbeShape::Linear;
    const double depth = depthOf_px(s), first = fan ? s.r1_px : 0;
    const double t = s.rotation_deg * std::numbers::pi / 180, beside = widest() + 24;
    for (int k = 0; k * c_.mark_px <= depth + 0.5; ++k) {
      const int length = c_.longEvery > 0 && k % c_.longEvery == 0 ? 12 : 6;
      for (double u = beside; u < beside + length; u += 0.5)
        for (double v = -0.5; v <= 0.5; v += 0.5) {
          const double along = first + k * c_.mark_px + v;
          const double dy = -std::sin(t) * u + std::cos(t) * along;
          const double x = s.origin.x + std::cos(t) * u + std::sin(t) * along;
          const double y = s.origin.y + (s.upsideDown ? -dy : dy);
          if (x >= 0 && y >= 0 && x < c_.width - 1 && y < c_.height - 1) at(int(x + 0.5), int(y + 0.5)) = 210;
        }
    }
  }

  void box(int left, int top, int wide, int high, double gray) {
    for (int y = std::max(0, top); y < std::min(c_.height, top + high); ++y)
      for (int x = std::max(0, left); x < std::min(c_.width, left + wide); ++x) at(x, y) = gray;
  }
  void word(int left, int top, int count) {
    for (int k = 0; k < count; ++k, left += 9)
      for (int stroke = 0; stroke < 3; ++stroke) {
        const int x = left + int(uniform() * 5), y = top + int(uniform() * 8);
        if (uniform() < 0.5)
          box(x, top, 2, 11, 205);
        else
          box(left, y, 7, 2, 205);
      }
  }
  void letters() {
    for (int line = 0; line < 5; ++line) word(8, 10 + 16 * line, 8 + int(uniform() * 5));
    for (int line = 0; line < 7; ++line) word(c_.width - 110, 30 + 17 * line, 5 + int(uniform() * 5));
    word(c_.width / 2 - 120, c_.height - 16, 26);
    // Over the border and inside of it, as annotations are.
    const PixelPoint side = pointAtFraction(c_.shape, -1, 0.55), middle = pointAtFraction(c_.shape, 0.2, 0.3);
    word(int(side.x) - 45, int(side.y), 8);
    word(int(middle.x), int(middle.y), 6);
  }
  void bars() {
    for (int y = 0; y < 180; ++y) box(c_.width - 26, c_.height / 2 - 90 + y, 12, 1, 240 - 235 * y / 180.0);
    box(0, c_.height - 3, c_.width, 3, 90);
    for (int y = 0; y < 36; ++y)
      for (int x = 0; x < 60; ++x)
        if (std::hypot(x - 30, y - 18) < 17 || (x / 6 + y / 6) % 3 == 0) at(12 + x, c_.height - 60 + y) = 180;
  }

  /// Blocks of 8 x 8 whose cosine coefficients are rounded, as JPEG does.
  void blocks() {
    constexpr double kStep = 22;
    double cosine[8][8];
    for (int k = 0; k < 8; ++k)
      for (int n = 0; n < 8; ++n)
        cosine[k][n] = (k == 0 ? std::sqrt(0.125) : 0.5) * std::cos((2 * n + 1) * k * std::numbers::pi / 16);
    for (int top = 0; top + 8 <= c_.height; top += 8)
      for (int left = 0; left + 8 <= c_.width; left += 8) block(left, top, cosine, kStep);
  }
  void block(int left, int top, const double (&cosine)[8][8], double step) {
    double half[8][8] = {}, whole[8][8] = {}, back[8][8] = {};
    for (int y = 0; y < 8; ++y)
      for (int k = 0; k < 8; ++k)
        for (int n = 0; n < 8; ++n) half[y][k] += cosine[k][n] * at(left + n, top + y);
    for (int j = 0; j < 8; ++j)
      for (int k = 0; k < 8; ++k) {
        for (int n = 0; n < 8; ++n) whole[j][k] += cosine[j][n] * half[n][k];
        whole[j][k] = std::round(whole[j][k] / step) * step;
      }
    for (int y = 0; y < 8; ++y)
      for (int k = 0; k < 8; ++k)
        for (int j = 0; j < 8; ++j) back[y][k] += cosine[j][y] * whole[j][k];
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        double value = 0;
        for (int k = 0; k < 8; ++k) value += cosine[k][x] * back[y][k];
        at(left + x, top + y) = value;
      }
  }

  const FovCapture& c_;
  std::uint64_t state_;
  std::vector<double> picture_;
};

inline GrayImage paint(const FovCapture& capture) {
  return CapturePainter(capture).paint();
}

}  // namespace insonate::test
