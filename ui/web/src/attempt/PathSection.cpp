#include "attempt/PathSection.h"

#include "comments/Comments.h"
#include "video/VideoFiles.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/procedure/NeedleWords.h>
#include <insonate/tissue/Labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace insonate::web {
namespace {

constexpr double kPlaneWidth = 640, kPlaneHeight = 560, kPlaneLeft = 56, kPlaneBottom = 40, kPlaneEdge = 12;
constexpr double kPlaneTick_mm = 10, kRowStep_mm = 5;

std::string rounded(double value) {
  const double tenths = std::round(value * 10) / 10;
  return numberOf(tenths == 0 ? 0 : tenths);
}

/// Positions in the drawing, with the same scale for both directions.
class PlaneScale {
 public:
  explicit PlaneScale(const PlaneArea& area)
      : area_(area),
        scale_(std::min((kPlaneWidth - kPlaneLeft - kPlaneEdge) / area.width(),
                        (kPlaneHeight - kPlaneBottom - kPlaneEdge) / area.height())) {}

  double x(double lateral_mm) const { return kPlaneLeft + (lateral_mm - area_.left) * scale_; }
  double y(double depth_mm) const { return kPlaneEdge + (depth_mm - area_.top) * scale_; }
  double size(double length_mm) const { return length_mm * scale_; }
  double width() const { return x(area_.right) + kPlaneEdge; }
  double height() const { return y(area_.bottom) + kPlaneBottom; }

 private:
  PlaneArea area_;
  double scale_;
};

Markup planeText(double x, double y, const std::string& anchor, const std::string& words,
                 const std::string& kind = {}) {
  Attributes attributes{{"x", rounded(x)}, {"y", rounded(y)}, {"text-anchor", anchor}};
  if (!kind.empty()) attributes.emplace_back("class", kind);
  return element("text", attributes, words);
}

Markup planeLine(double x1, double y1, double x2, double y2) {
  return element(
      "line", {{"x1", rounded(x1)}, {"y1", rounded(y1)}, {"x2", rounded(x2)}, {"y2", rounded(y2)}, {"class", "grid"}});
}

Markup planeGrid(const PlaneArea& area, const PlaneScale& scale) {
  Markup all;
  for (double mm = std::ceil(area.top / kPlaneTick_mm) * kPlaneTick_mm; mm <= area.bottom; mm += kPlaneTick_mm)
    all += planeLine(scale.x(area.left), scale.y(mm), scale.x(area.right), scale.y(mm)) +
           planeText(kPlaneLeft - 6, scale.y(mm) + 4, "end", rounded(mm));
  for (double mm = std::ceil(area.left / kPlaneTick_mm) * kPlaneTick_mm; mm <= area.right; mm += kPlaneTick_mm)
    all += planeLine(scale.x(mm), scale.y(area.top), scale.x(mm), scale.y(area.bottom)) +
           planeText(scale.x(mm), scale.y(area.bottom) + 16, "middle", rounded(mm));
  return all +
         planeText((scale.x(area.left) + scale.x(area.right)) / 2, scale.height() - 6, "middle",
                   "Lateral position, mm") +
         element("text",
                 {{"transform",
                   "translate(14 " + rounded((scale.y(area.top) + scale.y(area.bottom)) / 2) + ") rotate(-90)"},
                  {"text-anchor", "middle"}},
                 "Depth, mm");
}

struct ShownStructure {
  std::uint8_t label;
  const char *kind, *name;
};
constexpr std::array<ShownStructure, 5> kShownStructures{{{kSkin, "skin", "skin"},
                                                          {kBone, "bone", "bone"},
                                                          {kAirway, "airway", "airway or lung"},
                                                          {kArtery, "artery", "artery"},
                                                          {kVein, "vein", "vein"}}};

/// The area of one structure, with its name in the middle of a vessel, so that colors are not needed.
Markup structureMarkup(const NeedlePath& path, const PlaneScale& scale, const ShownStructure& shown) {
  const SectionLabels& section = path.structures;
  const std::string side = rounded(scale.size(path.pixel_mm) + 0.3);
  std::string outline;
  double columns = 0, rows = 0, count = 0;
  for (int row = 0; row < section.rows; ++row)
    for (int begin = 0; begin < section.columns; ++begin) {
      if (section.at(begin, row) != shown.label) continue;
      int end = begin;
      while (end < section.columns && section.at(end, row) == shown.label) ++end;
      const std::string length = rounded(scale.size(path.pixel_mm * (end - begin)));
      outline += "M" + rounded(scale.x(path.area.left + begin * path.pixel_mm)) + " " +
                 rounded(scale.y(path.area.top + row * path.pixel_mm)) + "h" + length + "v" + side + "h-" + length +
                 "z";
      columns += (end - begin) * (begin + end) / 2.0, rows += (end - begin) * (row + 0.5), count += end - begin;
      begin = end;
    }
  if (outline.empty()) return {};
  Markup all = element("path", {{"class", std::string("structure ") + shown.kind}, {"d", outline}},
                       element("title", {}, shown.name));
  if (shown.label == kVein || shown.label == kArtery)
    all += planeText(scale.x(path.area.left + columns / count * path.pixel_mm),
                     scale.y(path.area.top + rows / count * path.pixel_mm) + 4, "middle", shown.name, "name");
  return all;
}

std::string kindOf(NeedlePlace place) {
  return place == NeedlePlace::Vein         ? "in-vein"
         : place == NeedlePlace::WrongPlace ? "wrong-place"
         : place == NeedlePlace::Used       ? "used"
                                            : "inserted";
}

Markup pathMarkup(const NeedlePath& path, const PlaneScale& scale) {
  Markup lines, signs;
  auto before = NeedlePlace::Clean;
  for (const PathPiece& piece : path.pieces) {
    if (piece.points.empty()) continue;
    std::string points;
    for (const PathPiece::Point& one : piece.points)
      points += rounded(scale.x(one.tip_probe.x)) + "," + rounded(scale.y(one.tip_probe.z)) + " ";
    const std::string kind = kindOf(piece.place);
    lines += element("polyline", {{"class", "path " + kind + (piece.isInSlice ? "" : " beside")}, {"points", points}},
                     element("title", {}, displayText(piece.place)));
    const Vec3& first = piece.points.front().tip_probe;
    const bool isNew = piece.place != std::exchange(before, piece.place);
    if (isNew && piece.place != NeedlePlace::Clean && piece.place != NeedlePlace::UnderSkin)
      signs += planeText(scale.x(first.x), scale.y(first.z) + 5, "middle", std::string(needleSymbol(piece.place)),
                         "sign " + kind);
  }
  return lines + signs;
}

/// The first and the last point of each piece, and points in between at distances of some millimeters.
Markup pathTable(const NeedlePath& path) {
  std::vector<std::vector<Markup>> rows;
  for (const PathPiece& piece : path.pieces) {
    const PathPiece::Point* listed = nullptr;
    for (const PathPiece::Point& one : piece.points) {
      const Vec3 step = listed ? one.tip_probe - listed->tip_probe : Vec3{};
      if (listed && &one != &piece.points.back() && dot(step, step) < kRowStep_mm * kRowStep_mm) continue;
      listed = &one;
      rows.push_back({text(recordingTimeText(one.time_us)), text(displayText(piece.place)),
                      text(piece.isInSlice ? "yes" : "no"), text(rounded(one.tip_probe.x)),
                      text(rounded(one.tip_probe.z)), text(rounded(std::abs(one.tip_probe.y)))});
    }
  }
  return table(
      "Path of the needle tip",
      {"Time", "Place", "In the slice", "Lateral position, mm", "Depth, mm", "Distance from the image plane, mm"},
      rows);
}

}  // namespace

