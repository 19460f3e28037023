#include "sheet/BodyNet.h"

#include <insonate/camera/HandsSheet.h>
#include <insonate/camera/LensCalibration.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

using camera::BodyNet;

constexpr double kMargin_mm = 7;  // printers leave an edge white
constexpr double kFoot_mm = 30;   // for ruler and text
constexpr double kTab_mm = 4, kTabSlope_deg = 30;
constexpr double kText_mm = 3, kLine_mm = 4.2;

SheetPage emptyPage(PaperSize paper) {
  SheetPage page;
  page.width_mm = paper == PaperSize::kA4 ? 210 : 215.9, page.height_mm = paper == PaperSize::kA4 ? 297 : 279.4;
  return page;
}

void addLine(SheetPage& page, SheetPoint from, SheetPoint to, SheetLineKind kind) {
  page.lines.push_back({from, to, kind});
}

/// Ruler and text at the foot of the page.
void addFoot(SheetPage& page, const std::vector<std::string>& texts) {
  const double left = kMargin_mm + 3, base = page.height_mm - kMargin_mm - 4;
  addLine(page, {left, base}, {left + 100, base}, SheetLineKind::kRuler);
  for (int mm = 0; mm <= 100; mm += 5)
    addLine(page, {left + mm, base}, {left + mm, base - (mm % 10 == 0 ? 3 : 1.5)}, SheetLineKind::kRuler);
  page.texts.push_back(
      {{left, base + 4}, kText_mm, "This ruler must measure 100 mm. Otherwise print again at 100 % (actual size)."});
  double y = base - 5 - kLine_mm * double(texts.size() - 1);
  for (const std::string& text : texts) {
    page.texts.push_back({{left, y}, kText_mm, text});
    y += kLine_mm;
  }
}

struct Extent {
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
};

Extent extentOf(const BodyNet& net) {
  Extent e;
  for (const auto& edge : net.edges) {
    const double margin = edge.hasTab ? kTab_mm : 0;
    e.left = std::min(e.left, edge.from.x - margin), e.right = std::max(e.right, edge.from.x + margin);
    e.low = std::min(e.low, edge.from.y - margin), e.high = std::max(e.high, edge.from.y + margin);
    e.left = std::min(e.left, edge.to.x - margin), e.right = std::max(e.right, edge.to.x + margin);
    e.low = std::min(e.low, edge.to.y - margin), e.high = std::max(e.high, edge.to.y + margin);
  }
  return e;
}

/// A tab outside of a cut edge. The face is on the left of the edge, from `from` to `to`, as seen from outside.
void addTab(SheetPage& page, SheetPoint from, SheetPoint to) {
  const double length = std::hypot(to.x_mm - from.x_mm, to.y_mm - from.y_mm);
  const double inset = std::min(kTab_mm / std::tan(kTabSlope_deg * std::numbers::pi / 180), 0.4 * length);
  const double ux = (to.x_mm - from.x_mm) / length, uy = (to.y_mm - from.y_mm) / length;
  // Page coordinates have y down, so that the outside is at the left of the direction.
  const double nx = -uy, ny = ux;
  const SheetPoint a{from.x_mm + inset * ux + kTab_mm * nx, from.y_mm + inset * uy + kTab_mm * ny};
  const SheetPoint b{to.x_mm - inset * ux + kTab_mm * nx, to.y_mm - inset * uy + kTab_mm * ny};
  addLine(page, from, to, SheetLineKind::kFold);
  addLine(page, from, a, SheetLineKind::kCut);
  addLine(page, a, b, SheetLineKind::kCut);
  addLine(page, b, to, SheetLineKind::kCut);
}

void addHandle(SheetPage& page, SheetPoint middle) {
  constexpr double kArm_mm = 3;
  addLine(page, {middle.x_mm - kArm_mm, middle.y_mm}, {middle.x_mm + kArm_mm, middle.y_mm}, SheetLineKind::kRuler);
  addLine(page, {middle.x_mm, middle.y_mm - kArm_mm}, {middle.x_mm, middle.y_mm + kArm_mm}, SheetLineKind::kRuler);
}

/// The net in the direction in which it needs the least of the page; no value if it fits in no direction.
std::optional<BodyNet> fittingNet(const BodyNet& net, double width_mm, double height_mm) {
  std::optional<BodyNet> best;
  double least = 1;
  for (int degrees = 0; degrees < 180; ++degrees) {
    BodyNet candidate = turned(net, degrees * std::numbers::pi / 180);
    const Extent e = extentOf(candidate);
    const double share = std::max((e.right - e.left) / width_mm, (e.high - e.low) / height_mm);
    if (share <= least) least = share, best = std::move(candidate);
  }
  return best;
}

