#include "SpectrumStrip.h"

#include <insonate/ui/Theme.h>

#include <QPainter>
#include <array>
#include <cmath>

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

}  // namespace

SpectrumStrip::SpectrumStrip(QWidget* parent) : TraceStrip(kSpectrumBins, kSpectrumStep_s, parent) {
  setObjectName("spectrum");
  setToolTip(
      tr("Velocities of the blood in the gate over time (PW Doppler), in cm/s; flow toward the probe is above the "
         "baseline"));
  describe();
}

void SpectrumStrip::setGate(const SpectralSettings& gate) {
  const bool sameAxis = nyquistVelocity_mmps(gate) == nyquistVelocity_mmps(gate_) && gate.baseline == gate_.baseline;
  gate_ = gate;
  if (!sameAxis) clear();
}

void SpectrumStrip::append(const std::vector<LiveSpectrum>& spectra) {
  std::array<std::uint8_t, kSpectrumBins> gray{};
  for (const LiveSpectrum& spectrum : spectra) {
    // Spectra that were computed before a change of the axis do not belong to the strip.
    if (nyquistVelocity_mmps(spectrum.gate) != nyquistVelocity_mmps(gate_)) continue;
    const auto column = int(std::lround(spectrum.time_s / kSpectrumStep_s));
    displaySpectrum(spectrum.power, gate_, 1, column, gray);
    TraceStrip::append(spectrum.time_s, gray);
    latest_ = velocitiesOf(spectrum.power, gate_);
  }
  if (!spectra.empty()) describe();
}

void SpectrumStrip::describe() {
  setAccessibleName(tr("Spectrum of PW Doppler. Mean velocity %1 centimeters per second, toward the probe positive.")
                        .arg(latest_.mean_mmps / kAxisUnit_mmps, 0, 'f', 0));
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