Markup drawPath(const NeedlePath& path) {
  if (path.pieces.empty() || path.area.width() <= 0 || path.area.height() <= 0)
    return paragraph("No path to show: the needle was never under the skin while a hand held the probe.");
  const PlaneScale scale(path.area);
  Markup structures;
  for (const ShownStructure& shown : kShownStructures) structures += structureMarkup(path, scale, shown);
  const std::string time = recordingTimeText(path.time_us);
  const Markup drawing =
      element("svg",
              {{"viewBox", "0 0 " + rounded(scale.width()) + " " + rounded(scale.height())},
               {"role", "img"},
               {"aria-label", "Path of the needle tip in the image plane; the table below lists its points."},
               {"class", "chart plane"}},
              planeGrid(path.area, scale) + structures + pathMarkup(path, scale));
  return element(
      "figure", {},
      element("figcaption", {}, "Needle tip in the image plane at " + time) + drawing +
          note("Dotted: the tip was outside the image's slice thickness. \u25cf marks the entry into the "
               "vein, \u25b2 a wrong place, \u25a0 a used needle. Structures are shown as in the CT, without "
               "compression.") +
          element("details", {}, element("summary", {}, "Points of the path") + pathTable(path)));
}

Markup pathSection(const Visit& visit, const std::string& attempt) {
  const VideoFiles files(visit.options.videos);
  if (!files.has(attempt)) return {};
  const auto path = files.path(attempt);
  return path ? section("Path of the needle", drawPath(*path)) : Markup();
}

}  // namespace insonate::web
