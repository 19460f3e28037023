#include "SpectrumStrip.h"

#include <insonate/ui/Theme.h>

#include <QPainter>
#include <array>
#include <cmath>
#include <utility>

namespace insonate::train {
namespace {

constexpr double kAxisUnit_mmps = 10;

/// Distance between the marks of an axis: about four on each side.
double markStep(double span) {
  const double rough = span / 6, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

/// Tells whether the bins of spectra of two gates have the same velocities, before these are corrected by the angle.
bool sameBins(const SpectralSettings& a, const SpectralSettings& b) {
  return a.prf_Hz == b.prf_Hz && a.frequency_MHz == b.frequency_MHz;
}

}  // namespace

SpectrumStrip::SpectrumStrip(QWidget* parent) : TraceStrip(kSpectrumBins, kSpectrumStep_s, parent) {
  setObjectName("spectrum");
  setToolTip(
      tr("Velocities of the blood in the gate over time (PW Doppler), in cm/s; flow toward the probe is above the "
         "baseline"));
  describe();
}

void SpectrumStrip::setGate(const SpectralSettings& gate) {
  const SpectralSettings before = std::exchange(gate_, gate);
  if (!sameBins(before, gate)) return clear();
  if (gate.baseline != before.baseline || gate.gain_dB != before.gain_dB) drawAgain();
  describe();
  update();
}

void SpectrumStrip::clear() {
  TraceStrip::clear();
  kept_.clear();
  oldest_ = 0;
}

void SpectrumStrip::draw(const LiveSpectrum& spectrum) {
  std::array<std::uint8_t, kSpectrumBins> gray{};
  displaySpectrum(spectrum.power, gate_, 1, int(std::lround(spectrum.time_s / kSpectrumStep_s)), gray);
  TraceStrip::append(spectrum.time_s, gray);
}

void SpectrumStrip::drawAgain() {
  TraceStrip::clear();
  for (std::size_t i = 0; i < kept_.size(); ++i) draw(kept_[(oldest_ + i) % kept_.size()]);
}

void SpectrumStrip::append(const std::vector<LiveSpectrum>& spectra) {
  for (const LiveSpectrum& spectrum : spectra) {
    // Spectra that were computed before a change of the scale do not belong to the strip.
    if (!sameBins(spectrum.gate, gate_)) continue;
    draw(spectrum);
    if (kept_.size() < shownColumns()) {
      kept_.push_back(spectrum);
    } else {
      kept_[oldest_] = spectrum;
      oldest_ = (oldest_ + 1) % kept_.size();
    }
  }
  if (!spectra.empty()) describe();
}

void SpectrumStrip::describe() {
  SpectrumVelocities latest;
  if (!kept_.empty()) latest = velocitiesOf(kept_[(oldest_ + kept_.size() - 1) % kept_.size()].power, gate_);
  setAccessibleName(tr("Spectrum of PW Doppler. Mean velocity %1 centimeters per second, toward the probe positive.")
                        .arg(latest.mean_mmps / kAxisUnit_mmps, 0, 'f', 0));
}

void SpectrumStrip::drawAxis(QPainter& painter, double left, double right, double top, double bottom) {
  const double height = bottom - top, highest = rowVelocity_mmps(gate_, -0.5),
               lowest = rowVelocity_mmps(gate_, rows() - 0.5);
  const auto y = [&](double velocity) { return top + height * (highest - velocity) / (highest - lowest); };
  const QColor line = ui::toQColor(views::theme::kLine), quiet = ui::toQColor(views::theme::kQuiet);
  const double step = markStep((highest - lowest) / kAxisUnit_mmps) * kAxisUnit_mmps;
  for (double velocity = step * std::ceil(lowest / step); velocity <= highest; velocity += step) {
    const bool isBaseline = std::abs(velocity) < 0.01 * step;
    painter.setPen(isBaseline ? ui::toQColor(views::theme::kAccent) : line);
    painter.drawLine(QPointF(isBaseline ? left : left - 4, y(velocity)),
                     QPointF(isBaseline ? right : left, y(velocity)));
    if (y(velocity) < top + 16 || y(velocity) > bottom - 5) continue;
    painter.setPen(quiet);
    painter.drawText(QRectF(0, y(velocity) - 8, left - 7, 16), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(velocity / kAxisUnit_mmps, 'f', step < kAxisUnit_mmps ? 1 : 0));
  }
  painter.setPen(quiet);
  painter.drawText(QRectF(2, top - 6, left - 7, 16), Qt::AlignRight | Qt::AlignVCenter, tr("cm/s"));
}

}  // namespace insonate::train
