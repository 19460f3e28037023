#include "TraceModel.h"

#include "../model/ImagingModel.h"
#include "../model/LiveModel.h"

#include <insonate/ultrasound/PointSpread.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace insonate::train {
namespace {

constexpr double kSteepest_deg = 80;

SpectralSettings fittedGate(SpectralSettings gate, const Probe& probe, const ImagingSettings& settings) {
  gate.across = std::clamp(gate.across, 0.0, 1.0);
  gate.gate_mm = std::clamp(gate.gate_mm, 0.5, std::min(20.0, settings.depth_mm / 2));
  const double half_mm = gate.gate_mm / 2;
  gate.range_mm = std::clamp(gate.range_mm, std::max(1.0, half_mm), settings.depth_mm - half_mm);
  gate.steering_deg = std::clamp(gate.steering_deg, -20.0, 20.0);
  gate.frequency_MHz = std::clamp(gate.frequency_MHz, probe.minFrequency_MHz, probe.maxFrequency_MHz);
  // The echo from the lower end of the gate arrives before the next pulse.
  const double highest_Hz = std::min(20000.0, std::floor(kSoundSpeed_mmPerUs * 1e6 / (2 * (gate.range_mm + half_mm))));
  gate.prf_Hz = std::clamp(gate.prf_Hz, 500.0, highest_Hz);
  gate.wallFilter_Hz = std::clamp(gate.wallFilter_Hz, 0.0, gate.prf_Hz / 2);
  gate.gain_dB = std::clamp(gate.gain_dB, -30.0, 30.0);
  gate.baseline = std::clamp(gate.baseline, -0.45, 0.45);
  return gate;
}

}  // namespace

TraceModel::TraceModel(ImagingModel& imaging, LiveModel& live, QObject* parent)
    : QObject(parent), imaging_(imaging), live_(live), gate_(spectralSettingsFor(imaging.probe(), imaging.settings())) {
  connect(&imaging_, &ImagingModel::setupChanged, this, [this] { send(); });
}

SpectralSettings TraceModel::gate() const {
  SpectralSettings gate = fittedGate(gate_, imaging_.probe(), imaging_.settings());
  gate.angle_deg = std::abs(angle_deg_);
  return gate;
}

GatePlace TraceModel::place() const {
  return gatePlace(imaging_.probe(), imaging_.settings(), gate());
}

void TraceModel::setPwOn(bool isOn) {
  if (isOn == pwOn_) return;
  pwOn_ = isOn;
  send();
}

void TraceModel::setGate(const SpectralSettings& gate) {
  const SpectralSettings before = gate_;
  gate_ = fittedGate(gate, imaging_.probe(), imaging_.settings());
  gate_.angle_deg = before.angle_deg;
  if (!(gate_ == before)) send();
}

void TraceModel::setAngle(double angle_deg) {
  angle_deg = std::clamp(angle_deg, -kSteepest_deg, kSteepest_deg);
  if (angle_deg == angle_deg_) return;
  angle_deg_ = angle_deg;
  send();
}

void TraceModel::setMModeOn(bool isOn) {
  if (isOn == mModeOn_) return;
  mModeOn_ = isOn;
  Q_EMIT changed();
}

void TraceModel::setLine(double across) {
  line_ = std::clamp(across, 0.0, 1.0);
  Q_EMIT changed();
}

void TraceModel::setSweep(double seconds) {
  sweep_s_ = std::clamp(seconds, 2.0, 12.0);
  Q_EMIT changed();
}

void TraceModel::send() {
  live_.setGate(pwOn_ ? std::optional(gate()) : std::nullopt);
  Q_EMIT changed();
}

}  // namespace insonate::train
