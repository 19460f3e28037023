#pragma once

#include "TraceStrip.h"

#include <insonate/simulator/LiveImaging.h>

#include <vector>

namespace insonate::train {

/// The spectrum of PW Doppler over time, with an axis of velocity.
class SpectrumStrip final : public TraceStrip {
  Q_OBJECT

 public:
  explicit SpectrumStrip(QWidget* parent = nullptr);

  /// Sets the gate for axis and gain; clears the strip if the axis has changed.
  void setGate(const SpectralSettings& gate);
  void append(const std::vector<LiveSpectrum>& spectra);

 private:
  void drawAxis(QPainter& painter, double left, double right, double top, double bottom) override;
  void describe();

  SpectralSettings gate_;
  SpectrumVelocities latest_;
};

}  // namespace insonate::train
