#include "ImagingModel.h"

#include "Disclosure.h"
#include "History.h"
#include "StatusLine.h"

#include <insonate/simulator/EffectLayers.h>
#include <insonate/ultrasound/PointSpread.h>
#include <insonate/ultrasound/Textures.h>

#include <QThreadPool>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace insonate::train {

namespace {

auto fields(const Probe& p) {
  return std::tie(p.name, p.shape, p.width_mm, p.faceMargin_mm, p.fovAngle_deg, p.faceRadius_mm, p.minFrequency_MHz,
                  p.maxFrequency_MHz, p.minDepth_mm, p.maxDepth_mm, p.defaultFrequency_MHz, p.defaultDepth_mm,
                  p.defaultFocus_mm, p.pitch_mm, p.bandwidth, p.transmitFNumber, p.receiveFNumber, p.maxAperture_mm,
                  p.apodization, p.elementHeight_mm, p.elevationFocus_mm);
}

/// The settings that a user can change.
auto fields(const ImagingSettings& s) {
  return std::tie(s.depth_mm, s.frequency_MHz, s.harmonic, s.focus_mm, s.gain_dB, s.tgc_dB, s.dynamicRange_dB,
                  s.persistence, s.grayMap, s.speckleReduction, s.edgeEnhancement, s.dynamicFilter, s.noise_dB,
                  s.ringing_dB, s.poorContactLeft_mm, s.poorContactRight_mm, s.lateralGain_dB, s.looks, s.steering_deg,
                  s.compoundingAngles, s.scanlines, s.samples, s.elevationPlanes, s.width, s.height,
                  s.conformingContact, s.look);
}

template <class T>
bool same(const T& a, const T& b) {
  return fields(a) == fields(b);
}

}  // namespace

ImagingSettings fitted(ImagingSettings settings, const Probe& probe) {
  settings.depth_mm = std::clamp(settings.depth_mm, probe.minDepth_mm, probe.maxDepth_mm);
  settings.frequency_MHz = std::clamp(settings.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  settings.focus_mm = std::clamp(settings.focus_mm, 1.0, settings.depth_mm);
  settings.gain_dB = std::clamp(settings.gain_dB, -40.0, 40.0);
  settings.dynamicRange_dB = std::clamp(settings.dynamicRange_dB, 20.0, 120.0);
  settings.persistence = std::clamp(settings.persistence, 0.0, 0.95);
  settings.speckleReduction = std::clamp(settings.speckleReduction, 0.0, 1.0);
  settings.edgeEnhancement = std::clamp(settings.edgeEnhancement, 0.0, 1.0);
  settings.dynamicFilter = std::clamp(settings.dynamicFilter, 0.0, 2.0);
  settings.noise_dB = std::clamp(settings.noise_dB, -120.0, 0.0);
  settings.ringing_dB = std::clamp(settings.ringing_dB, -20.0, 60.0);
  settings.poorContactLeft_mm = std::clamp(settings.poorContactLeft_mm, 0.0, 30.0);
  settings.poorContactRight_mm = std::clamp(settings.poorContactRight_mm, 0.0, 30.0);
  settings.looks = std::clamp(settings.looks, 1, 3);
  settings.steering_deg = std::clamp(settings.steering_deg, -20.0, 20.0);
  settings.compoundingAngles = std::clamp(settings.compoundingAngles, 1, 5) | 1;  // odd
  settings.scanlines = std::clamp(settings.scanlines, 16, 1024);
  for (auto* sliders : {&settings.tgc_dB, &settings.lateralGain_dB})
    for (double& value : *sliders) value = std::clamp(value, -20.0, 20.0);
  return settings;
}

ColorSettings fitted(ColorSettings color, const Probe& probe, const ImagingSettings& settings) {
  constexpr double kLeastWidth = 0.06, kLeastHeight_mm = 2.5;
  color.left = std::clamp(color.left, 0.0, 1 - kLeastWidth);
  color.right = std::clamp(color.right, color.left + kLeastWidth, 1.0);
  color.near_mm = std::clamp(color.near_mm, 0.0, settings.depth_mm - kLeastHeight_mm);
  color.far_mm = std::clamp(color.far_mm, color.near_mm + kLeastHeight_mm, settings.depth_mm);
  color.steering_deg = std::clamp(color.steering_deg, -20.0, 20.0);
  color.frequency_MHz = std::clamp(color.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  // The echo from the lower end of the box arrives before the next pulse.
  const double highest_Hz = std::min(20000.0, std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * color.far_mm)));
  color.prf_Hz = std::clamp(color.prf_Hz, 200.0, highest_Hz);
  color.gain_dB = std::clamp(color.gain_dB, -30.0, 30.0);
  color.wallFilter_Hz = std::clamp(color.wallFilter_Hz, 0.0, color.prf_Hz / 2);
  color.priority = std::clamp(color.priority, 0.0, 1.0);
  color.persistence = std::clamp(color.persistence, 0.0, 0.95);
  return color;
}

ImagingModel::ImagingModel(DisclosureModel& disclosure, History& history, StatusLine& status, QObject* parent)
    : QObject(parent), disclosure_(disclosure), history_(history), status_(status) {
  QThreadPool::globalInstance()->start([] { prepareTextures(); });
  // Both come with the program.
  probe_ = loadProbe("linear").value_or(Probe{});
  tissues_ = loadAcousticTable(acousticPresetNames().front()).value_or(AcousticTable{});
  settings_ = settingsFor(probe_);
  color_ = colorSettingsFor(probe_, settings_);
  chosen_ = choices();
  connect(&disclosure_, &DisclosureModel::changed, this, [this] {
    if (!disclosure_.current().anatomy) hideAnatomy();
  });
}

