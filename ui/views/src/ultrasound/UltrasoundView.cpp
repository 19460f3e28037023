#include "../overlay/ImageQuad.h"
#include "../overlay/PointerMark.h"
#include "CaliperDrawing.h"
#include "PictureFrame.h"
#include "TissueDrawing.h"

#include <insonate/views/SlicePlane.h>
#include <insonate/views/UltrasoundView.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace insonate::views {

struct UltrasoundView::Drawing {
  explicit Drawing(vtkRenderer& renderer)
      : quad(renderer, 1, true), color(renderer, 4, false), tissue(renderer), lines(renderer), texts(renderer) {}

  ImageQuad quad, color;
  TissueDrawing tissue;
  Lines lines;
  Texts texts;
};

UltrasoundView::UltrasoundView() : drawing_(std::make_unique<Drawing>(*renderer())) {}
UltrasoundView::~UltrasoundView() = default;

void UltrasoundView::setImage(const BModeImage& image) {
  const std::size_t count = std::size_t(std::max(0, image.width)) * std::max(0, image.height);
  const bool moved = image.width != shape_.width || image.height != shape_.height ||
                     image.pixel_mm != shape_.pixel_mm || image.left_mm != shape_.left_mm ||
                     image.top_mm != shape_.top_mm;
  shape_.width = image.width, shape_.height = image.height, shape_.pixel_mm = image.pixel_mm;
  shape_.left_mm = image.left_mm, shape_.top_mm = image.top_mm;
  if (count == 0 || image.gray.size() != count || !(image.pixel_mm > 0)) shape_ = {};
  if (shape_.width > 0) {
    std::memcpy(drawing_->quad.picture(image.width, image.height).data(), image.gray.data(), count);
    drawing_->quad.pictureChanged();
  }
  // A live image changes gray values only; the drawing around it does not change.
  if (moved) {
    changed();
  } else {
    requestRender();
  }
}

void UltrasoundView::setColor(const ColorImage& color) {
  if (color.empty()) {
    if (std::exchange(color_, {}).empty()) return;
    return changed();
  }
  const bool moved = color.column != color_.column || color.row != color_.row || color.width != color_.width ||
                     color.height != color_.height || color.nyquist_mmps != color_.nyquist_mmps ||
                     color.scale != color_.scale;
  color_.column = color.column, color_.row = color.row, color_.width = color.width, color_.height = color.height;
  color_.nyquist_mmps = color.nyquist_mmps, color_.scale = color.scale;
  if (color.rgba.size() != std::size_t(color.width) * color.height * 4) color_ = {};
  if (!color_.empty()) {
    std::memcpy(drawing_->color.picture(color.width, color.height).data(), color.rgba.data(), color.rgba.size());
    drawing_->color.pictureChanged();
  }
  if (moved) {
    changed();
  } else if (!color_.empty()) {
    requestRender();
  }
}

void UltrasoundView::setBounds(std::optional<ImageBounds> bounds) {
  bounds_ = bounds;
  changed();
}
void UltrasoundView::setMirrored(bool mirrored) {
  mirrored_ = mirrored;
  changed();
}
void UltrasoundView::setLateral(std::optional<Vec3> lateral) {
  const std::string marker = lateral ? patientSide(*lateral) : std::string();
  const std::string other = lateral ? patientSide(-*lateral) : std::string();
  if (marker == markerSide_ && other == otherSide_) return;
  markerSide_ = marker, otherSide_ = other;
  changed();
}
void UltrasoundView::setFocus(std::optional<double> focus_mm) {
  focus_mm_ = focus_mm;
  changed();
}
void UltrasoundView::setFrozen(bool frozen) {
  frozen_ = frozen;
  changed();
}
void UltrasoundView::setScaleVisible(bool visible) {
  scaleVisible_ = visible;
  changed();
}
void UltrasoundView::setGrayBarVisible(bool visible) {
  grayBarVisible_ = visible;
  changed();
}
void UltrasoundView::setTgc(std::span<const double> tgc_dB) {
  tgc_dB_.assign(tgc_dB.begin(), tgc_dB.end());
  changed();
}
void UltrasoundView::setPointer(std::optional<ImagePoint> point) {
  pointer_ = point;
  changed();
}
void UltrasoundView::setNotice(const std::string& words) {
  notice_ = words;
  changed();
}
void UltrasoundView::setStaleMark(const std::string& words) {
  if (words == staleMark_) return;
  constexpr double kDim = 0.35;
  staleMark_ = words;
  for (ImageQuad* quad : {&drawing_->quad, &drawing_->color}) quad->setBrightness(words.empty() ? 1 : kDim);
  changed();
}
void UltrasoundView::setCalipers(std::vector<Caliper> calipers) {
  calipers_ = std::move(calipers);
  changed();
}

