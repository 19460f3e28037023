#include "TissueControls.h"

#include "../layout/NumberField.h"
#include "../model/ImagingModel.h"
#include "../model/StatusLine.h"

#include <insonate/simulator/TissueMechanics.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <functional>

namespace insonate::train {
namespace {

struct Posture {
  double tilt_deg;
  const char* name;
};
constexpr Posture kPostures[] = {
    {0, "supine"},
    {5, "Trendelenburg 5°"},
    {10, "Trendelenburg 10°"},
    {15, "Trendelenburg 15°"},
    {25, "Trendelenburg 25°"},
    {-10, "head up 10°"},
    {-15, "head up 15°"},
    {-30, "head up 30°"},
};

struct Model {
  const char* key;
  const char* name;
};
const Model kModels[] = {{"elastic", "elastic"}, {"column", "columns (thesis)"}, {kNoDeformation.data(), "none"}};

}  // namespace

TissueControls::TissueControls(StatusLine& status, ImagingModel& imaging, QWidget* parent)
    : QWidget(parent), status_(status), imaging_(imaging) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  auto* heading = new QLabel(tr("Tissue"), this);
  ui::setRole(heading, "heading");
  box->addWidget(heading);
  model_ = choice("tissueModel", tr("Mechanical model. Elastic: tissue moves aside and veins empty. Columns: "
                                    "independent springs along the depth. None: the tissue does not move"));
  for (const Model& one : kModels) model_->addItem(tr(one.name), QLatin1String(one.key));
  box->addWidget(labeled(tr("model"), model_));
  posture_ = choice("posture", tr("Tilt of the table, in degrees. Head down (Trendelenburg) fills the veins of the "
                                  "neck and empties those of the groin"));
  for (const Posture& one : kPostures) posture_->addItem(QString::fromUtf8(one.name), one.tilt_deg);
  box->addWidget(labeled(tr("posture"), posture_));
  venous_ = new ui::ValueSlider(tr("CVP"), tr("mmHg"), {-5, 30, Physiology{}.centralVenous_mmHg, 1, 0},
                                tr("central venous pressure, at the heart"), this);
  venous_->setObjectName("centralVenous");
  box->addWidget(venous_);
  box->addWidget(buildPressures());
  box->addWidget(buildSwitches());
  const auto chosen = [this](QComboBox* combo, auto take) {
    connect(combo, qOverload<int>(&QComboBox::activated), this,
            [this, combo, take] { change([&](TissueChoice& to) { take(to, combo->currentData()); }); });
  };
  chosen(model_, [](TissueChoice& to, const QVariant& picked) { to.model = picked.toString().toStdString(); });
  chosen(posture_, [](TissueChoice& to, const QVariant& picked) { to.body.tilt_deg = picked.toDouble(); });
  connect(venous_, &ui::ValueSlider::valueChanged, this,
          [this](double mmHg) { change([&](TissueChoice& to) { to.body.centralVenous_mmHg = mmHg; }); });
  connect(&imaging_, &ImagingModel::tissueChanged, this, [this] { refresh(); });
  refresh();
}

QComboBox* TissueControls::choice(const char* object, const QString& says) {
  return ui::choiceBox(object, {}, says, Qt::TabFocus);
}

QWidget* TissueControls::labeled(const QString& name, QWidget* widget) {
  auto* row = new QWidget(this);
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(8);
  auto* label = new QLabel(name, row);
  ui::setRole(label, "quiet");
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance(tr("posture")));
  label->setToolTip(widget->toolTip());
  widget->setAccessibleName(name);
  box->addWidget(label);
  box->addWidget(widget, 1);
  return row;
}

