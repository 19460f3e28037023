#include "ProbeNumbers.h"

#include "../layout/NumberField.h"

#include <insonate/ui/Theme.h>

#include <QGridLayout>
#include <QLabel>

namespace insonate::train {
namespace {

struct AngleRow {
  HandAxis axis;
  const char* name;
  const char* unit;
  double low, high, step;
  const char* says;
};
constexpr AngleRow kAngleRows[] = {
    {HandAxis::Tilt, "tilt", "°", -ProbePlacement::kMaxAngle_deg, ProbePlacement::kMaxAngle_deg, 1,
     "Angle by which the image plane is tilted from the perpendicular to the skin, in degrees (W, S)"},
    {HandAxis::Rock, "rock", "°", -ProbePlacement::kMaxAngle_deg, ProbePlacement::kMaxAngle_deg, 1,
     "Angle by which the probe is rocked within the image plane, in degrees. 0: perpendicular to the skin (A, D)"},
    {HandAxis::Rotation, "rotation", "°", -180, 180, 2,
     "Rotation about the probe's long axis, in degrees. 0: transverse, with the marker to the patient's left (Q, E)"},
    {HandAxis::Press, "indentation", " mm", -ProbePlacement::kLift_mm, ProbePlacement::kMaxPress_mm, 0.5,
     "Distance by which the probe has moved into the tissue since it touched the skin, in mm. "
     "Negative: the probe is off the skin (+, -)"},
};

struct Axis {
  const char* name;
  const char* says;
};
constexpr Axis kAxes[] = {
    {"x", "Center of the probe face on the skin, in mm of the CT: x increases to the patient's left"},
    {"y", "Center of the probe face on the skin, in mm of the CT: y increases to the patient's back"},
    {"z", "Center of the probe face on the skin, in mm of the CT: z increases to the patient's head"},
};
/// No body is larger, and few scanners count from further away.
constexpr double kFar_mm = 2999;

QLabel* quiet(const char* name, QWidget* parent) {
  auto* label = new QLabel(QLatin1String(name), parent);
  ui::setRole(label, "quiet");
  return label;
}

QString hint(const char* says) {
  return QString::fromUtf8(says) + QWidget::tr("\nEnter applies the number; arrow keys and wheel change it in steps.");
}

}  // namespace

ProbeNumbers::ProbeNumbers(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  addAngles();
  addPlace();
}

void ProbeNumbers::addAngles() {
  auto* grid = static_cast<QGridLayout*>(layout());
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const AngleRow& row = kAngleRows[i];
    auto* box =
        new NumberField(QLatin1String(row.name), QString::fromUtf8(row.unit), {row.low, row.high, row.step}, this);
    box->setToolTip(hint(row.says));
    box->setTyped([this, axis = row.axis](double value) {
      if (typed_) typed_(axis, value);
    });
    box->setRefused([this](const QString& sentence) {
      if (refused_) refused_(sentence);
    });
    fields_[i] = {row.axis, box};
    // Short names stand side by side in the first line.
    const int line = i < 2 ? 0 : int(i) - 1, column = i < 2 ? int(i) * 2 : 0;
    grid->addWidget(quiet(row.name, this), line, column, 1, i < 2 ? 1 : 3);
    grid->addWidget(box, line, i < 2 ? column + 1 : 3);
  }
}

void ProbeNumbers::addPlace() {
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  for (int i = 0; i < 3; ++i) {
    auto* box = new NumberField(QLatin1String(kAxes[i].name), {}, {-kFar_mm, kFar_mm, 1}, this);
    box->setAccessibleName(tr("%1 in mm").arg(QLatin1String(kAxes[i].name)));
    box->setToolTip(hint(kAxes[i].says));
    box->setTyped([this, i](double value) {
      Vec3 place_mm = skin_mm_;
      place_mm[i] = value;
      if (placed_) placed_(place_mm);
    });
    box->setRefused([this](const QString& sentence) {
      if (refused_) refused_(sentence);
    });
    place_[i] = box;
    auto* name = quiet(kAxes[i].name, this);
    name->setToolTip(box->toolTip());
    row->addWidget(name);
    row->addWidget(box, 1);
  }
  auto* unit = quiet("mm", this);
  row->addWidget(unit);
  static_cast<QGridLayout*>(layout())->addLayout(row, 3, 0, 1, 4);
}

void ProbeNumbers::show(const HandNumbers& numbers) {
  skin_mm_ = numbers.skin_mm;
  for (const Field& field : fields_) field.box->show(numbers.of(field.axis));
  for (int i = 0; i < 3; ++i) place_[i]->show(numbers.skin_mm[i]);
}

}  // namespace insonate::train
