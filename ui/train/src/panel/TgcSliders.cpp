#include "TgcSliders.h"

#include <insonate/ui/Theme.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kRow_px = 14, kMargin_px = 6;

}  // namespace

TgcSliders::TgcSliders(QWidget* parent) : QWidget(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Time-gain compensation"));
  setToolTip(tr("Gain by depth, from the face down. Double click resets one, with Shift all."));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize TgcSliders::sizeHint() const {
  return {120, int(tgc_dB_.size()) * kRow_px};
}

void TgcSliders::setValues(const std::array<double, 8>& tgc_dB) {
  for (std::size_t i = 0; i < tgc_dB.size(); ++i) tgc_dB_[i] = std::clamp(tgc_dB[i], -kMost_dB, kMost_dB);
  update();
}

int TgcSliders::rowAt(int y) const {
  return std::clamp(y / kRow_px, 0, int(tgc_dB_.size()) - 1);
}

double TgcSliders::x(double dB) const {
  return kMargin_px + (width() - 2 * kMargin_px) * (dB + kMost_dB) / (2 * kMost_dB);
}

void TgcSliders::change(int row, double dB) {
  dB = std::clamp(std::round(dB * 2) / 2, -kMost_dB, kMost_dB);
  row_ = row;
  if (tgc_dB_[row] != dB) {
    tgc_dB_[row] = dB;
    if (changed_) changed_();
  }
  update();
}

void TgcSliders::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = ui::colour(views::theme::kLine), accent = ui::colour(views::theme::kAccent);
  QPainterPath curve;
  for (int i = 0; i < int(tgc_dB_.size()); ++i) {
    const double y = (i + 0.5) * kRow_px;
    painter.setPen(QPen(line, 2));
    painter.drawLine(QPointF(x(-kMost_dB), y), QPointF(x(kMost_dB), y));
    const QPointF at(x(tgc_dB_[i]), y);
    if (i == 0)
      curve.moveTo(at);
    else
      curve.lineTo(at);
  }
  painter.setPen(QPen(line, 1));
  painter.drawLine(QPointF(x(0), 2), QPointF(x(0), height() - 2));
  painter.setPen(QPen(accent, 1.5));
  painter.drawPath(curve);
  for (int i = 0; i < int(tgc_dB_.size()); ++i) {
    const bool current = hasFocus() && i == row_;
    painter.setPen(Qt::NoPen);
    painter.setBrush(current ? palette().color(QPalette::Text) : accent);
    painter.drawEllipse(QPointF(x(tgc_dB_[i]), (i + 0.5) * kRow_px), 4, 4);
  }
}

void TgcSliders::mousePressEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

void TgcSliders::mouseMoveEvent(QMouseEvent* event) {
  if (!(event->buttons() & Qt::LeftButton)) return;
  const double across = double(event->x() - kMargin_px) / std::max(1, width() - 2 * kMargin_px);
  change(rowAt(event->y()), (across * 2 - 1) * kMost_dB);
}

void TgcSliders::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->modifiers() & Qt::ShiftModifier) {
    setValues({});
    if (changed_) changed_();
  } else {
    change(rowAt(event->y()), 0);
  }
}

void TgcSliders::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      row_ = std::max(0, row_ - 1);
      break;
    case Qt::Key_Down:
      row_ = std::min(int(tgc_dB_.size()) - 1, row_ + 1);
      break;
    case Qt::Key_Left:
      return change(row_, tgc_dB_[row_] - 1);
    case Qt::Key_Right:
      return change(row_, tgc_dB_[row_] + 1);
    default:
      return QWidget::keyPressEvent(event);
  }
  update();
}

}  // namespace insonate::train
