#include <insonate/simulator/Electrocardiogram.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

/// Ventricles contract for about 0.1 s before blood leaves the heart, and the pulse takes about 0.05 s to the neck.
constexpr double kBeforePulse_s = 0.15;
constexpr double kAhead_s = 0.3, kJump_s = 5;
/// An extra beat comes at this share of the normal period, and the normal beat after it is left out; our choice.
constexpr double kPremature = 0.6;
/// A normal beat cannot follow a wide one sooner.
constexpr double kRefractory_s = 0.5;
constexpr std::size_t kRateBeats = 5;

/// Amplitude, time after the R wave at 60 beats per minute, and standard deviation.
struct Wave {
  double voltage_mV, time_s, width_s;
};
constexpr Wave kNormal[]{
    {0.12, -0.17, 0.025}, {-0.12, -0.035, 0.010}, {1.1, 0, 0.012}, {-0.25, 0.032, 0.012}, {0.28, 0.27, 0.05}};
constexpr Wave kWide[]{{1.35, 0, 0.045}, {-0.35, 0.11, 0.03}, {-0.45, 0.30, 0.07}};

double voltageOf(const Electrocardiogram::Beat& beat, double after_s) {
  double voltage_mV = 0;
  for (const Wave& wave : beat.isWide ? std::span<const Wave>(kWide) : std::span<const Wave>(kNormal)) {
    const double x = (after_s - wave.time_s) / wave.width_s;
    if (std::abs(x) < 5) voltage_mV += wave.voltage_mV * std::exp(-0.5 * x * x);
  }
  return voltage_mV;
}

/// The first normal beat later than `after_s`.
double normalBeat_s(double after_s, double period_s) {
  return (std::floor((after_s + kBeforePulse_s) / period_s + 1e-9) + 1) * period_s - kBeforePulse_s;
}

}  // namespace

Electrocardiogram::Beat Electrocardiogram::next(HeartRhythm rhythm, double period_s) const {
  const Beat last = count_ > 0 ? beats_[count_ - 1] : Beat{*now_s_ - 1, false};
  if (rhythm == HeartRhythm::Tachycardia) return {count_ > 0 ? last.time_s + 60 / kTachycardia_perMin : *now_s_, true};
  if (rhythm == HeartRhythm::ExtraBeats && !last.isWide && count_ > 0)
    return {last.time_s + kPremature * period_s, true};
  // After an extra beat, one normal beat is left out. A changed heart rate brings no beat at once.
  const double after_s =
      last.time_s + (last.isWide ? std::max(kRefractory_s, (1 - kPremature) * period_s + 1e-3) : 0.5 * period_s);
  return {normalBeat_s(after_s, period_s), false};
}

void Electrocardiogram::add(const Beat& beat) {
  if (count_ == beats_.size()) std::shift_left(beats_.begin(), beats_.end(), 1), --count_;
  beats_[count_++] = beat;
}

void Electrocardiogram::advance(double time_s, HeartRhythm rhythm, double heartRate_perMin) {
  const bool isJump = !now_s_ || time_s - *now_s_ > kJump_s || time_s < *now_s_;
  if (isJump || (count_ > 0 && time_s - beats_[count_ - 1].time_s > kJump_s)) count_ = 0;
  now_s_ = time_s;
  if (heartRate_perMin <= 0) return;
  for (Beat beat = next(rhythm, 60 / heartRate_perMin); beat.time_s <= time_s + kAhead_s;
       beat = next(rhythm, 60 / heartRate_perMin))
    add(beat);
}

double Electrocardiogram::voltage_mV(double time_s) const {
  double voltage_mV = 0;
  for (const Beat& beat : beats()) voltage_mV += voltageOf(beat, time_s - beat.time_s);
  return voltage_mV;
}

std::optional<double> Electrocardiogram::rate_perMin(double time_s) const {
  std::size_t past = count_;
  while (past > 0 && beats_[past - 1].time_s > time_s) --past;
  if (past < 3) return std::nullopt;
  const std::size_t first = past > kRateBeats ? past - kRateBeats : 0;
  return 60 * static_cast<double>(past - 1 - first) / (beats_[past - 1].time_s - beats_[first].time_s);
}

}  // namespace insonate