void UltrasoundView::setGuide(ShapeOverlay guide) {
  guide_ = std::move(guide);
  changed();
}

void UltrasoundView::setNeedlePath(NeedlePathOverlay aim) {
  if (aim == aim_) return;
  aim_ = std::move(aim);
  changed();
}

void UltrasoundView::setLines(std::vector<LineOverlay> lines) {
  if (lines == lines_) return;
  lines_ = std::move(lines);
  changed();
}

void UltrasoundView::setNames(std::vector<NameOverlay> names) {
  if (names == names_) return;
  names_ = std::move(names);
  changed();
}

void UltrasoundView::setTissue(const TissueOverlay& tissue, bool grid, bool pressure) {
  const bool shown = gridVisible_ || pressureVisible_;
  gridVisible_ = grid, pressureVisible_ = pressure;
  if (grid || pressure) {
    tissue_.columns = tissue.columns, tissue_.rows = tissue.rows;
    tissue_.nodes.assign(tissue.nodes.begin(), tissue.nodes.end());
    tissue_.pressure_kPa.assign(tissue.pressure_kPa.begin(), tissue.pressure_kPa.end());
  } else if (!shown) {
    return;
  }
  drawTissue();
  requestRender();
}

void UltrasoundView::drawTissue() {
  const ImagePlacement place = placement();
  const DisplayPoint origin = displayFromImage({0, 0}), one = displayFromImage({1, 1});
  const bool there = shape_.width > 0;
  drawing_->tissue.draw(
      tissue_, there && gridVisible_, there && pressureVisible_,
      {place.left_px, place.top_px, place.right_px, place.bottom_px, origin, one.x - origin.x, one.y - origin.y},
      scale(), height_px());
}

void UltrasoundView::drawGuide() {
  std::vector<DisplayPoint> outline;
  for (const ImagePoint& point : guide_.outline) outline.push_back(displayFromImage(point));
  if (outline.size() > 1) drawing_->lines.polyline(outline, {theme::kAccent, 1.5 * scale(), 0.9}, true);
  for (std::size_t k = 0; k < guide_.handles.size(); ++k) {
    const DisplayPoint at = displayFromImage(guide_.handles[k]);
    const bool chosen = int(k) == guide_.chosen;
    drawing_->lines.disc(at, (chosen ? 7 : 6) * scale(), chosen ? theme::kText : theme::kAccent);
    drawing_->lines.circle(at, (chosen ? 7 : 6) * scale(), {theme::kBlack, 1.5 * scale(), 1});
    if (k >= guide_.words.size() || guide_.words[k].empty()) continue;
    // Texts that would extend outside are on the other side.
    const bool before = at.x > width_px() - 120 * scale();
    drawing_->texts.put({at.x + (before ? -12 : 12) * scale(), at.y - 8 * scale()}, guide_.words[k],
                        {13 * scale(), theme::kText, false, before ? Across::Right : Across::Left, Along::Bottom});
  }
}

