#include "PictureFrame.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::views {
namespace {

void drawDepthScale(const PictureFrame& frame, double scale, Lines& lines, Texts& texts) {
  const double x = frame.left_px - 8 * scale;
  const double numbers_mm = tickStep_mm(frame.px_per_mm, 34 * scale), ticks_mm = numbers_mm / (numbers_mm == 2 ? 2 : 5);
  const auto yOf = [&](double axial_mm) { return frame.top_px + (axial_mm - frame.minAxial_mm) * frame.px_per_mm; };
  const int count = static_cast<int>(std::floor(frame.maxAxial_mm / ticks_mm + 1e-9));
  for (int k = 0; k <= count; ++k) {
    const double depth_mm = k * ticks_mm, y = yOf(depth_mm);
    const bool numbered = std::abs(std::remainder(depth_mm, numbers_mm)) < 1e-6;
    const double length = (numbered ? 8 : 4) * scale;
    lines.segment({x - length, y}, {x, y}, {numbered ? theme::kText : theme::kQuiet, 1 * scale, numbered ? 0.9 : 0.7});
    if (!numbered) continue;
    char words[16];
    std::snprintf(words, sizeof words, "%g", depth_mm);
    texts.put({x - 12 * scale, y}, words, {12 * scale, theme::kText, false, Across::Right, Along::Center});
  }
  texts.put({x - 12 * scale, frame.top_px - 12 * scale}, "mm",
            {11 * scale, theme::kQuiet, false, Across::Right, Along::Bottom});
  if (frame.focus_mm && *frame.focus_mm <= frame.maxAxial_mm) {
    const double y = yOf(*frame.focus_mm), size = 5 * scale;
    lines.triangle({x + 1 * scale, y - size}, {x + 1 * scale, y + size}, {x + 1 * scale + 1.5 * size, y},
                   theme::kAccent);
  }
}

void drawGrayBar(const PictureFrame& frame, double scale, Lines& lines) {
  const double right = frame.right_px + 34 * scale, left = right - 10 * scale;
  const double height = std::min(0.45 * (frame.bottom_px - frame.top_px), 180 * scale), top = frame.top_px;
  constexpr int kSteps = 64;
  for (int k = 0; k < kSteps; ++k) {
    const auto gray = static_cast<std::uint8_t>(255 - 255 * k / (kSteps - 1));
    const double y0 = top + height * k / kSteps, y1 = top + height * (k + 1) / kSteps;
    lines.segment({left, (y0 + y1) / 2}, {right, (y0 + y1) / 2}, {{gray, gray, gray}, y1 - y0 + 0.5, 1});
  }
  const DisplayPoint box[4] = {{left, top}, {right, top}, {right, top + height}, {left, top + height}};
  lines.polyline(box, {theme::kLine, 1 * scale, 1}, true);
}

void drawTgc(const PictureFrame& frame, double scale, Lines& lines) {
  const double middle = frame.right_px + 12 * scale, reach = 9 * scale;
  const double height = frame.bottom_px - frame.top_px;
  lines.segment({middle, frame.top_px}, {middle, frame.bottom_px}, {theme::kLine, 1 * scale, 1});
  std::vector<DisplayPoint> curve;
  const std::size_t count = frame.tgc_dB.size();
  for (std::size_t k = 0; k < count; ++k)
    curve.push_back({middle + reach * std::clamp(frame.tgc_dB[k] / 20, -1.0, 1.0),
                     frame.top_px + height * (count > 1 ? double(k) / double(count - 1) : 0.5)});
  lines.polyline(curve, {theme::kAccent, 1.5 * scale, 0.9});
  for (const DisplayPoint& at : curve) lines.disc(at, 2 * scale, theme::kAccent);
}

}  // namespace

double tickStep_mm(double px_per_mm, double room_px) {
  for (const double step_mm : {1.0, 2.0, 5.0, 10.0, 20.0, 50.0})
    if (step_mm * px_per_mm >= room_px) return step_mm;
  return 100;
}

void drawPictureFrame(const PictureFrame& frame, double scale, int width_px, Lines& lines, Texts& texts) {
  if (frame.scale) drawDepthScale(frame, scale, lines, texts);
  if (frame.grayBar) drawGrayBar(frame, scale, lines);
  if (!frame.tgc_dB.empty()) drawTgc(frame, scale, lines);
  const double dotX = frame.marker_px.x + (frame.markerRight ? -5 : 5) * scale;
  lines.disc({dotX, frame.marker_px.y - 12 * scale}, 5 * scale, theme::kAccent);
  std::string words = frame.frozen ? "FROZEN" : "";
  if (!frame.notice.empty()) words += (words.empty() ? "" : "  \u00b7  ") + frame.notice;
  if (words.empty()) return;
  // Smaller instead of cut off in a narrow view.
  constexpr double kUsual_px = 14, kWidestLetter = 0.66;
  const double size_px = std::min(kUsual_px * scale, width_px / (kWidestLetter * double(words.size())));
  texts.put({width_px / 2.0, 4 * scale}, words, {size_px, theme::kCaution, true, Across::Center, Along::Top});
}

}  // namespace insonate::views
