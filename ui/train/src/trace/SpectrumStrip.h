#pragma once

#include "TraceStrip.h"

#include <insonate/simulator/LiveImaging.h>

#include <vector>

namespace insonate::train {

/// The spectrum of PW Doppler over time, with an axis of velocity. The strip keeps the spectra that it shows, so that a
/// change of angle, baseline or gain also changes those of the past, and those of a frozen image.
class SpectrumStrip final : public TraceStrip {
  Q_OBJECT

 public:
  explicit SpectrumStrip(QWidget* parent = nullptr);

  /// Sets the gate for axis and gain. Clears the strip if the spectra of the gate have other velocities than those that
  /// are shown; otherwise draws these again.
  void setGate(const SpectralSettings& gate);
  void append(const std::vector<LiveSpectrum>& spectra);
  void clear() override;

 private:
  void drawAxis(QPainter& painter, double left, double right, double top, double bottom) override;
  void draw(const LiveSpectrum& spectrum);
  void drawAgain();
  void describe();

  SpectralSettings gate_;
  std::vector<LiveSpectrum> kept_;  ///< shown spectra, in a ring once there are as many as the strip shows
  std::size_t oldest_ = 0;
};

}  // namespace insonate::train