void UltrasoundView::drawAim() {
  // Light on dark, so that it is seen over any tissue.
  const auto segment = [this](DisplayPoint from, DisplayPoint to) {
    drawing_->lines.segment(from, to, {theme::kBlack, 3.5 * scale(), 0.5});
    drawing_->lines.segment(from, to, {theme::kAccent, 1.5 * scale(), 1});
  };
  if (aim_.line.size() == 2) {
    constexpr double kDash_mm = 1.5, kPeriod_mm = 3;
    const ImagePoint &from = aim_.line[0], &to = aim_.line[1];
    const double length_mm = std::hypot(to.lateral_mm - from.lateral_mm, to.axial_mm - from.axial_mm);
    const auto at = [&](double way_mm) {
      const double part = way_mm / length_mm;
      return displayFromImage({from.lateral_mm + part * (to.lateral_mm - from.lateral_mm),
                               from.axial_mm + part * (to.axial_mm - from.axial_mm)});
    };
    // The first gap leaves the tip in sight.
    for (double way_mm = kDash_mm; way_mm + kDash_mm <= length_mm; way_mm += kPeriod_mm)
      if (isOnImage(at(way_mm)) && isOnImage(at(way_mm + kDash_mm))) segment(at(way_mm), at(way_mm + kDash_mm));
  }
  if (aim_.cross && isOnImage(displayFromImage(*aim_.cross))) {
    const DisplayPoint at = displayFromImage(*aim_.cross);
    const double arm = 7 * scale();
    segment({at.x - arm, at.y - arm}, {at.x + arm, at.y + arm});
    segment({at.x - arm, at.y + arm}, {at.x + arm, at.y - arm});
  }
  if (aim_.tip && isOnImage(displayFromImage(*aim_.tip))) {
    const DisplayPoint at = displayFromImage(*aim_.tip);
    drawing_->lines.circle(at, 6 * scale(), {theme::kBlack, 3.5 * scale(), 0.5});
    drawing_->lines.circle(at, 6 * scale(), {theme::kAccent, 1.5 * scale(), 1});
  }
}

void UltrasoundView::drawLines() {
  for (const LineOverlay& line : lines_) {
    const DisplayPoint from = displayFromImage(line.from), to = displayFromImage(line.to);
    drawing_->lines.segment(from, to, {theme::kBlack, (line.isFine ? 2 : 3.5) * scale(), 0.5});
    drawing_->lines.segment(from, to, {theme::kAccent, (line.isFine ? 1 : 1.8) * scale(), line.isFine ? 0.6 : 1});
  }
}

void UltrasoundView::drawNames() {
  for (const NameOverlay& name : names_) {
    const DisplayPoint at = displayFromImage(name.at);
    if (!isOnImage(at)) continue;
    for (const double off : {-1.0, 1.0})
      drawing_->texts.put({at.x + off * scale(), at.y + off * scale()}, name.words,
                          {12 * scale(), theme::kBlack, false, Across::Center, Along::Center});
    drawing_->texts.put(at, name.words, {12 * scale(), theme::kText, false, Across::Center, Along::Center});
  }
}

/// Light on dark, so that it is read over any tissue; smaller instead of cut off in a narrow view.
void UltrasoundView::drawStaleMark() {
  if (staleMark_.empty()) return;
  constexpr double kUsual_px = 17, kWidestLetter = 0.66;
  const ImagePlacement place = placement();
  const DisplayPoint at{(place.left_px + place.right_px) / 2, (place.top_px + place.bottom_px) / 2};
  const double size_px = std::min(kUsual_px * scale(), width_px() / (kWidestLetter * double(staleMark_.size())));
  for (const double off : {-1.0, 1.0})
    drawing_->texts.put({at.x + off * scale(), at.y + off * scale()}, staleMark_,
                        {size_px, theme::kBlack, true, Across::Center, Along::Center});
  drawing_->texts.put(at, staleMark_, {size_px, theme::kCaution, true, Across::Center, Along::Center});
}

ImageBounds UltrasoundView::bounds() const {
  if (bounds_) return *bounds_;
  if (shape_.width == 0) return {};
  const double left = shape_.left_mm - shape_.pixel_mm / 2, top = shape_.top_mm - shape_.pixel_mm / 2;
  return {left, left + shape_.width * shape_.pixel_mm, top, top + shape_.height * shape_.pixel_mm};
}

ImagePlacement UltrasoundView::placement() const {
  return placementOf(bounds(), width_px(), height_px(), scale());
}

double UltrasoundView::px_per_mm() const {
  return placement().px_per_mm;
}

ImagePoint UltrasoundView::imageFromDisplay(DisplayPoint at) const {
  const ImagePlacement place = placement();
  const ImageBounds shown = bounds();
  const double across_mm = (at.x - place.left_px) / place.px_per_mm;
  return {mirrored_ ? shown.maxLateral_mm - across_mm : shown.minLateral_mm + across_mm,
          shown.minAxial_mm + (at.y - place.top_px) / place.px_per_mm};
}

