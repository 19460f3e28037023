#include "ImagePanel.h"

#include "../feature/CommandWords.h"
#include "../model/Disclosure.h"
#include "../model/ImagingModel.h"
#include "EffectWords.h"
#include "GainSliders.h"
#include "MachineChooser.h"

#include <insonate/simulator/EffectLayers.h>
#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ultrasound/GrayMaps.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
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
    {&Settings::depth_mm, "depth", "depth", "mm", "depth to which the image reaches", 5, 0},
    {&Settings::gain_dB, "gain", "gain", "dB", "brightness of the whole image", 1, 0, -40, 40},
    {&Settings::frequency_MHz, "frequency", "frequency", "MHz",
     "a higher frequency gives finer resolution and less penetration", 0.5, 1},
    {&Settings::focus_mm, "focus", "focus", "mm", "depth at which the beam is narrowest", 1, 0},
    {&Settings::dynamicRange_dB, "dynamicRange", "dynamic range", "dB", "a larger dynamic range gives softer grays", 5,
     0, 20, 120},
    {&Settings::steering_deg, "steering", "steering", "\u00b0", "tilts the scanlines of a linear probe", 1, 0, -20, 20},
    {&Settings::persistence, "persistence", "persistence", "", "weight of the previous image in each image", 0.05, 2, 0,
     0.95},
    {&Settings::speckleReduction, "speckleReduction", "speckle reduction", "",
     "smooths speckle but preserves boundaries", 0.05, 2, 0, 1},
    {&Settings::edgeEnhancement, "edgeEnhancement", "edge enhancement", "", "sharpens boundaries across the beam", 0.05,
     2, 0, 1},
    {&Settings::dynamicFilter, "dynamicFilter", "dynamic filter", "",
     "lengthens the pulse with depth, as receive filters do; 0: off", 0.1, 1, 0, 2},
    {&Settings::noise_dB, "noise", "noise", "dB",
     "level of the electronic noise before TGC; a higher level reduces penetration; -120: no noise", 1, 0, -120, 0},
    {&Settings::ringing_dB, "ringing", "ringing", "dB",
     "level of the reverberation in the probe, seen as bright bands below its face", 1, 0, -20, 60},
    {&Settings::poorContactLeft_mm, "poorContactLeft", "no contact left", "mm",
     "width of the strip of the probe face that the skin does not touch", 0.5, 1, 0, 30},
    {&Settings::poorContactRight_mm, "poorContactRight", "no contact right", "mm",
     "width of the strip of the probe face that the skin does not touch", 0.5, 1, 0, 30},
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

}  // namespace

ImagePanel::ImagePanel(DisclosureModel& disclosure, ImagingModel& imaging, QWidget& probeChooser,
                       const ui::Commands& commands, QWidget* parent)
    : QWidget(parent), imaging_(imaging) {
  auto* box = new QVBoxLayout(this);
  box->setContentsMargins(0, 0, 0, 0);
  box->setSpacing(4);
  box->addWidget(ui::heading(tr("Image")));
  box->addWidget(labeled(tr("probe"), &probeChooser));
  box->addWidget(labeled(tr("machine"), new MachineChooser(imaging_)));
  buildProcessing(*box);
  buildModel(*box, commands);
  QWidget* effects = labeled(tr("show"), effect_);
  box->addWidget(effects);
  connect(&disclosure, &DisclosureModel::changed, effects,
          [&disclosure, effects] { effects->setVisible(disclosure.current().anatomy); });
  connect(&imaging_, &ImagingModel::setupChanged, this, [this] { refresh(); });
  refresh();
}

void ImagePanel::addSliders(QVBoxLayout& box, std::size_t first, std::size_t last) {
  for (std::size_t i = first; i < last; ++i) {
    const SliderRow& row = kSliders[i];
    auto* slider = new ui::ValueSlider(tr(row.name), tr(row.unit),
                                       rangeOf(row.field, imaging_.probe(), imaging_.settings()), tr(row.hint));
    slider->setObjectName(row.object);
    connect(slider, &ui::ValueSlider::valueChanged, this,
            [this, field = row.field](double value) { change(field, value); });
    sliders_.push_back({row.field, slider});
    box.addWidget(slider);
  }
}

QWidget* ImagePanel::labeled(const QString& name, QWidget* widget) {
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

void ImagePanel::buildModel(QVBoxLayout& box, const ui::Commands& commands) {
  look_ = new QComboBox;
  look_->setObjectName("look");
  look_->addItem(tr("natural"), int(Look::Coherent));
  look_->addItem(tr("simplified"), int(Look::Thesis));
  look_->setToolTip(
      tr("Rendering style. Natural: speckle arises from the tissue. Simplified: only reflection, absorption, blur and "
         "noise"));
  box.addWidget(labeled(tr("look"), look_));
  effect_ = new QComboBox;
  effect_->setObjectName("effect");
  effect_->setToolTip(tr("Shows all effects of the ultrasound model (%2), or only one of them (%1)")
                          .arg(keysOf(commands, "train.image.nextEffect"), keysOf(commands, "train.image.wholeImage")));
  for (QComboBox* combo : {grayMap_, compounding_, look_, effect_}) {
    combo->setFocusPolicy(Qt::TabFocus);
    combo->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  }
  connect(look_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = imaging_.settings();
    settings.look = Look(look_->currentData().toInt());
    imaging_.setEffect(ImagingModel::kWholeModel);
    imaging_.setSettings(settings);
  });
  connect(effect_, qOverload<int>(&QComboBox::activated), this,
          [this] { imaging_.setEffect(effect_->currentData().toString().toStdString()); });
}

