#include "ControlsPanel.h"

#include "../image/EffectWords.h"
#include "../image/GainSliders.h"
#include "../image/MachineChooser.h"
#include "../model/TrainModel.h"
#include "../needle/NeedleControls.h"
#include "../probe/Positions.h"
#include "../probe/ProbeChooser.h"
#include "../probe/ProbeNumbers.h"
#include "../tissue/TissueControls.h"

#include <insonate/simulator/EffectLayers.h>
#include <insonate/ui/QuietWheel.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ultrasound/GrayMaps.h>

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
  double least = 0, most = 0;  ///< alike where the probe or the depth decides
};
constexpr SliderRow kSliders[] = {
    {&Settings::depth_mm, "depth", "depth", "mm", "how deep the image goes", 5, 0},
    {&Settings::gain_dB, "gain", "gain", "dB", "brightness of the whole image", 1, 0, -40, 40},
    {&Settings::frequency_MHz, "frequency", "frequency", "MHz", "higher: finer, and less deep", 0.5, 1},
    {&Settings::focus_mm, "focus", "focus", "mm", "where the beam is narrowest", 1, 0},
    {&Settings::dynamicRange_dB, "dynamicRange", "dynamic range", "dB", "more: softer grays", 5, 0, 20, 120},
    {&Settings::steering_deg, "steering", "steering", "\u00b0", "tilts the scanlines of a linear probe", 1, 0, -20, 20},
    {&Settings::persistence, "persistence", "persistence", "", "share of the image before", 0.05, 2, 0, 0.95},
    {&Settings::speckleReduction, "speckleReduction", "speckle reduction", "", "smooths speckle and follows boundaries",
     0.05, 2, 0, 1},
    {&Settings::edgeEnhancement, "edgeEnhancement", "edge enhancement", "", "sharpens boundaries across the beam", 0.05,
     2, 0, 1},
    {&Settings::dynamicFilter, "dynamicFilter", "dynamic filter", "",
     "lengthens the pulse with depth, as receive filters do; 0: off", 0.1, 1, 0, 2},
    {&Settings::noise_dB, "noise", "noise", "dB", "electronic noise before TGC; more: less penetration; -120: none", 1,
     0, -120, 0},
    {&Settings::ringing_dB, "ringing", "ringing", "dB", "bright bands of the probe itself below its face", 1, 0, -20,
     60},
    {&Settings::poorContactLeft_mm, "poorContactLeft", "no contact left", "mm",
     "strip of the face that the skin does not touch", 0.5, 1, 0, 30},
    {&Settings::poorContactRight_mm, "poorContactRight", "no contact right", "mm",
     "strip of the face that the skin does not touch", 0.5, 1, 0, 30},
};
constexpr std::size_t kBeforeTgc = 5;

ui::ValueRange rangeOf(double Settings::*field, const Probe& probe, const Settings& settings) {
  const Settings usual = settingsFor(probe);
  const SliderRow* row = std::ranges::find(kSliders, field, &SliderRow::field);
  const auto range = [&](double least, double most) {
    return ui::ValueRange{least, most, std::clamp(usual.*field, least, most), row->step, row->decimals};
  };
  if (field == &Settings::depth_mm) return range(probe.minDepth_mm, probe.maxDepth_mm);
  if (field == &Settings::frequency_MHz) return range(probe.minFrequency_MHz, probe.maxFrequency_MHz);
  if (field == &Settings::focus_mm) return range(1, settings.depth_mm);
  return range(row->least, row->most);
}

struct GainsKey {
  const char* key;  ///< of the stored values
  std::array<double, 8> Settings::*field;
};
constexpr GainsKey kGains[] = {{"tgc", &Settings::tgc_dB}, {"lateralGain", &Settings::lateralGain_dB}};

/// Decided by the machine alone.
struct CountKey {
  const char* key;
  int Settings::*field;
};
constexpr CountKey kCounts[] = {{"looks", &Settings::looks},
                                {"scanlines", &Settings::scanlines},
                                {"compoundingAngles", &Settings::compoundingAngles}};

QVBoxLayout* column(QWidget* widget) {
  auto* box = new QVBoxLayout(widget);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  return box;
}

}  // namespace