DisplayPoint UltrasoundView::displayFromImage(ImagePoint point) const {
  const ImagePlacement place = placement();
  const ImageBounds shown = bounds();
  const double across_mm = mirrored_ ? shown.maxLateral_mm - point.lateral_mm : point.lateral_mm - shown.minLateral_mm;
  return {place.left_px + across_mm * place.px_per_mm,
          place.top_px + (point.axial_mm - shown.minAxial_mm) * place.px_per_mm};
}

bool UltrasoundView::isOnImage(DisplayPoint at) const {
  const ImagePlacement place = placement();
  return at.x >= place.left_px && at.x < place.right_px && at.y >= place.top_px && at.y < place.bottom_px;
}

void UltrasoundView::placePicture(const ImageBounds& shown) {
  const double left_mm = shape_.left_mm - shape_.pixel_mm / 2, top_mm = shape_.top_mm - shape_.pixel_mm / 2;
  const double width_mm = shape_.width * shape_.pixel_mm, height_mm = shape_.height * shape_.pixel_mm;
  const double left = std::max(shown.minLateral_mm, left_mm), right = std::min(shown.maxLateral_mm, left_mm + width_mm);
  const double top = std::max(shown.minAxial_mm, top_mm), bottom = std::min(shown.maxAxial_mm, top_mm + height_mm);
  drawing_->quad.show(right > left && bottom > top);
  ImageQuad::Part part{(left - left_mm) / width_mm, (top - top_mm) / height_mm, (right - left_mm) / width_mm,
                       (bottom - top_mm) / height_mm};
  if (mirrored_) std::swap(part.left, part.right);
  drawing_->quad.place(displayFromImage({mirrored_ ? right : left, top}),
                       displayFromImage({mirrored_ ? left : right, bottom}), height_px(), part);
}

void UltrasoundView::placeColor(const ImageBounds& shown) {
  const double left_mm = shape_.left_mm + (color_.column - 0.5) * shape_.pixel_mm;
  const double top_mm = shape_.top_mm + (color_.row - 0.5) * shape_.pixel_mm;
  const double width_mm = color_.width * shape_.pixel_mm, height_mm = color_.height * shape_.pixel_mm;
  const double left = std::max(shown.minLateral_mm, left_mm), right = std::min(shown.maxLateral_mm, left_mm + width_mm);
  const double top = std::max(shown.minAxial_mm, top_mm), bottom = std::min(shown.maxAxial_mm, top_mm + height_mm);
  const bool there = !color_.empty() && right > left && bottom > top;
  drawing_->color.show(there);
  if (!there) return;
  ImageQuad::Part part{(left - left_mm) / width_mm, (top - top_mm) / height_mm, (right - left_mm) / width_mm,
                       (bottom - top_mm) / height_mm};
  if (mirrored_) std::swap(part.left, part.right);
  drawing_->color.place(displayFromImage({mirrored_ ? right : left, top}),
                        displayFromImage({mirrored_ ? left : right, bottom}), height_px(), part);
}

/// The scale stands below the gray bar, in the same column.
void UltrasoundView::drawColorScale() {
  if (color_.empty()) return;
  const ImagePlacement place = placement();
  const double right = place.right_px + 34 * scale(), left = right - 10 * scale();
  const double room = place.bottom_px - place.top_px;
  const double top = place.top_px + std::min(0.45 * room, 180 * scale()) + 40 * scale();
  const double height = std::min(0.35 * room, 130 * scale());
  const auto shades = static_cast<int>(color_.scale.size());
  for (int i = 0; i < shades; ++i) {
    const Rgb& shade = color_.scale[std::size_t(shades - 1 - i)];
    const double y = top + (i + 0.5) * height / shades;
    drawing_->lines.segment({left, y}, {right, y}, {{shade[0], shade[1], shade[2]}, height / shades + 1, 1});
  }
  if (color_.nyquist_mmps <= 0) return;
  const auto put = [&](double y, const std::string& words, Along along) {
    drawing_->texts.put({right, y}, words, {12 * scale(), theme::kText, false, Across::Right, along});
  };
  const double limit_cmps = color_.nyquist_mmps / 10;
  std::array<char, 16> limit{};
  std::snprintf(limit.data(), limit.size(), limit_cmps < 9.95 ? "%.1f" : "%.0f", limit_cmps);
  put(top - 4 * scale(), std::string("+") + limit.data(), Along::Bottom);
  put(top + height + 4 * scale(), std::string("-") + limit.data(), Along::Top);
  put(top + height + 20 * scale(), "cm/s", Along::Top);
}

