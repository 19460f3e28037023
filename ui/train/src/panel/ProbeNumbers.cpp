#include "ProbeNumbers.h"

#include <insonate/ui/Theme.h>

#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kBoxMargin_px = 14;

struct Row {
  HandAxis axis;
  const char* name;
  const char* unit;
  double low, high, step;
};
constexpr Row kRows[] = {
    {HandAxis::Rotation, "rotation", "°", -180, 180, 2},
    {HandAxis::Tilt, "tilt", "°", -ProbeHand::kMostAngle_deg, ProbeHand::kMostAngle_deg, 1},
    {HandAxis::Rock, "rock", "°", -ProbeHand::kMostAngle_deg, ProbeHand::kMostAngle_deg, 1},
    {HandAxis::Press, "press", " mm", -ProbeHand::kLift_mm, ProbeHand::kMostPress_mm, 0.5},
};

QString side(double mm, const char* positive, const char* negative) {
  return QStringLiteral("%1 %2").arg(QLatin1String(mm >= 0 ? positive : negative)).arg(std::abs(mm), 0, 'f', 1);
}

}  // namespace

ProbeNumbers::ProbeNumbers(QWidget* parent) : QWidget(parent), place_(new QLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const Row& row = kRows[i];
    auto* box = new QDoubleSpinBox(this);
    box->setObjectName(row.name);
    box->setAccessibleName(QLatin1String(row.name));
    box->setRange(row.low, row.high);
    box->setSingleStep(row.step);
    box->setDecimals(1);
    box->setSuffix(QString::fromUtf8(row.unit));
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAlignment(Qt::AlignRight);
    box->setKeyboardTracking(false);
    box->setMinimumWidth(box->fontMetrics().horizontalAdvance("-180.0°") + kBoxMargin_px);
    fields_[i] = {row.axis, box};
    auto* name = new QLabel(QLatin1String(row.name), this);
    ui::setRole(name, "quiet");
    const int column = int(i % 2) * 2, line = int(i / 2);
    grid->addWidget(name, line, column);
    grid->addWidget(box, line, column + 1);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this, axis = row.axis](double value) {
      if (typed_) typed_(axis, value);
    });
  }
  place_->setObjectName("place");
  ui::setRole(place_, "quiet");
  place_->setToolTip(tr("Where the probe touches the skin, in mm of the CT"));
  grid->addWidget(place_, 2, 0, 1, 4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
}

void ProbeNumbers::show(const HandNumbers& numbers) {
  for (const Field& field : fields_) {
    const QSignalBlocker quiet(field.box);
    field.box->setValue(numbers.of(field.axis));
  }
  // LPS: x grows to the patient's left, y to the back, z to the head.
  place_->setText(side(numbers.skin_mm.x, "L", "R") + "   " + side(numbers.skin_mm.y, "P", "A") + "   " +
                  side(numbers.skin_mm.z, "S", "I") + " mm");
}

}  // namespace insonate::train
