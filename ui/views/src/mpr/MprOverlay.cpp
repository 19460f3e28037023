#include "../overlay/NameRows.h"
#include "../overlay/PointerMark.h"
#include "../ultrasound/CaliperDrawing.h"
#include "MprDrawing.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace insonate::views {
namespace {

/// Maximum distance of a tool's point from the slices that show it.
constexpr double kMarkNear_mm = 1;
constexpr Stroke kHalo{theme::kBlack, 3, 0.45};

void drawLetters(const SlicePlane& plane, double scale, Texts& texts) {
  const double margin = 10 * scale, w = plane.width_px, h = plane.height_px;
  TextStyle style{14 * scale, theme::kText, true, Across::Center, Along::Top};
  texts.put({w / 2, margin}, orientationLetters(plane.axes.up), style);
  style.along = Along::Bottom;
  texts.put({w / 2, h - margin}, orientationLetters(-plane.axes.up), style);
  style.along = Along::Center, style.across = Across::Left;
  texts.put({margin, h / 2}, orientationLetters(-plane.axes.right), style);
  style.across = Across::Right;
  texts.put({w - margin, h / 2}, orientationLetters(plane.axes.right), style);
}

void drawScaleBar(const SlicePlane& plane, double scale, Lines& lines, Texts& texts) {
  const double length_mm = roundLength_mm(0.22 * plane.width_px * plane.mm_per_px);
  const double right = plane.width_px - 12 * scale, left = right - length_mm / plane.mm_per_px;
  const double y = plane.height_px - 14 * scale, tick = 4 * scale;
  const DisplayPoint bar[4] = {{left, y - tick}, {left, y}, {right, y}, {right, y - tick}};
  lines.polyline(bar, {theme::kBlack, 3.5 * scale, 0.5});
  lines.polyline(bar, {theme::kText, 1.5 * scale, 1});
  char words[32];
  std::snprintf(words, sizeof words, "%g mm", length_mm);
  texts.put({(left + right) / 2, y - 7 * scale}, words,
            {12 * scale, theme::kText, false, Across::Center, Along::Bottom});
}

/// Open at its center, so that the structure there stays visible.
void drawCrosshair(Vec3 position_mm, const SlicePlane& plane, double scale, Lines& lines) {
  const DisplayPoint at = plane.displayFromPatient(position_mm);
  const double gap = 9 * scale, w = plane.width_px, h = plane.height_px;
  const DisplayPoint arms[4][2] = {{{0, at.y}, {at.x - gap, at.y}},
                                   {{at.x + gap, at.y}, {w, at.y}},
                                   {{at.x, 0}, {at.x, at.y - gap}},
                                   {{at.x, at.y + gap}, {at.x, h}}};
  for (const auto& arm : arms) {
    if (arm[0].x > arm[1].x || arm[0].y > arm[1].y) continue;
    lines.segment(arm[0], arm[1], {theme::kBlack, 3 * scale, 0.35});
    lines.segment(arm[0], arm[1], {theme::kAccent, 1 * scale, 0.85});
  }
}

void drawMarks(const MprOverlay& overlay, const SlicePlane& plane, double scale, Lines& lines, Texts& texts) {
  constexpr double kRing_px = 5;
  for (const auto& [number, position_mm] : overlay.marks_mm) {
    const DisplayPoint at = plane.displayFromPatient(position_mm);
    drawPointerMark(at, scale, lines);
    // Drawn although the crosshair is often at the same place, with the same color.
    lines.circle(at, kRing_px * scale, {theme::kBlack, 3.5 * scale, 0.6});
    lines.circle(at, kRing_px * scale, {theme::kText, 1.5 * scale, 1});
    texts.put({at.x + 9 * scale, at.y - 7 * scale}, std::to_string(number),
              {13 * scale, theme::kText, true, Across::Left, Along::Bottom});
  }
}

void drawCalipers(const MprOverlay& overlay, const SlicePlane& plane, double scale, Lines& lines, Texts& texts) {
  const auto toDisplay = [&plane](ImagePoint point) {
    return plane.displayFromPatient(fromSlice(point, plane.axes, plane.center_mm));
  };
  const double margin = 10 * scale, line = 17 * scale;
  double y = plane.height_px - margin - line * double(overlay.calipers.size());
  for (const auto& [number, caliper] : overlay.calipers) {
    drawCaliper(caliper, number, toDisplay, scale, lines, texts);
    texts.put({margin, y}, std::to_string(number) + "  " + caliperText(caliper),
              {13 * scale, theme::kText, false, Across::Left, Along::Bottom});
    y += line;
  }
}

/// The section of a ball with the slice; the circle of a flat brush.
void drawBrush(const SliceMarks::Brush& brush, const SlicePlane& plane, double scale, Lines& lines) {
  const double off_mm = std::abs(plane.distance_mm(brush.center_mm));
  if (off_mm >= (brush.flat ? kMarkNear_mm : brush.radius_mm)) return;
  const double radius_mm =
      brush.flat ? brush.radius_mm : std::sqrt(brush.radius_mm * brush.radius_mm - off_mm * off_mm);
  const double radius_px = std::max(2 * scale, radius_mm / plane.mm_per_px);
  const DisplayPoint at = plane.displayFromPatient(brush.center_mm);
  lines.circle(at, radius_px, {theme::kBlack, 3 * scale, 0.45});
  lines.circle(at, radius_px, {theme::kText, 1.2 * scale, 0.95});
}

/// A UTF-8 text without its middle if it has too many letters: start poses of one vessel differ in the last word of
/// their names, its sides in the first.
std::string shortened(const std::string& words, std::size_t letters) {
  constexpr std::size_t kLeastStart = 3;
  const auto begins = [](char c) { return (c & 0xC0) != 0x80; };
  const auto lettersIn = [&](std::string_view text) { return std::size_t(std::ranges::count_if(text, begins)); };
  const std::size_t count = lettersIn(words);
  if (count <= letters || letters < 2) return words;
  const auto letter = [&](std::size_t index) {
    std::size_t seen = 0;
    return std::ranges::find_if(words, [&](char c) { return begins(c) && seen++ == index; });
  };
  const std::size_t lastWord = lettersIn(std::string_view(words).substr(words.rfind(' ') + 1));
  const std::size_t last = std::min(lastWord, letters - 1 - std::min(letters - 1, kLeastStart));
  const std::size_t first = letters - 1 - last;
  std::string start(words.begin(), letter(first)), end(letter(count - last), words.end());
  while (start.ends_with(' ') || start.ends_with(',')) start.pop_back();
  while (end.starts_with(' ') || end.starts_with(',')) end.erase(0, 1);
  return start + "\u2026" + end;
}

/// A diamond beside its name.
void drawPlaces(const MprOverlay& overlay, const SlicePlane& plane, double scale, Lines& lines, Texts& texts) {
  const double size_px = 12 * scale;
  NameRows rows(plane.width_px, size_px);
  for (const NamedPoint* place : overlay.places) {
    const DisplayPoint at = plane.displayFromPatient(place->position_mm);
    const double r = 6 * scale;
    const DisplayPoint diamond[4] = {{at.x, at.y - r}, {at.x + r, at.y}, {at.x, at.y + r}, {at.x - r, at.y}};
    lines.polyline(diamond, {kHalo.color, kHalo.width_px * scale, kHalo.opacity}, true);
    lines.polyline(diamond, {place->color, 1.5 * scale, 1}, true);
    if (const auto name = rows.put(at, place->name.size()))
      texts.put(name->at, shortened(place->name, name->letters),
                {size_px, place->color, false, name->before ? Across::Right : Across::Left, Along::Center});
  }
}

/// The part of a path within kMarkNear_mm of the slice. Without it, a wire that runs through the slice would be a
/// point.
void drawPath(const ScenePath& path, const SlicePlane& plane, double scale, Lines& lines) {
  const double width_px = std::max(2 * scale, 2 * path.radius_mm / plane.mm_per_px);
  for (std::size_t i = 1; i < path.points_mm.size(); ++i) {
    const Vec3 a_mm = path.points_mm[i - 1], way_mm = path.points_mm[i] - a_mm;
    const double from_mm = plane.distance_mm(a_mm), step_mm = plane.distance_mm(a_mm + way_mm) - from_mm;
    double begin = 0, end = 1;  // shares of the way at which the path is near
    if (std::abs(step_mm) > 1e-9) {
      const double in = (-kMarkNear_mm - from_mm) / step_mm, out = (kMarkNear_mm - from_mm) / step_mm;
      begin = std::max(begin, std::min(in, out)), end = std::min(end, std::max(in, out));
    } else if (std::abs(from_mm) > kMarkNear_mm) {
      continue;
    }
    if (begin >= end) continue;
    const DisplayPoint part[] = {plane.displayFromPatient(a_mm + way_mm * begin),
                                 plane.displayFromPatient(a_mm + way_mm * end)};
    lines.polyline(part, {theme::kBlack, width_px + 2 * scale, 0.45});
    lines.polyline(part, {path.color, width_px, 1});
    if (from_mm * (from_mm + step_mm) <= 0 && step_mm != 0)
      lines.disc(plane.displayFromPatient(a_mm + way_mm * (-from_mm / step_mm)), width_px, path.color);
  }
}

void drawToolMarks(const SliceMarks& marks, const SlicePlane& plane, double scale, Lines& lines) {
  const auto isNear = [&](Vec3 point_mm) { return std::abs(plane.distance_mm(point_mm)) < kMarkNear_mm; };
  std::vector<DisplayPoint> line;
  for (const Vec3& point_mm : marks.line_mm)
    if (isNear(point_mm)) line.push_back(plane.displayFromPatient(point_mm));
  if (line.size() > 1) {
    lines.polyline(line, {theme::kBlack, 3.5 * scale, 0.45});
    lines.polyline(line, {theme::kAccent, 1.5 * scale, 1});
  }
  for (const Vec3& point_mm : marks.points_mm) {
    if (!isNear(point_mm)) continue;
    const DisplayPoint at = plane.displayFromPatient(point_mm);
    lines.disc(at, 5 * scale, theme::kBlack, 0.6);
    lines.disc(at, 3.5 * scale, theme::kAccent);
  }
  for (const ScenePath& path : marks.paths) drawPath(path, plane, scale, lines);
  if (marks.brush) drawBrush(*marks.brush, plane, scale, lines);
}

}  // namespace

