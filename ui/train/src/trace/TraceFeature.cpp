#include "TraceFeature.h"

#include "../layout/ControlsColumn.h"
#include "../layout/TrainLayout.h"
#include "../model/TrainModel.h"
#include "MModeStrip.h"
#include "SpectrumStrip.h"
#include "TraceControls.h"
#include "TraceHandles.h"

#include <insonate/ui/Sound.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/ui/Workspace.h>
#include <insonate/ultrasound/BeamGrid.h>

#include <QSettings>
#include <QWidget>
#include <cmath>

namespace insonate::train {
namespace {

constexpr int kTake_ms = 33;

struct GateKey {
  const char* key;  ///< of the stored value
  double SpectralSettings::*field;
};
constexpr GateKey kGateKeys[] = {{"pwPrf", &SpectralSettings::prf_Hz},
                                 {"pwGain", &SpectralSettings::gain_dB},
                                 {"pwSteering", &SpectralSettings::steering_deg},
                                 {"pwWallFilter", &SpectralSettings::wallFilter_Hz},
                                 {"pwGate", &SpectralSettings::gate_mm},
                                 {"pwBaseline", &SpectralSettings::baseline}};
constexpr const char* kSweepKey = "traceSweep";

}  // namespace

TraceFeature::TraceFeature(TrainModel& model, TrainLayout& layout)
    : Feature(model, layout),
      trace_(model.imaging, model.live),
      spectrum_(new SpectrumStrip(&layout.image())),
      mMode_(new MModeStrip(&layout.image())) {
  addCommands();
  layout.controls().addSection(new TraceControls(model.imaging, trace_, commands()));
  layout.image().add(ImageColumn::Curve, spectrum_);
  layout.image().add(ImageColumn::Curve, mMode_);
  new TraceHandles(model.imaging, trace_, layout.views().image(), *layout.views().imageWidget().focusProxy(), this);
  due_.setInterval(kTake_ms);
  connect(&due_, &QTimer::timeout, this, [this] { takeSpectra(); });
  still_.setInterval(kTake_ms);
  connect(&still_, &QTimer::timeout, this, [this] { showStillness(); });
  connect(&trace_, &TraceModel::changed, this, [this] { follow(); });
  connect(&model.live, &LiveModel::pictureShown, this, [this] { showFrame(); });
  connect(&model.patientCase, &CaseModel::caseChanged, this, [this] {
    spectrum_->clear();
    mMode_->clear();
    follow();
  });
  follow();
}

void TraceFeature::addCommands() {
  beginSection(KeySection::Image);
  addCommand({.id = "train.trace.pw",
              .text = tr("PW Doppler"),
              .does = tr("switches PW Doppler on or off"),
              .listed = tr("Ctrl+W"),
              .keys = keys({Qt::Key_W}, Qt::ControlModifier),
              .perform = once([this] { trace_.setPwOn(!trace_.isPwOn()); })});
  addCommand({.id = "train.trace.mMode",
              .text = tr("M-mode"),
              .does = tr("switches M-mode on or off"),
              .listed = tr("Ctrl+M"),
              .keys = keys({Qt::Key_M}, Qt::ControlModifier),
              .perform = once([this] { trace_.setMModeOn(!trace_.isMModeOn()); })});
  const auto mover = [this](int key, double across_mm, double deeper_mm) {
    constexpr double kWide = 5;
    return ui::CommandKey{key, Qt::ControlModifier, [this, across_mm, deeper_mm](ui::KeyPress press) {
                            const double steps = press.wide ? kWide : 1;
                            moveGate(steps * across_mm, steps * deeper_mm);
                          }};
  };
  addCommand({.id = "train.trace.gate",
              .text = {},
              .does = tr("moves the gate of PW Doppler, or the line of M-mode, by 1 mm; 5 mm with Shift"),
              .listed = tr("Ctrl+Left, Right, Up, Down"),
              .keys = {mover(Qt::Key_Left, -1, 0), mover(Qt::Key_Right, 1, 0), mover(Qt::Key_Up, 0, -1),
                       mover(Qt::Key_Down, 0, 1)},
              .perform = {},
              .isAvailable = [this] { return isPatientShown() && (trace_.isPwOn() || trace_.isMModeOn()); }});
  commands().addListed(tr("Left drag on the gate, its line or the line of flow"),
                       tr("moves the gate or the line, or turns the line of flow"));
}

void TraceFeature::moveGate(double across_mm, double deeper_mm) {
  const BeamGrid grid(model_.imaging.probe(), model_.imaging.settings());
  SpectralSettings gate = trace_.gate();
  const auto across = [&](double range_mm) {
    return across_mm / (grid.scanlineSpacing_mm(range_mm) * grid.scanlines());
  };
  if (!trace_.isPwOn()) return trace_.setLine(trace_.line() + across(model_.imaging.settings().depth_mm / 2));
  gate.across += across(gate.range_mm);
  gate.range_mm += deeper_mm;
  trace_.setGate(gate);
}

void TraceFeature::follow() {
  const bool isShown = model_.patientCase.patient() != nullptr;
  spectrum_->setVisible(isShown && trace_.isPwOn());
  mMode_->setVisible(isShown && trace_.isMModeOn());
  sinceImage_.invalidate();
  trace_.isMModeOn() ? still_.start() : still_.stop();
  spectrum_->setDuration(trace_.sweep_s());
  mMode_->setDuration(trace_.sweep_s());
  spectrum_->setGate(trace_.gate());
  if (trace_.isPwOn() == due_.isActive()) return;
  if (!trace_.isPwOn()) {
    due_.stop();
    stream_ = nullptr;
    return spectrum_->clear();
  }
  due_.start();
}

void TraceFeature::takeSpectra() {
  model_.live.takeSpectra(spectra_);
  spectrum_->append(spectra_);
  playSound();
}

void TraceFeature::playSound() {
  ui::Sound& device = layout_.workspace().sound();
  if (!device.isOn()) {
    stream_ = nullptr;
    return;
  }
  if (!stream_) stream_ = device.openStream();
  const SpectralSettings gate = trace_.gate();
  if (!sound_ || soundPrf_Hz_ != gate.prf_Hz) {
    sound_.emplace(gate.prf_Hz, ui::kSoundRate_Hz, 1);
    soundPrf_Hz_ = gate.prf_Hz;
  }
  std::vector<float> samples;
  for (const LiveSpectrum& spectrum : spectra_)
    if (spectrum.gate.prf_Hz == gate.prf_Hz) sound_->append(spectrum.power, gate.gain_dB, kSpectrumStep_s, samples);
  stream_->append(samples);
}

/// Images that are shown again while frozen do not continue M-mode.
void TraceFeature::showFrame() {
  if (!trace_.isMModeOn() || model_.live.isFrozen()) return;
  mMode_->append(*model_.live.shown(), trace_.line());
  sinceImage_.start();
}

/// Without motion there are no new images; a lung that does not slide is then a field of lines that go on.
void TraceFeature::showStillness() {
  constexpr qint64 kStill_ms = 150;
  const auto& frame = model_.live.shown();
  const bool isLive = frame && !model_.live.isFrozen() && model_.live.status().state == LiveState::Imaging;
  if (!isLive || !mMode_->isVisible()) return sinceImage_.invalidate();
  if (!sinceImage_.isValid()) return showFrame();
  if (sinceImage_.elapsed() >= kStill_ms)
    mMode_->repeatUntil(frame->time_s + static_cast<double>(sinceImage_.elapsed()) * 1e-3);
}

void TraceFeature::save(QSettings& settings) const {
  for (const auto& [key, field] : kGateKeys) settings.setValue(key, trace_.gate().*field);
  settings.setValue(kSweepKey, trace_.sweep_s());
}

/// Both traces are off at first: a session begins with the B-mode image.
void TraceFeature::restore(QSettings& settings) {
  SpectralSettings gate = trace_.gate();
  for (const auto& [key, field] : kGateKeys) {
    bool ok = false;
    const double value = settings.value(key).toDouble(&ok);
    if (ok && std::isfinite(value)) gate.*field = value;
  }
  trace_.setGate(gate);
  bool ok = false;
  const double sweep_s = settings.value(kSweepKey).toDouble(&ok);
  if (ok && std::isfinite(sweep_s)) trace_.setSweep(sweep_s);
}

}  // namespace insonate::train