QWidget* TissueControls::buildPressures() {
  auto* both = new QWidget(this);
  auto* box = new QHBoxLayout(both);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  const auto field = [&](const char* object, const QString& name, double low, double high, double Physiology::*which) {
    auto* number = new NumberField(name, {}, {low, high, 5, 0}, both);
    number->setObjectName(QLatin1String(object));
    number->setAccessibleName(tr("%1 arterial pressure in mmHg").arg(name));
    number->setToolTip(tr("%1 pressure of the arteries at the heart, in mmHg.\nEnter applies the number; arrow keys "
                          "and wheel change it in steps.")
                           .arg(name));
    number->setTyped([this, which](double mmHg) { change([&](TissueChoice& to) { to.body.*which = mmHg; }); });
    number->setRefused([this](const QString& sentence) { status_.showMessage(sentence); });
    return number;
  };
  systolic_ = field("systolic", tr("Systolic"), 40, 260, &Physiology::systolic_mmHg);
  diastolic_ = field("diastolic", tr("Diastolic"), 20, 180, &Physiology::diastolic_mmHg);
  auto* over = new QLabel(QStringLiteral("/"), both);
  auto* unit = new QLabel(tr("mmHg"), both);
  for (QLabel* label : {over, unit}) ui::setRole(label, "quiet");
  box->addWidget(systolic_, 1);
  box->addWidget(over);
  box->addWidget(diastolic_, 1);
  box->addWidget(unit);
  QWidget* row = labeled(tr("artery"), both);
  both->setAccessibleName(tr("Arterial pressure"));
  return row;
}

QWidget* TissueControls::buildSwitches() {
  auto* row = new QWidget(this);
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 4, 0, 0);
  box->setSpacing(10);
  pulse_ = new QCheckBox(tr("pulse"), row);
  pulse_->setObjectName("pulse");
  pulse_->setToolTip(tr("Pulsation of the arteries, 70 beats per minute"));
  breathing_ = new QCheckBox(tr("breathing"), row);
  breathing_->setObjectName("breathing");
  breathing_->setToolTip(tr("Respiratory changes of the vein width and sliding of the lung, 14 breaths per minute"));
  pneumothorax_ = new QCheckBox(tr("pneumothorax"), row);
  pneumothorax_->setObjectName("pneumothorax");
  pneumothorax_->setToolTip(tr("Air between lung and chest wall: the lung does not slide along the pleura"));
  for (QCheckBox* one : {pulse_, breathing_, pneumothorax_}) {
    one->setFocusPolicy(Qt::TabFocus);
    box->addWidget(one);
  }
  box->addStretch(1);
  connect(pulse_, &QCheckBox::toggled, this, [this](bool on) { change([&](TissueChoice& to) { to.pulse = on; }); });
  connect(breathing_, &QCheckBox::toggled, this,
          [this](bool on) { change([&](TissueChoice& to) { to.breathing = on; }); });
  connect(pneumothorax_, &QCheckBox::toggled, this, [this](bool on) {
    change([&](TissueChoice& to) { to.body.lungSlide_mm = on ? 0 : Physiology{}.lungSlide_mm; });
  });
  return row;
}

void TissueControls::change(const std::function<void(TissueChoice&)>& edit) {
  if (refreshing_) return;
  TissueChoice choice = imaging_.tissue();
  edit(choice);
  imaging_.setTissue(choice);
}

void TissueControls::refresh() {
  refreshing_ = true;
  const TissueChoice& now = imaging_.tissue();
  model_->setCurrentIndex(model_->findData(QString::fromStdString(now.model)));
  const auto nearest = std::ranges::min_element(
      kPostures, {}, [&](const Posture& one) { return std::abs(one.tilt_deg - now.body.tilt_deg); });
  posture_->setCurrentIndex(int(nearest - std::begin(kPostures)));
  venous_->setValue(now.body.centralVenous_mmHg);
  systolic_->show(now.body.systolic_mmHg);
  diastolic_->show(now.body.diastolic_mmHg);
  pulse_->setChecked(now.pulse);
  breathing_->setChecked(now.breathing);
  pneumothorax_->setChecked(now.body.lungSlide_mm == 0);
  refreshing_ = false;
}

}  // namespace insonate::train
