#include "NumberField.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QToolTip>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kMargin_px = 16;
constexpr double kWheelNotch = 120;  // in eighths of a degree, as Qt counts

QString said(const char* words) {
  return QCoreApplication::translate("NumberField", words);
}

}  // namespace

NumberField::NumberField(const QString& name, const QString& unit, const Range& range, QWidget* parent)
    : QLineEdit(parent), name_(name), unit_(unit), range_(range) {
  setObjectName(name);
  setAccessibleName(unit.isEmpty() ? name : said("%1 in %2").arg(name, unit.trimmed()));
  setAlignment(Qt::AlignRight);
  connect(this, &QLineEdit::editingFinished, this, [this] { apply(); });
  write();
}

QString NumberField::words(double value) const {
  const double unitInTheLastPlace = std::pow(10.0, range_.decimals);
  // No minus before a zero.
  const double rounded = std::round(value * unitInTheLastPlace) / unitInTheLastPlace + 0.0;
  return QString::number(rounded, 'f', range_.decimals) + unit_;
}

void NumberField::write() {
  setText(words(value_));  // It is not modified any more.
}

void NumberField::show(double value) {
  value_ = value;
  if (!isModified()) write();
}

void NumberField::apply() {
  if (!isModified()) return;
  const QString was = text().trimmed();
  QString written = was;
  if (!unit_.isEmpty()) written.remove(unit_.trimmed());
  bool isNumber = false;
  const double number = written.trimmed().replace(QLatin1Char(','), QLatin1Char('.')).toDouble(&isNumber);
  write();
  if (isNumber && number >= range_.low && number <= range_.high) {
    if (typed_) typed_(number);
    return;
  }
  const QString pattern = isNumber ? said("%1 must be from %2 to %3; %4 is outside this range.")
                                   : said("%1 takes a number from %2 to %3; \"%4\" is not a number.");
  const QString sentence = pattern.arg(name_, words(range_.low), words(range_.high), was);
  QToolTip::showText(mapToGlobal({0, height()}), sentence, this);
  if (refused_) refused_(sentence);
}

void NumberField::step(double steps) {
  apply();
  const double next = std::clamp(value_ + steps * range_.step, range_.low, range_.high);
  if (next != value_ && typed_) typed_(next);
}

void NumberField::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Up:
      return step(1);
    case Qt::Key_Down:
      return step(-1);
    case Qt::Key_Escape:
      if (!isModified()) return event->ignore();
      return write();
    default:
      QLineEdit::keyPressEvent(event);
  }
}

void NumberField::wheelEvent(QWheelEvent* event) {
  // A wheel that scrolls the panel does not move the probe on its way.
  if (!hasFocus()) return event->ignore();
  wheelRest_ += event->angleDelta().y() / kWheelNotch;
  const double whole = std::trunc(wheelRest_);
  wheelRest_ -= whole;
  if (whole != 0) step(whole);
  event->accept();
}

QSize NumberField::sizeHint() const {
  // Numbers of four digits are rare enough to scroll.
  const int widest = fontMetrics().horizontalAdvance(words(std::max(range_.low, -888.0)));
  return {widest + kMargin_px, QLineEdit::sizeHint().height()};
}

}  // namespace insonate::train