SheetPage boardPage(PaperSize paper) {
  SheetPage page = emptyPage(paper);
  const double middleX = page.width_mm / 2, middleY = (page.height_mm - kFoot_mm) / 2 + 2;
  for (const BodyTag& tag : lensBoard()) {
    SheetTag printed{tag.id, {}};
    const auto corners = cornersOf(tag);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 p = tag.bodyFromTag * corners[i];
      printed.corners[i] = {middleX + p.x, middleY - p.y};
    }
    page.tags.push_back(printed);
  }
  addFoot(
      page,
      {"Board for the calibration of the lens: glue this page flat onto stiff cardboard. Show it to the camera in",
       "ten or more places and directions: near, far, in each corner, tilted to each side. Hold it still each time."});
  return page;
}

SheetPage outlinePage(PaperSize paper) {
  SheetPage page = emptyPage(paper);
  const double x = page.width_mm / 2, y = page.height_mm / 2;
  constexpr double kHalfWidth_mm = 25, kHalfHeight_mm = 8, kArrow_mm = 15;
  const SheetPoint corners[4] = {{x - kHalfWidth_mm, y - kHalfHeight_mm},
                                 {x + kHalfWidth_mm, y - kHalfHeight_mm},
                                 {x + kHalfWidth_mm, y + kHalfHeight_mm},
                                 {x - kHalfWidth_mm, y + kHalfHeight_mm}};
  for (int i = 0; i < 4; ++i) addLine(page, corners[i], corners[(i + 1) % 4], SheetLineKind::kOutline);
  const SheetPoint point{x + kHalfWidth_mm + kArrow_mm, y};
  addLine(page, {x + kHalfWidth_mm, y}, point, SheetLineKind::kOutline);
  for (const double side : {-3.0, 3.0})
    addLine(page, point, {point.x_mm - 5, point.y_mm + side}, SheetLineKind::kOutline);
  addHandle(page, {x, y});
  page.texts.push_back({{point.x_mm + 3, point.y_mm + 1}, kText_mm, "marker side"});
  addFoot(page,
          {"Place of the patient: tape this page to the desk in view of the camera. Hold the face of the probe on the",
           "rectangle, with the marker toward the arrow, upright and still for a second."});
  return page;
}

}  // namespace

Result<SheetPage> netPage(const TagBody& body, PaperSize paper) {
  SheetPage page = emptyPage(paper);
  const double width = page.width_mm - 2 * kMargin_mm, height = page.height_mm - 2 * kMargin_mm - kFoot_mm;
  const auto net = fittingNet(camera::unfolded(body), width, height);
  if (!net) return fail("The surface of the body '" + body.name + "' is larger than the page. Make the body smaller.");
  const Extent e = extentOf(*net);
  const double left = kMargin_mm + (width - (e.right - e.left)) / 2 - e.left;
  const double top = kMargin_mm + (height - (e.high - e.low)) / 2 + e.high;
  const auto place = [&](BodyNet::Point p) { return SheetPoint{left + p.x, top - p.y}; };
  for (const auto& edge : net->edges) {
    if (edge.hasTab)
      addTab(page, place(edge.from), place(edge.to));
    else
      addLine(page, place(edge.from), place(edge.to), edge.isFold ? SheetLineKind::kFold : SheetLineKind::kCut);
  }
  for (const auto& tag : net->tags) {
    SheetTag printed{tag.id, {}};
    for (std::size_t i = 0; i < 4; ++i) printed.corners[i] = place(tag.corners[i]);
    page.tags.push_back(printed);
  }
  for (const auto& handle : net->handles) addHandle(page, place(handle));
  const Vec3 tip = body.bodyFromTool.offset;
  addFoot(page, {"Body of the " + body.name +
                     ": print on thin cardboard. Cut along solid lines. Fold backward along dashed lines.",
                 "The tags are outside; glue the tabs inside. Fix the handle upright in the middle of the face with "
                 "the cross. Its",
                 "end must be " + std::to_string(int(std::lround(norm(tip)))) +
                     " mm from the middle of the body. Pivoting the tool measures this exactly."});
  return page;
}

Result<std::vector<SheetPage>> handsSheet(PaperSize paper) {
  std::vector<SheetPage> pages;
  for (const std::string& name : tagBodyNames()) {
    const auto body = loadTagBody(name);
    if (!body) return tl::unexpected(body.error());
    auto page = netPage(*body, paper);
    if (!page) return tl::unexpected(page.error());
    pages.push_back(std::move(*page));
  }
  pages.push_back(boardPage(paper));
  pages.push_back(outlinePage(paper));
  return pages;
}

}  // namespace insonate
