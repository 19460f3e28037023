#include "ControlMark.h"

#include <insonate/ui/Theme.h>

#include <QPainter>
#include <QPolygonF>
#include <QPushButton>

namespace insonate::train {
namespace {

constexpr int kFrame_px = 2;
/// The arrow's tip ends inside the control, above its text.
constexpr int kArrow_px = 8, kInside_px = 5;

void setPrimary(QWidget* control, bool isPrimary) {
  if (auto* button = qobject_cast<QPushButton*>(control)) ui::setRole(button, isPrimary ? "primary" : "");
}

}  // namespace

ControlMark::ControlMark(QWidget& window) : QWidget(&window) {
  setObjectName("controlMark");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void ControlMark::pointAt(const QString& control) {
  QWidget& window = *parentWidget();
  if (control.isEmpty() || !control_ || control_->objectName() != control) {
    setPrimary(control_, false);
    control_ = control.isEmpty() ? nullptr : window.findChild<QWidget*>(control);
    setPrimary(control_, true);
  }
  const bool isSeen = control_ && control_->isVisible() && control_->isEnabled() &&
                      control_->visibleRegion().boundingRect() == control_->rect();
  setVisible(isSeen);
  if (!isSeen) return;
  const QRect around(control_->mapTo(&window, QPoint()), control_->size());
  const QRect place = around.adjusted(-kFrame_px, kInside_px - kArrow_px, kFrame_px, kFrame_px);
  if (geometry() == place) return;
  setGeometry(place);
  raise();
}

void ControlMark::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor accent = ui::toQColor(views::theme::kAccent);
  const int above_px = kArrow_px - kInside_px;
  const QRectF frame = QRectF(rect()).adjusted(1, above_px - 1, -1, -1);
  painter.setPen(QPen(accent, kFrame_px));
  painter.drawRoundedRect(frame, 4, 4);
  const double middle = width() / 2.0;
  painter.setPen(Qt::NoPen);
  painter.setBrush(accent);
  painter.drawPolygon(QPolygonF({{middle - kArrow_px, 0}, {middle + kArrow_px, 0}, {middle, double(kArrow_px)}}));
}

}  // namespace insonate::train