ControlsPanel::ControlsPanel(TrainModel& model, ProbeLibrary& library, QWidget* parent)
    : ScrollingColumn(parent), model_(model), library_(library) {
  setObjectName("trainControls");
  auto* inner = new QWidget;
  auto* box = new QVBoxLayout(inner);
  box->setContentsMargins(12, 8, 12, 8);
  box->setSpacing(12);
  box->addWidget(buildPositionSection());
  needle_ = new NeedleControls(model_.status, model_.disclosure, model_.hands, model_.motion, model_.needle);
  box->addWidget(needle_);
  box->addWidget(buildPicture());
  auto* tissue = new TissueControls(model_.status, model_.imaging);
  box->addWidget(tissue);
  anatomy_.push_back(tissue);
  box->addStretch();
  setParts(inner, buildFreeze());
  setMinimumWidth(inner->minimumSizeHint().width() + 16);

  connect(&model_.imaging, &ImagingModel::setupChanged, this, [this] { refresh(); });
  connect(&model_.motion, &ProbeMotion::handMoved, this, [this] { numbers_->show(model_.motion.numbers()); });
  connect(&model_.live, &LiveModel::frozenChanged, this, [this] { refreshFreeze(); });
  connect(&model_.disclosure, &DisclosureModel::changed, this, [this] {
    for (QWidget* one : anatomy_) one->setVisible(model_.disclosure.current().anatomy);
  });
  connect(&model_.patientCase, &CaseModel::caseChanged, this, [this] { refreshFreeze(); });
  connect(&model_.live, &LiveModel::pictureShown, this, [this] {
    if (!freeze_->isEnabled()) refreshFreeze();
  });
  refresh();
  refreshFreeze();
}

QWidget* ControlsPanel::buildPositionSection() {
  auto* place = new QWidget;
  auto* box = column(place);
  positions_ = new Positions(model_.status, model_.history, model_.patientCase, model_.motion, place);
  numbers_ = new ProbeNumbers(place);
  numbers_->setTyped([this](HandAxis axis, double value) { model_.motion.typed(axis, value); });
  numbers_->setPlaced([this](Vec3 patient_mm) { model_.motion.placed(patient_mm); });
  numbers_->setRefused([this](const QString& sentence) { model_.status.say(sentence); });
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
    auto* slider =
        new ui::ValueSlider(tr(row.name), tr(row.unit),
                            rangeOf(row.field, model_.imaging.probe(), model_.imaging.settings()), tr(row.hint));
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
  label->setMinimumWidth(label->fontMetrics().horizontalAdvance(tr("gray map")));
  widget->setAccessibleName(name);
  box->addWidget(label);
  box->addWidget(widget, 1);
  return row;
}

QWidget* ControlsPanel::buildPicture() {
  auto* picture = new QWidget;
  auto* box = column(picture);
  box->addWidget(ui::heading(tr("Image")));
  probe_ = new ProbeChooser(model_.imaging, library_);
  box->addWidget(labelled(tr("probe"), probe_));
  box->addWidget(labelled(tr("machine"), new MachineChooser(model_.imaging)));
  buildProcessing(*box);
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
  for (QComboBox* combo : {grayMap_, compounding_, look_, effect_}) {
    new ui::QuietWheel(combo);
    combo->setFocusPolicy(Qt::TabFocus);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  }
  connect(look_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = model_.imaging.settings();
    settings.look = Look(look_->currentData().toInt());
    model_.imaging.setEffect(ImagingModel::kWholeModel);
    model_.imaging.setSettings(settings);
  });
  connect(effect_, qOverload<int>(&QComboBox::activated), this,
          [this] { model_.imaging.setEffect(effect_->currentData().toString().toStdString()); });
  return picture;
}

void ControlsPanel::buildProcessing(QVBoxLayout& box) {
  addSliders(box, 0, kBeforeTgc);
  tgc_ = gains(&Settings::tgc_dB,
               new GainSliders(Qt::Vertical, tr("Time-gain compensation"),
                               tr("Gain by depth, from the face down. Double click resets one, with Shift all.")));
  tgc_->setObjectName("tgc");
  box.addWidget(labelled(tr("TGC"), tgc_));
  lateral_ = gains(&Settings::lateralGain_dB,
                   new GainSliders(Qt::Horizontal, tr("Lateral gain"),
                                   tr("Gain from left to right. Double click resets one, with Shift all.")));
  lateral_->setObjectName("lateralGain");
  box.addWidget(labelled(tr("lateral gain"), lateral_));
  addSliders(box, kBeforeTgc, std::size(kSliders));
  grayMap_ = new QComboBox;
  grayMap_->setObjectName("grayMap");
  grayMap_->setToolTip(tr("Mapping of echo levels to grays"));
  for (const GrayMapCurve& curve : grayMaps()) {
    grayMap_->addItem(QString::fromUtf8(curve.name.data(), int(curve.name.size())), int(curve.map));
    grayMap_->setItemData(grayMap_->count() - 1, QString::fromUtf8(curve.about.data(), int(curve.about.size())),
                          Qt::ToolTipRole);
  }
  connect(grayMap_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = model_.imaging.settings();
    settings.grayMap = GrayMap(grayMap_->currentData().toInt());
    model_.imaging.setSettings(settings);
  });
  box.addWidget(labelled(tr("gray map"), grayMap_));
  compounding_ = new QComboBox;
  compounding_->setObjectName("compounding");
  compounding_->setToolTip(
      tr("Averages images from several directions, linear probes only; more directions take longer"));
  compounding_->addItem(tr("off"), 1);
  for (const int angles : {3, 5}) compounding_->addItem(tr("%1 angles").arg(angles), angles);
  connect(compounding_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = model_.imaging.settings();
    settings.compoundingAngles = compounding_->currentData().toInt();
    model_.imaging.setSettings(settings);
  });
  box.addWidget(labelled(tr("compounding"), compounding_));
}

