#include "ControlsPanel.h"

#include "../TrainSession.h"
#include "../hands/NeedleControls.h"
#include "../probe/ProbeChooser.h"
#include "../tissue/TissueControls.h"
#include "EffectWords.h"
#include "Positions.h"
#include "ProbeNumbers.h"
#include "TgcSliders.h"

#include <insonate/simulator/EffectLayers.h>
#include <insonate/ui/QuietWheel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace insonate::train {
namespace {

using Settings = ImagingSettings;

/// In the order of how often a hand goes there.
struct SliderRow {
  double Settings::*field;
  const char* object;  ///< also the key of the stored value
  const char* name;
  const char* unit;
  const char* hint;
  double step;
  int decimals;
};
constexpr SliderRow kSliders[] = {
    {&Settings::depth_mm, "depth", "depth", "mm", "how deep the image goes", 5, 0},
    {&Settings::gain_dB, "gain", "gain", "dB", "brightness of the whole image", 1, 0},
    {&Settings::frequency_MHz, "frequency", "frequency", "MHz", "higher: finer, and less deep", 0.5, 1},
    {&Settings::focus_mm, "focus", "focus", "mm", "where the beam is narrowest", 1, 0},
    {&Settings::dynamicRange_dB, "dynamicRange", "dynamic range", "dB", "more: softer grays", 5, 0},
    {&Settings::persistence, "persistence", "persistence", "", "share of the image before", 0.05, 2},
};
constexpr std::size_t kBeforeTgc = 5;

ui::ValueRange rangeOf(double Settings::*field, const Probe& probe, const Settings& settings) {
  const Settings usual = settingsFor(probe);
  const auto range = [&](double least, double most) {
    const SliderRow* row = std::ranges::find(kSliders, field, &SliderRow::field);
    return ui::ValueRange{least, most, std::clamp(usual.*field, least, most), row->step, row->decimals};
  };
  if (field == &Settings::depth_mm) return range(probe.minDepth_mm, probe.maxDepth_mm);
  if (field == &Settings::frequency_MHz) return range(probe.minFrequency_MHz, probe.maxFrequency_MHz);
  if (field == &Settings::focus_mm) return range(1, settings.depth_mm);
  if (field == &Settings::gain_dB) return range(-40, 40);
  if (field == &Settings::dynamicRange_dB) return range(20, 120);
  return range(0, 0.95);
}

QVBoxLayout* column(QWidget* widget) {
  auto* box = new QVBoxLayout(widget);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  return box;
}

}  // namespace

ControlsPanel::ControlsPanel(TrainSession& session, ProbeLibrary& library, QWidget* parent)
    : ScrollingColumn(parent), session_(session), library_(library) {
  setObjectName("trainControls");
  auto* inner = new QWidget;
  auto* box = new QVBoxLayout(inner);
  box->setContentsMargins(12, 8, 12, 8);
  box->setSpacing(12);
  box->addWidget(buildPlace());
  needle_ = new NeedleControls(session_);
  box->addWidget(needle_);
  box->addWidget(buildPicture());
  auto* tissue = new TissueControls(session_);
  box->addWidget(tissue);
  anatomy_.push_back(tissue);
  box->addStretch();
  setParts(inner, buildFreeze());
  setMinimumWidth(inner->minimumSizeHint().width() + 16);

  connect(&session_, &TrainSession::setupChanged, this, [this] { refresh(); });
  connect(&session_, &TrainSession::handMoved, this, [this] { numbers_->show(session_.numbers()); });
  connect(&session_, &TrainSession::frozenChanged, this, [this] { refreshFreeze(); });
  connect(&session_, &TrainSession::disclosureChanged, this, [this] {
    for (QWidget* one : anatomy_) one->setVisible(session_.disclosure().anatomy);
  });
  connect(&session_, &TrainSession::caseChanged, this, [this] { refreshFreeze(); });
  connect(&session_, &TrainSession::pictureShown, this, [this] {
    if (!freeze_->isEnabled()) refreshFreeze();
  });
  refresh();
  refreshFreeze();
}

QWidget* ControlsPanel::buildPlace() {
  auto* place = new QWidget;
  auto* box = column(place);
  positions_ = new Positions(session_, place);
  numbers_ = new ProbeNumbers(place);
  numbers_->setTyped([this](HandAxis axis, double value) { session_.typed(axis, value); });
  numbers_->setPlaced([this](Vec3 patient_mm) { session_.placed(patient_mm); });
  numbers_->setRefused([this](const QString& sentence) { session_.say(sentence); });
  box->addWidget(ui::heading(tr("Position")));
  box->addWidget(positions_);
  anatomy_.push_back(positions_);
  box->addSpacing(4);
  box->addWidget(numbers_);
  return place;
}

void ControlsPanel::addSliders(QVBoxLayout& box, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const SliderRow& row = kSliders[i];
    auto* slider = new ui::ValueSlider(tr(row.name), tr(row.unit),
                                       rangeOf(row.field, session_.probe(), session_.settings()), tr(row.hint));
    slider->setObjectName(row.object);
    connect(slider, &ui::ValueSlider::valueChanged, this,
            [this, field = row.field](double value) { change(field, value); });
    sliders_.push_back({row.field, slider});
    box.addWidget(slider);
  }
}

QWidget* ControlsPanel::labelled(const QString& name, QWidget* widget) {
  auto* row = new QWidget;
  auto* box = new QHBoxLayout(row);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(8);
  auto* label = new QLabel(name, row);
  ui::setRole(label, "quiet");
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance(tr("persist")));
  widget->setAccessibleName(name);
  box->addWidget(label);
  box->addWidget(widget, 1);
  return row;
}

