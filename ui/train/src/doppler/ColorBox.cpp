#include "ColorBox.h"

#include "../layout/CanvasGeometry.h"
#include "../model/ImagingModel.h"

#include <insonate/ui/CanvasInput.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QMouseEvent>
#include <QWidget>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr double kCornerReach_px = 10, kBorderReach_px = 6;

}  // namespace

ColorBox::ColorBox(ImagingModel& imaging, views::UltrasoundView& view, QWidget& canvas, QObject* parent)
    : QObject(parent), imaging_(imaging), view_(view), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Handle, *this);
}

bool ColorBox::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_ || !(imaging_.setup().color || held_)) return false;
  if (event->type() != QEvent::MouseButtonPress && event->type() != QEvent::MouseMove &&
      event->type() != QEvent::MouseButtonRelease)
    return false;
  const auto& mouse = *static_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::MouseButtonPress) {
    if (mouse.button() != Qt::LeftButton || mouse.modifiers() != Qt::NoModifier) return false;
    held_ = partAt(pixelOf(mouse));
    if (held_) last_ = placeOf(pixelOf(mouse));
    return held_.has_value();
  }
  if (!held_) return false;
  drag(placeOf(pixelOf(mouse)));
  if (event->type() == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton) held_.reset();
  return true;
}

QPointF ColorBox::pixelOf(const QMouseEvent& event) const {
  return (event.localPos() + QPointF(0.5, 0.5)) * canvas_.devicePixelRatioF();
}

ColorBox::Place ColorBox::placeOf(QPointF at_px) const {
  ImagingSettings beams = imaging_.settings();
  beams.steering_deg = imaging_.color().steering_deg;
  const BeamGrid grid(imaging_.probe(), beams);
  const views::ImagePoint at = view_.imageFromDisplay({at_px.x(), at_px.y()});
  const BeamGrid::Location place = grid.locate(at.lateral_mm, at.axial_mm);
  return {(place.scanline + 0.5) / grid.scanlines(), grid.range_mm(place.sample)};
}

std::optional<int> ColorBox::partAt(QPointF at_px) const {
  const ColorSettings color = fitted(imaging_.color(), imaging_.probe(), imaging_.settings());
  const auto corners = colorBoxCorners(imaging_.probe(), imaging_.settings(), color);
  std::array<QPointF, 4> pixels;
  for (int k = 0; k < 4; ++k) {
    const views::DisplayPoint at = view_.displayFromImage({corners[k].x, corners[k].z});
    pixels[k] = {at.x, at.y};
    const QPointF off = pixels[k] - at_px;
    if (std::hypot(off.x(), off.y()) <= kCornerReach_px) return k;
  }
  for (int k = 0; k < 4; ++k)
    if (distanceToSegment(at_px, pixels[k], pixels[(k + 1) % 4]) <= kBorderReach_px) return kBorder;
  return std::nullopt;
}

void ColorBox::drag(Place to) {
  ColorSettings color = fitted(imaging_.color(), imaging_.probe(), imaging_.settings());
  double across = to.across - last_.across, down_mm = to.range_mm - last_.range_mm;
  last_ = to;
  if (*held_ == kBorder) {
    // The box keeps its size at the edges of the image.
    across = std::clamp(across, -color.left, std::max(-color.left, 1 - color.right));
    down_mm =
        std::clamp(down_mm, -color.near_mm, std::max(-color.near_mm, imaging_.settings().depth_mm - color.far_mm));
    color.left += across, color.right += across, color.near_mm += down_mm, color.far_mm += down_mm;
  } else {
    (*held_ == 0 || *held_ == 3 ? color.left : color.right) += across;
    (*held_ <= 1 ? color.near_mm : color.far_mm) += down_mm;
  }
  imaging_.setColor(imaging_.isColorOn(), color);
}

}  // namespace insonate::train