GainSliders* ControlsPanel::gains(std::array<double, 8> Settings::*field, GainSliders* sliders) {
  sliders->setChanged([this, field, sliders] {
    Settings settings = model_.imaging.settings();
    settings.*field = sliders->values();
    model_.imaging.setSettings(settings);
  });
  return sliders;
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
  connect(freeze_, &QPushButton::clicked, &model_.live, &LiveModel::setFrozen);
  return foot;
}

void ControlsPanel::change(double Settings::*field, double value) {
  if (refreshing_) return;
  Settings settings = model_.imaging.settings();
  settings.*field = value;
  model_.imaging.setSettings(settings);
}

void ControlsPanel::refresh() {
  refreshing_ = true;
  const Settings& settings = model_.imaging.settings();
  for (const Slider& slider : sliders_) {
    slider.widget->setRange(rangeOf(slider.field, model_.imaging.probe(), settings));
    slider.widget->setValue(settings.*slider.field);
  }
  tgc_->setValues(settings.tgc_dB);
  lateral_->setValues(settings.lateralGain_dB);
  grayMap_->setCurrentIndex(grayMap_->findData(int(settings.grayMap)));
  compounding_->setCurrentIndex(compounding_->findData(settings.compoundingAngles));
  look_->setCurrentIndex(look_->findData(int(settings.look)));
  effect_->clear();
  effect_->addItem(tr("the whole image"), QString());
  for (const EffectLayer& layer : effectLayers(settings))
    effect_->addItem(tr("only %1").arg(effectWords(layer.name)), QString::fromStdString(layer.name));
  effect_->setCurrentIndex(std::max(0, effect_->findData(QString::fromStdString(model_.imaging.effect()))));
  refreshing_ = false;
}

void ControlsPanel::refreshFreeze() {
  freeze_->setEnabled(model_.live.shown() != nullptr);
  freeze_->setChecked(model_.live.isFrozen());
  freeze_->setText(model_.live.isFrozen() ? tr("Unfreeze") : tr("Freeze"));
}

void ControlsPanel::save(QSettings& settings) const {
  settings.setValue("probe",
                    probe_->key().isEmpty() ? QString::fromStdString(model_.imaging.probe().name) : probe_->key());
  for (const SliderRow& row : kSliders) settings.setValue(row.object, model_.imaging.settings().*row.field);
  for (const auto& [key, field] : kGains) {
    QVariantList list;
    for (double value : model_.imaging.settings().*field) list << value;
    settings.setValue(key, list);
  }
  settings.setValue("grayMap", int(model_.imaging.settings().grayMap));
  for (const auto& [key, field] : kCounts) settings.setValue(key, model_.imaging.settings().*field);
  settings.setValue("look", int(model_.imaging.settings().look));
  settings.beginGroup("tissue");
  saveTissue(model_.imaging.tissue(), settings);
  settings.endGroup();
  positions_->save(settings);
  settings.beginGroup("hands");
  model_.hands.save(settings);
  settings.endGroup();
}

void ControlsPanel::restore(QSettings& settings) {
  model_.imaging.setProbe(
      settings.value("probe", QString::fromStdString(model_.imaging.probe().name)).toString().toStdString());
  Settings all = model_.imaging.settings();
  for (const SliderRow& row : kSliders) {
    bool ok = false;
    const double value = settings.value(row.object).toDouble(&ok);
    if (ok && std::isfinite(value)) all.*row.field = value;
  }
  for (const auto& [key, field] : kGains) {
    const QVariantList list = settings.value(key).toList();
    for (int i = 0; i < int((all.*field).size()) && i < list.size(); ++i)
      if (std::isfinite(list[i].toDouble())) (all.*field)[i] = list[i].toDouble();
  }
  const int map = settings.value("grayMap", int(all.grayMap)).toInt();
  if (grayMap_->findData(map) >= 0) all.grayMap = GrayMap(map);
  for (const auto& [key, field] : kCounts) all.*field = settings.value(key, all.*field).toInt();
  all.look = settings.value("look").toInt() == int(Look::Thesis) ? Look::Thesis : Look::Coherent;
  model_.imaging.setSettings(all);
  settings.beginGroup("tissue");
  model_.imaging.setTissue(restoredTissue(settings));
  settings.endGroup();
  positions_->restore(settings);
  settings.beginGroup("hands");
  model_.hands.restore(settings);
  settings.endGroup();
}

}  // namespace insonate::train