void ImagePanel::buildProcessing(QVBoxLayout& box) {
  addSliders(box, 0, kBeforeTgc);
  tgc_ = gains(&Settings::tgc_dB, new GainSliders(Qt::Vertical, tr("Time-gain compensation"),
                                                  tr("Gain at each depth, from the probe face down. Double click "
                                                     "resets a slider, double click with Shift resets all sliders.")));
  tgc_->setObjectName("tgc");
  box.addWidget(labeled(tr("TGC"), tgc_));
  lateral_ = gains(
      &Settings::lateralGain_dB,
      new GainSliders(
          Qt::Horizontal, tr("Lateral gain"),
          tr("Gain from left to right. Double click resets a slider, double click with Shift resets all sliders.")));
  lateral_->setObjectName("lateralGain");
  box.addWidget(labeled(tr("lateral gain"), lateral_));
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
    Settings settings = imaging_.settings();
    settings.grayMap = GrayMap(grayMap_->currentData().toInt());
    imaging_.setSettings(settings);
  });
  box.addWidget(labeled(tr("gray map"), grayMap_));
  compounding_ = new QComboBox;
  compounding_->setObjectName("compounding");
  compounding_->setToolTip(
      tr("Averages images from several directions (linear probes only); more directions take longer"));
  compounding_->addItem(tr("off"), 1);
  for (const int angles : {3, 5}) compounding_->addItem(tr("%1 angles").arg(angles), angles);
  connect(compounding_, qOverload<int>(&QComboBox::activated), this, [this] {
    Settings settings = imaging_.settings();
    settings.compoundingAngles = compounding_->currentData().toInt();
    imaging_.setSettings(settings);
  });
  box.addWidget(labeled(tr("compounding"), compounding_));
  harmonic_ = new QCheckBox(tr("harmonic imaging"));
  harmonic_->setObjectName("harmonic");
  harmonic_->setToolTip(
      tr("Transmits at half the frequency and receives the harmonic: a narrower beam and less haze, but more noise"));
  connect(harmonic_, &QCheckBox::clicked, this, [this](bool on) {
    Settings settings = imaging_.settings();
    settings.harmonic = on;
    imaging_.setSettings(settings);
  });
  box.addWidget(harmonic_);
}

GainSliders* ImagePanel::gains(std::array<double, 8> Settings::*field, GainSliders* sliders) {
  sliders->setChanged([this, field, sliders] {
    Settings settings = imaging_.settings();
    settings.*field = sliders->values();
    imaging_.setSettings(settings);
  });
  return sliders;
}

void ImagePanel::change(double Settings::*field, double value) {
  if (refreshing_) return;
  Settings settings = imaging_.settings();
  settings.*field = value;
  imaging_.setSettings(settings);
}

void ImagePanel::refresh() {
  refreshing_ = true;
  const Settings& settings = imaging_.settings();
  for (const Slider& slider : sliders_) {
    slider.widget->setRange(rangeOf(slider.field, imaging_.probe(), settings));
    slider.widget->setValue(settings.*slider.field);
  }
  tgc_->setValues(settings.tgc_dB);
  lateral_->setValues(settings.lateralGain_dB);
  grayMap_->setCurrentIndex(grayMap_->findData(int(settings.grayMap)));
  compounding_->setCurrentIndex(compounding_->findData(settings.compoundingAngles));
  harmonic_->setChecked(settings.harmonic);
  look_->setCurrentIndex(look_->findData(int(settings.look)));
  effect_->clear();
  effect_->addItem(tr("all effects"), QString());
  for (const EffectLayer& layer : effectLayers(settings))
    effect_->addItem(tr("only %1").arg(effectWords(layer.name)), QString::fromStdString(layer.name));
  effect_->setCurrentIndex(std::max(0, effect_->findData(QString::fromStdString(imaging_.effect()))));
  refreshing_ = false;
}

void ImagePanel::save(QSettings& settings) const {
  for (const SliderRow& row : kSliders) settings.setValue(row.object, imaging_.settings().*row.field);
  for (const auto& [key, field] : kGains) {
    QVariantList list;
    for (double value : imaging_.settings().*field) list << value;
    settings.setValue(key, list);
  }
  settings.setValue("grayMap", int(imaging_.settings().grayMap));
  for (const auto& [key, field] : kCounts) settings.setValue(key, imaging_.settings().*field);
  settings.setValue("harmonic", imaging_.settings().harmonic);
  settings.setValue("look", int(imaging_.settings().look));
}

void ImagePanel::restore(QSettings& settings) {
  Settings all = imaging_.settings();
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
  all.harmonic = settings.value("harmonic", all.harmonic).toBool();
  all.look = settings.value("look").toInt() == int(Look::Thesis) ? Look::Thesis : Look::Coherent;
  imaging_.setSettings(all);
}

}  // namespace insonate::train
