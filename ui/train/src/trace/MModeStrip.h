#pragma once

#include "TraceStrip.h"

#include <insonate/simulator/LiveImaging.h>

#include <vector>

namespace insonate::train {

/// One scanline of the image over time (M-mode), with an axis of depth. The strip has a column for each 10 ms, which is
/// interpolated between two images.
class MModeStrip final : public TraceStrip {
  Q_OBJECT

 public:
  static constexpr int kRows = 320;
  static constexpr double kColumn_s = 0.01;

  explicit MModeStrip(QWidget* parent = nullptr);

  /// Appends the scanline of a live image; `across` is its fraction of the field of view from the left edge.
  void append(const LiveFrame& frame, double across);
  /// Repeats the last scanline up to a time (LiveFrame::time_s), since without motion there are no new images.
  void repeatUntil(double time_s);

 private:
  void drawAxis(QPainter& painter, double left, double right, double top, double bottom) override;

  std::vector<std::uint8_t> before_, now_, between_;
  double before_s_ = 0, across_ = 0, depth_mm_ = 0;
  long long column_ = 0;  ///< number of the last column; its time is column_ * kColumn_s
};

}  // namespace insonate::train