QWidget* ControlsPanel::buildPicture() {
  auto* picture = new QWidget;
  auto* box = column(picture);
  box->addWidget(ui::heading(tr("Image")));
  probe_ = new ProbeChooser(session_, library_);
  box->addWidget(labelled(tr("probe"), probe_));
  addSliders(*box, 0, kBeforeTgc);
  tgc_ = new TgcSliders;
  tgc_->setObjectName("tgc");
  tgc_->setChanged([this] {
    Settings settings = session_.settings();
    settings.tgc_dB = tgc_->values();
    session_.setSettings(settings);
  });
  box->addWidget(labelled(tr("TGC"), tgc_));
  addSliders(*box, kBeforeTgc, std::size(kSliders));
  look_ = new QComboBox;
  look_->setObjectName("look");
  look_->addItem(tr("natural"), int(Look::Coherent));
  look_->addItem(tr("in layers (thesis)"), int(Look::Thesis));
  look_->setToolTip(
      tr("Natural: speckle that belongs to the tissue. In layers: reflection, absorption, blur and noise"));
  box->addWidget(labelled(tr("look"), look_));
  effect_ = new QComboBox;
  effect_->setObjectName("effect");
  effect_->setToolTip(tr("The whole image, or one effect of the model by itself (N, Shift+N; 0 for the whole)"));
  anatomy_.push_back(labelled(tr("show"), effect_));
  box->addWidget(anatomy_.back());
  for (QComboBox* combo : {look_, effect_}) {
    new ui::QuietWheel(combo);
    combo->setFocusPolicy(Qt::TabFocus);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  }
  connect(look_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = session_.settings();
    settings.look = Look(look_->currentData().toInt());
    session_.setEffect(TrainSession::kWholeModel);
    session_.setSettings(settings);
  });
  connect(effect_, qOverload<int>(&QComboBox::activated), this,
          [this] { session_.setEffect(effect_->currentData().toString().toStdString()); });
  return picture;
}

QWidget* ControlsPanel::buildFreeze() {
  auto* foot = new QWidget;
  auto* box = new QVBoxLayout(foot);
  box->setContentsMargins(12, 8, 12, 8);
  freeze_ = new QPushButton(tr("Freeze"));
  freeze_->setObjectName("freeze");
  freeze_->setCheckable(true);
  freeze_->setFocusPolicy(Qt::TabFocus);
  freeze_->setToolTip(tr("Freezes the image, or makes it live again (Space)"));
  freeze_->setMinimumHeight(36);
  box->addWidget(freeze_);
  connect(freeze_, &QPushButton::clicked, &session_, &TrainSession::setFrozen);
  return foot;
}

void ControlsPanel::change(double Settings::*field, double value) {
  if (refreshing_) return;
  Settings settings = session_.settings();
  settings.*field = value;
  session_.setSettings(settings);
}

void ControlsPanel::refresh() {
  refreshing_ = true;
  const Settings& settings = session_.settings();
  for (const Slider& slider : sliders_) {
    slider.widget->setRange(rangeOf(slider.field, session_.probe(), settings));
    slider.widget->setValue(settings.*slider.field);
  }
  tgc_->setValues(settings.tgc_dB);
  look_->setCurrentIndex(look_->findData(int(settings.look)));
  effect_->clear();
  effect_->addItem(tr("the whole image"), QString());
  for (const EffectLayer& layer : effectLayers(settings))
    effect_->addItem(tr("only %1").arg(effectWords(layer.name)), QString::fromStdString(layer.name));
  effect_->setCurrentIndex(std::max(0, effect_->findData(QString::fromStdString(session_.effect()))));
  refreshing_ = false;
}

void ControlsPanel::refreshFreeze() {
  freeze_->setEnabled(session_.shown() != nullptr);
  freeze_->setChecked(session_.isFrozen());
  freeze_->setText(session_.isFrozen() ? tr("Unfreeze") : tr("Freeze"));
}

void ControlsPanel::save(QSettings& settings) const {
  settings.setValue("probe", probe_->key().isEmpty() ? QString::fromStdString(session_.probe().name) : probe_->key());
  for (const SliderRow& row : kSliders) settings.setValue(row.object, session_.settings().*row.field);
  QVariantList tgc;
  for (double value : session_.settings().tgc_dB) tgc << value;
  settings.setValue("tgc", tgc);
  settings.setValue("look", int(session_.settings().look));
  settings.beginGroup("tissue");
  saveTissue(session_.tissue(), settings);
  settings.endGroup();
  positions_->save(settings);
  settings.beginGroup("hands");
  session_.hands().save(settings);
  settings.endGroup();
}

void ControlsPanel::restore(QSettings& settings) {
  session_.setProbe(settings.value("probe", QString::fromStdString(session_.probe().name)).toString().toStdString());
  Settings all = session_.settings();
  for (const SliderRow& row : kSliders) {
    bool ok = false;
    const double value = settings.value(row.object).toDouble(&ok);
    if (ok && std::isfinite(value)) all.*row.field = value;
  }
  const QVariantList tgc = settings.value("tgc").toList();
  for (int i = 0; i < int(all.tgc_dB.size()) && i < tgc.size(); ++i)
    if (std::isfinite(tgc[i].toDouble())) all.tgc_dB[i] = tgc[i].toDouble();
  all.look = settings.value("look").toInt() == int(Look::Thesis) ? Look::Thesis : Look::Coherent;
  session_.setSettings(all);
  settings.beginGroup("tissue");
  session_.setTissue(restoredTissue(settings));
  settings.endGroup();
  positions_->restore(settings);
  settings.beginGroup("hands");
  session_.hands().restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