DisplayPoint UltrasoundView::cornerOf(bool marker) const {
  const ImageBounds shown = bounds();
  // The view may have a margin around the image.
  const double left_mm = shape_.left_mm - shape_.pixel_mm / 2;
  double side_mm = marker ? left_mm + shape_.width * shape_.pixel_mm : left_mm;
  // A field of view that is being edited may be narrower than the image.
  if (!guide_.outline.empty()) {
    const auto [least, most] = std::ranges::minmax(guide_.outline, {}, &ImagePoint::lateral_mm);
    side_mm = marker ? most.lateral_mm : least.lateral_mm;
  }
  return displayFromImage({std::clamp(side_mm, shown.minLateral_mm, shown.maxLateral_mm),
                           std::max(shape_.top_mm - shape_.pixel_mm / 2, shown.minAxial_mm)});
}

void UltrasoundView::drawSides() {
  for (const bool marker : {true, false}) {
    const DisplayPoint corner = cornerOf(marker);
    const bool isRight = marker != mirrored_;
    // The probe's marker is in the corner itself.
    const double inward_px = (marker ? 16 : 2) * scale();
    drawing_->texts.put({corner.x + (isRight ? -inward_px : inward_px), corner.y - 12 * scale()},
                        marker ? markerSide_ : otherSide_,
                        {13 * scale(), theme::kText, true, isRight ? Across::Right : Across::Left, Along::Center});
  }
}

void UltrasoundView::layout() {
  const ImagePlacement place = placement();
  const ImageBounds shown = bounds();
  Lines& lines = drawing_->lines;
  Texts& texts = drawing_->texts;
  lines.begin(height_px());
  texts.begin(height_px());
  drawing_->quad.show(false);
  drawing_->color.show(false);
  if (shape_.width > 0) {
    placePicture(shown);
    placeColor(shown);
    drawColorScale();
    PictureFrame frame{place.left_px, place.top_px, place.right_px, place.bottom_px, place.px_per_mm};
    frame.minAxial_mm = shown.minAxial_mm, frame.maxAxial_mm = shown.maxAxial_mm;
    frame.focus_mm = focus_mm_, frame.tgc_dB = tgc_dB_;
    frame.scale = scaleVisible_, frame.grayBar = grayBarVisible_, frame.frozen = frozen_,
    frame.markerRight = !mirrored_, frame.notice = notice_;
    frame.marker_px = cornerOf(true);
    drawPictureFrame(frame, scale(), width_px(), lines, texts);
    drawSides();
    if (pointer_) drawPointerMark(displayFromImage(*pointer_), scale(), lines);
    const auto toDisplay = [this](ImagePoint point) { return displayFromImage(point); };
    drawLines();
    drawNames();
    drawAim();
    drawGuide();
    const double line = 17 * scale();
    double y = place.bottom_px - 8 * scale() - line * (double(calipers_.size()) - 1);
    for (std::size_t k = 0; k < calipers_.size(); ++k, y += line) {
      drawCaliper(calipers_[k], int(k) + 1, toDisplay, scale(), lines, texts);
      texts.put({place.left_px + 8 * scale(), y}, std::to_string(k + 1) + "  " + caliperText(calipers_[k]),
                {13 * scale(), theme::kText, false, Across::Left, Along::Bottom});
    }
    drawStaleMark();
  }
  if (shape_.width == 0 && !notice_.empty())
    texts.put({width_px() / 2.0, height_px() / 2.0}, notice_,
              {15 * scale(), theme::kQuiet, false, Across::Center, Along::Center});
  lines.end();
  texts.end();
  drawTissue();
}

}  // namespace insonate::views
