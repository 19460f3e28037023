#include "SliceMeasure.h"

#include <insonate/ui/CanvasInput.h>

#include <QMouseEvent>
#include <utility>

namespace insonate::train {

SliceMeasure::SliceMeasure(views::MprView& slice, QWidget& canvas, QObject* parent)
    : QObject(parent), slice_(slice), canvas_(canvas) {
  ui::CanvasInput::of(canvas).add(ui::InputRank::Tool, *this);
}

void SliceMeasure::setKind(std::optional<views::CaliperKind> kind) {
  tool_.setKind(kind);
  take();
}

void SliceMeasure::setCalipers(std::vector<views::SliceCaliper> calipers) {
  done_ = std::move(calipers);
  tool_.clear();
  take();
}

views::ImagePoint SliceMeasure::pointAt(const QMouseEvent& event) const {
  const double ratio = canvas_.devicePixelRatioF();
  const Vec3 at_mm =
      slice_.patientFromDisplay({(event.localPos().x() + 0.5) * ratio, (event.localPos().y() + 0.5) * ratio});
  return views::onSlice(at_mm, slice_.plane().axes);
}

void SliceMeasure::take() {
  const views::SlicePlane plane = slice_.plane();
  auto all = done_;
  for (const views::Caliper& flat : tool_.calipers()) {
    views::SliceCaliper one{flat.kind, {}};
    for (std::size_t k = 0; k < flat.points.size(); ++k)
      one.points_mm[k] = views::fromSlice(flat.points[k], plane.axes, plane.center_mm);
    all.push_back(one);
  }
  if (!tool_.placing()) {
    done_ = all;
    tool_.clear();
  }
  slice_.setCalipers(std::move(all));
}

bool SliceMeasure::eventFilter(QObject* watched, QEvent* event) {
  if (watched != &canvas_ || !tool_.kind()) return false;
  const auto* const mouse = dynamic_cast<QMouseEvent*>(event);
  if (!mouse) return false;
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      if (mouse->button() != Qt::LeftButton) return false;
      canvas_.setFocus(Qt::MouseFocusReason);
      tool_.pressed(pointAt(*mouse));
      break;
    case QEvent::MouseMove:
      if (!tool_.placing()) return false;
      tool_.moved(pointAt(*mouse));
      break;
    case QEvent::MouseButtonRelease:
      if (mouse->button() != Qt::LeftButton) return false;
      tool_.released(pointAt(*mouse));
      break;
    default:
      return false;
  }
  take();
  return true;
}

}  // namespace insonate::train
