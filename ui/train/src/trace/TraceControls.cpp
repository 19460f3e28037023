#include "TraceControls.h"

#include "../feature/CommandWords.h"
#include "../model/ImagingModel.h"
#include "TraceModel.h"

#include <insonate/ui/Theme.h>
#include <insonate/ui/ValueSlider.h>
#include <insonate/ui/Widgets.h>
#include <insonate/ultrasound/PointSpread.h>

#include <QCheckBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace insonate::train {
namespace {

constexpr double kScaleUnit_mmps = 10, kPerShare = 100;

/// PRF at which velocities alias above `velocity_mmps`, which is corrected by the angle.
double spectralPrf_Hz(double velocity_mmps, const SpectralSettings& gate) {
  return velocity_mmps * std::cos(gate.angle_deg * std::numbers::pi / 180) * 4 * gate.frequency_MHz /
         kSoundSpeed_mmPerUs;
}

}  // namespace

TraceControls::TraceControls(ImagingModel& imaging, TraceModel& trace, const ui::Commands& commands, QWidget* parent)
    : QWidget(parent), imaging_(imaging), trace_(trace) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(ui::heading(tr("Traces over time")));
  pw_ = box("pwDoppler", tr("PW Doppler"),
            tr("Shows the velocities of the blood in a gate over time, under the image (%1). Drag the gate in the "
               "image, its line, or the end of the line of flow")
                .arg(keysOf(commands, "train.trace.pw")));
  scale_ = slider("pwScale", tr("spectral scale"), tr("cm/s"), tr("velocity above which the spectrum aliases"));
  baseline_ = slider("pwBaseline", tr("baseline"), tr("%"), tr("moves the baseline of the spectrum down"));
  gateLength_ = slider("pwGate", tr("gate length"), tr("mm"), tr("a longer gate receives slow flow near the walls"));
  angle_ = slider("pwAngle", tr("flow angle"), QStringLiteral("°"),
                  tr("angle between beam and flow, by which velocities are corrected"));
  steering_ = slider("pwSteering", tr("gate steering"), QStringLiteral("°"), tr("tilts the line of a linear probe"));
  wallFilter_ =
      slider("pwWallFilter", tr("spectral wall filter"), tr("Hz"), tr("suppresses slow flow and moving tissue"));
  gain_ = slider("pwGain", tr("spectral gain"), tr("dB"), tr("a higher gain shows weaker flow, and noise"));
  mMode_ = box("mModeOn", tr("M-mode"),
               tr("Shows one scanline over time, under the image (%1). Drag the line in the image")
                   .arg(keysOf(commands, "train.trace.mMode")));
  sweep_ = slider("traceSweep", tr("trace duration"), tr("s"), tr("a shorter duration gives a faster sweep"));
  for (QWidget* widget : std::initializer_list<QWidget*>{pw_, scale_, baseline_, gateLength_, angle_, steering_,
                                                         wallFilter_, gain_, mMode_, sweep_})
    column->addWidget(widget);
  connect(&trace_, &TraceModel::changed, this, [this] { refresh(); });
  refresh();
}

QCheckBox* TraceControls::box(const char* object, const QString& text, const QString& toolTip) {
  auto* box = new QCheckBox(text, this);
  box->setObjectName(QLatin1String(object));
  box->setToolTip(toolTip);
  connect(box, &QCheckBox::clicked, this, [this] { apply(); });
  return box;
}

ui::ValueSlider* TraceControls::slider(const char* object, const QString& name, const QString& unit,
                                       const QString& hint) {
  auto* slider = new ui::ValueSlider(name, unit, {}, hint, this);
  slider->setObjectName(QLatin1String(object));
  connect(slider, &ui::ValueSlider::valueChanged, this, [this] { apply(); });
  return slider;
}

void TraceControls::apply() {
  if (refreshing_) return;
  SpectralSettings gate = trace_.gate();
  // The sliders round; a value that the user did not change keeps its exact number.
  if (scale_->value() != shownScale_cmps_) gate.prf_Hz = spectralPrf_Hz(scale_->value() * kScaleUnit_mmps, gate);
  if (wallFilter_->value() != shownFilter_Hz_) gate.wallFilter_Hz = wallFilter_->value();
  gate.baseline = baseline_->value() / kPerShare, gate.gate_mm = gateLength_->value();
  gate.steering_deg = steering_->value(), gate.gain_dB = gain_->value();
  const double angle_deg = angle_->value(), sweep_s = sweep_->value();
  const bool pw = pw_->isChecked(), mMode = mMode_->isChecked();
  // Each of these calls sets the sliders anew.
  trace_.setGate(gate);
  trace_.setAngle(angle_deg);
  trace_.setSweep(sweep_s);
  trace_.setMModeOn(mMode);
  trace_.setPwOn(pw);
}

void TraceControls::setRanges() {
  const SpectralSettings gate = trace_.gate();
  const SpectralSettings usual = spectralSettingsFor(imaging_.probe(), imaging_.settings());
  SpectralSettings fastest = gate;
  fastest.prf_Hz = std::min(20000.0, std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * (gate.range_mm + gate.gate_mm / 2))));
  const double highest_cmps = std::floor(nyquistVelocity_mmps(fastest) / kScaleUnit_mmps);
  const double least_cmps = std::ceil(500 / gate.prf_Hz * nyquistVelocity_mmps(gate) / kScaleUnit_mmps);
  const double usual_cmps = std::round(usual.prf_Hz / gate.prf_Hz * nyquistVelocity_mmps(gate) / kScaleUnit_mmps);
  scale_->setRange({least_cmps, highest_cmps, std::clamp(usual_cmps, least_cmps, highest_cmps), 1, 0});
  baseline_->setRange({-45, 45, 0, 5, 0});
  gateLength_->setRange({0.5, std::min(20.0, imaging_.settings().depth_mm / 2), usual.gate_mm, 0.5, 1});
  angle_->setRange({-80, 80, 0, 1, 0});
  steering_->setRange({-20, 20, 0, 1, 0});
  wallFilter_->setRange(
      {0, std::floor(gate.prf_Hz / 2), std::min(usual.wallFilter_Hz, std::floor(gate.prf_Hz / 2)), 10, 0});
  gain_->setRange({-30, 30, 0, 1, 0});
  sweep_->setRange({2, 12, 5, 1, 0});
}

void TraceControls::refresh() {
  refreshing_ = true;
  const SpectralSettings gate = trace_.gate();
  setRanges();
  scale_->setValue(nyquistVelocity_mmps(gate) / kScaleUnit_mmps);
  baseline_->setValue(gate.baseline * kPerShare), gateLength_->setValue(gate.gate_mm);
  angle_->setValue(trace_.angle_deg()), steering_->setValue(gate.steering_deg);
  wallFilter_->setValue(gate.wallFilter_Hz), gain_->setValue(gate.gain_dB), sweep_->setValue(trace_.sweep_s());
  shownScale_cmps_ = scale_->value(), shownFilter_Hz_ = wallFilter_->value();
  pw_->setChecked(trace_.isPwOn()), mMode_->setChecked(trace_.isMModeOn());
  for (QWidget* widget : {scale_, baseline_, gateLength_, angle_, wallFilter_, gain_})
    widget->setVisible(trace_.isPwOn());
  steering_->setVisible(trace_.isPwOn() && imaging_.probe().shape == ProbeShape::Linear);
  sweep_->setVisible(trace_.isPwOn() || trace_.isMModeOn());
  refreshing_ = false;
}

}  // namespace insonate::train