/// Restores the whole image; undo does not lead behind it.
void ImagingModel::hideAnatomy() {
  if (effect_ != kWholeModel) {
    effect_ = kWholeModel;
    announceSetup();
  }
  history_.clear();
}

void ImagingModel::setTilt(double tilt_deg) {
  TissueChoice choice = tissue_;
  choice.body.tilt_deg = tilt_deg;
  setTissue(choice);
}

ImagingSetup ImagingModel::setup() const {
  ImagingSetup all{probe_, settings_, tissues_, "cpu"};
  all.mechanics.model = tissue_.model;
  if (colorOn_ && effect_ == kWholeModel) all.color = fitted(color_, probe_, settings_);
  if (effect_ != kWholeModel)
    for (const EffectLayer& layer : effectLayers(settings_))
      if (layer.name == effect_) all.settings = layer.settings;
  return all;
}

bool ImagingModel::setProbe(const std::string& name) {
  auto probe = loadProbe(name);
  if (!probe) return false;
  const ImagingSettings own = settingsFor(*probe);
  probe_ = std::move(*probe);
  settings_.depth_mm = own.depth_mm;
  settings_.frequency_MHz = own.frequency_MHz;
  settings_.focus_mm = own.focus_mm;
  const ColorSettings usual = colorSettingsFor(probe_, settings_);
  color_.left = usual.left, color_.right = usual.right, color_.near_mm = usual.near_mm, color_.far_mm = usual.far_mm;
  color_.frequency_MHz = usual.frequency_MHz, color_.prf_Hz = usual.prf_Hz;
  color_.wallFilter_Hz = usual.wallFilter_Hz, color_.steering_deg = usual.steering_deg;
  announceSetup();
  return true;
}

Result<void> ImagingModel::useProbe(const Probe& probe, const std::string& what) {
  if (auto ok = validate(probe); !ok) return ok;
  if (probe.defaultDepth_mm != probe_.defaultDepth_mm) settings_.depth_mm = probe.defaultDepth_mm;
  if (probe.defaultFrequency_MHz != probe_.defaultFrequency_MHz) settings_.frequency_MHz = probe.defaultFrequency_MHz;
  if (probe.defaultFocus_mm != probe_.defaultFocus_mm) settings_.focus_mm = probe.defaultFocus_mm;
  probe_ = probe;
  settings_ = fitted(settings_, probe_);
  editKind_ = "probe " + what;
  announceSetup();
  editKind_.clear();
  return {};
}

void ImagingModel::setSettings(ImagingSettings settings) {
  settings_ = fitted(settings, probe_);
  announceSetup();
}

void ImagingModel::setColor(bool isOn, const ColorSettings& color) {
  const ColorSettings permitted = fitted(color, probe_, settings_);
  if (isOn == colorOn_ && permitted == color_) return;
  colorOn_ = isOn, color_ = permitted;
  announceSetup();
}

void ImagingModel::setEffect(const std::string& name) {
  if (name != kWholeModel && !disclosure_.mayShowAnatomy()) return;
  effect_ = name;
  announceSetup();
}

void ImagingModel::stepEffect(int by) {
  std::vector<std::string> names{kWholeModel};
  for (const EffectLayer& layer : effectLayers(settings_)) names.push_back(layer.name);
  const int count = int(names.size());
  const int now = int(std::ranges::find(names, effect_) - names.begin()) % count;
  setEffect(names[std::size_t(((now + by) % count + count) % count)]);
}

void ImagingModel::announceSetup() {
  rememberSetup();
  Q_EMIT setupChanged();
}

void ImagingModel::rememberSetup() {
  const Chosen before = std::exchange(chosen_, choices());
  const bool sameProbe = same(before.probe, probe_);
  const bool sameColor = before.color == color_ && before.colorOn == colorOn_;
  if (sameProbe && sameColor && before.effect == effect_ && same(before.settings, settings_)) return;
  const QString what = sameProbe ? tr("change of an image setting") : tr("change of the probe");
  const auto exchange = [this, other = before]() mutable {
    const Chosen now = chosen_;
    // Set here, too, so that nothing new is remembered.
    chosen_ = other;
    probe_ = other.probe, settings_ = other.settings, effect_ = other.effect;
    color_ = other.color, colorOn_ = other.colorOn;
    other = now;
    announceSetup();
  };
  history_.add(what, exchange, sameProbe ? QStringLiteral("settings") : QString::fromStdString(editKind_));
}

void ImagingModel::setTissue(const TissueChoice& choice) {
  if (choice == tissue_) return;
  if (auto ok = checkPhysiology(choice.body); !ok) {
    status_.showMessage(QString::fromStdString(ok.error().message));
    Q_EMIT tissueChanged();  // Numbers that cannot be go back.
    return;
  }
  const auto exchange = [this, other = tissue_]() mutable {
    const TissueChoice now = tissue_;
    useTissue(std::exchange(other, now));
  };
  history_.add(tr("change of a tissue setting"), exchange, QStringLiteral("tissue"));
  useTissue(choice);
}

void ImagingModel::useTissue(const TissueChoice& choice) {
  const bool otherModel = choice.model != tissue_.model;
  tissue_ = choice;
  Q_EMIT physiologyChanged();
  if (otherModel) announceSetup();
  Q_EMIT tissueChanged();
}

}  // namespace insonate::train