double roundLength_mm(double longest_mm) {
  const double power = std::pow(10, std::floor(std::log10(longest_mm)));
  for (const double step : {5.0, 2.0})
    if (step * power <= longest_mm) return step * power;
  return power;
}

void drawMprOverlay(const MprOverlay& overlay, const SlicePlane& plane, double scale, Lines& lines, Texts& texts) {
  lines.begin(plane.height_px);
  texts.begin(plane.height_px);
  if (!overlay.fan.empty()) {
    lines.polyline(overlay.fan, {kHalo.color, kHalo.width_px * scale, kHalo.opacity}, true);
    lines.polyline(overlay.fan, {theme::kAccent, 1.5 * scale, 0.9}, true);
  }
  if (overlay.crosshair_mm) drawCrosshair(*overlay.crosshair_mm, plane, scale, lines);
  if (overlay.pointer_mm) drawPointerMark(plane.displayFromPatient(*overlay.pointer_mm), scale, lines);
  drawPlaces(overlay, plane, scale, lines, texts);
  drawMarks(overlay, plane, scale, lines, texts);
  drawCalipers(overlay, plane, scale, lines, texts);
  if (overlay.toolMarks) drawToolMarks(*overlay.toolMarks, plane, scale, lines);
  drawLetters(plane, scale, texts);
  drawScaleBar(plane, scale, lines, texts);
  const double margin = 10 * scale;
  // Leaves out texts that would reach the direction letters in the middle.
  const auto fits = [&](const std::string& words) {
    constexpr double kWidestLetter_px = 7.2, kMiddle_px = 20;
    return margin + kWidestLetter_px * scale * double(words.size()) < plane.width_px / 2.0 - kMiddle_px * scale;
  };
  if (fits(overlay.slice))
    texts.put({margin, margin}, overlay.slice, {12 * scale, theme::kQuiet, false, Across::Left, Along::Top});
  char window[64];
  std::snprintf(window, sizeof window, "W %.0f  L %.0f", overlay.windowLevel.window_HU, overlay.windowLevel.level_HU);
  if (fits(window))
    texts.put({margin, plane.height_px - margin}, window,
              {12 * scale, theme::kQuiet, false, Across::Left, Along::Bottom});
  lines.end();
  texts.end();
}

}  // namespace insonate::views
