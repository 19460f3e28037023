#include "GainSliders.h"

#include <insonate/ui/Theme.h>

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kGainSliders = 8;
constexpr int kSliderRow_px = 14, kSliderMargin_px = 6, kLength_px = 120, kSideBySide_px = 64;

}  // namespace

GainSliders::GainSliders(Qt::Orientation along, const QString& name, const QString& tooltip, QWidget* parent)
    : QWidget(parent), along_(along) {
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(name);
  setToolTip(tooltip);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

QSize GainSliders::sizeHint() const {
  return isStacked() ? QSize{kLength_px, kGainSliders * kSliderRow_px} : QSize{kLength_px, kSideBySide_px};
}

void GainSliders::setValues(const std::array<double, 8>& gain_dB) {
  for (std::size_t i = 0; i < gain_dB.size(); ++i) gain_dB_[i] = std::clamp(gain_dB[i], -kMost_dB, kMost_dB);
  update();
}

int GainSliders::sliderAt(QPoint place) const {
  const double share = isStacked() ? double(place.y()) / height() : double(place.x()) / width();
  return std::clamp(int(std::floor(share * kGainSliders)), 0, kGainSliders - 1);
}

double GainSliders::gainAt(QPoint place) const {
  const double share =
      isStacked() ? double(place.x() - kSliderMargin_px) / std::max(1, width() - 2 * kSliderMargin_px)
                  : double(height() - kSliderMargin_px - place.y()) / std::max(1, height() - 2 * kSliderMargin_px);
  return (share * 2 - 1) * kMost_dB;
}

QPointF GainSliders::placeOf(double slider, double gain_dB) const {
  const double share = (gain_dB + kMost_dB) / (2 * kMost_dB), along = (slider + 0.5) / kGainSliders;
  if (isStacked()) return {kSliderMargin_px + (width() - 2 * kSliderMargin_px) * share, along * height()};
  return {along * width(), height() - kSliderMargin_px - (height() - 2 * kSliderMargin_px) * share};
}

void GainSliders::change(int slider, double gain_dB) {
  gain_dB = std::clamp(std::round(gain_dB * 2) / 2, -kMost_dB, kMost_dB);
  slider_ = slider;
  if (gain_dB_[slider] != gain_dB) {
    gain_dB_[slider] = gain_dB;
    if (changed_) changed_();
  }
  update();
}

void GainSliders::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = ui::toQColor(views::theme::kLine), accent = ui::toQColor(views::theme::kAccent);
  QPainterPath curve(placeOf(0, gain_dB_[0]));
  for (int i = 0; i < kGainSliders; ++i) {
    painter.setPen(QPen(line, 2));
    painter.drawLine(placeOf(i, -kMost_dB), placeOf(i, kMost_dB));
    curve.lineTo(placeOf(i, gain_dB_[i]));
  }
  painter.setPen(QPen(line, 1));
  painter.drawLine(placeOf(-0.4, 0), placeOf(kGainSliders - 0.6, 0));
  painter.setPen(QPen(accent, 1.5));
  painter.drawPath(curve);
  for (int i = 0; i < kGainSliders; ++i) {
    const bool current = hasFocus() && i == slider_;
    painter.setPen(Qt::NoPen);
    painter.setBrush(current ? palette().color(QPalette::Text) : accent);
    painter.drawEllipse(placeOf(i, gain_dB_[i]), 4, 4);
  }
}

void GainSliders::mousePressEvent(QMouseEvent* event) {
  mouseMoveEvent(event);
}

void GainSliders::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons() & Qt::LeftButton) change(sliderAt(event->pos()), gainAt(event->pos()));
}

void GainSliders::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->modifiers() & Qt::ShiftModifier) {
    setValues({});
    if (changed_) changed_();
  } else {
    change(sliderAt(event->pos()), 0);
  }
}

void GainSliders::keyPressEvent(QKeyEvent* event) {
  const int key = event->key(), before = isStacked() ? Qt::Key_Up : Qt::Key_Left,
            after = isStacked() ? Qt::Key_Down : Qt::Key_Right, less = isStacked() ? Qt::Key_Left : Qt::Key_Down,
            more = isStacked() ? Qt::Key_Right : Qt::Key_Up;
  if (key == before)
    slider_ = std::max(0, slider_ - 1);
  else if (key == after)
    slider_ = std::min(kGainSliders - 1, slider_ + 1);
  else if (key == less)
    change(slider_, gain_dB_[slider_] - 1);
  else if (key == more)
    change(slider_, gain_dB_[slider_] + 1);
  else
    return QWidget::keyPressEvent(event);
  update();
}

}  // namespace insonate::train
