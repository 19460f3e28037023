#pragma once

#include <insonate/core/Transform.h>
#include <insonate/train/LiveRates.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

class ImagingModel;
class LiveModel;
class ProbeMotion;

/// Slides and turns the probe like a hand, and measures the times of the resulting images. The first images do not
/// count, since scenes and memory are set up during them.
class LiveMeasure : public QObject {
 public:
  /// `done` is called once, on the window's thread.
  LiveMeasure(ImagingModel& imaging, LiveModel& live, ProbeMotion& motion, ui::ViewWidget& image, double seconds,
              std::function<void(LiveRates)> done);

 private:
  void move();
  void begin();
  void arrived();
  void drawn();
  void finish();

  ImagingModel& imaging_;
  LiveModel& live_;
  ProbeMotion& motion_;
  const double seconds_;
  std::function<void(LiveRates)> done_;
  bool begun_ = false;
  double begun_ms_ = 0;
  QTimer hand_;
  QElapsedTimer clock_;
  double moved_s_ = 0, cpu_ms_ = 0, window_ms_ = 0;
  std::deque<std::pair<Transform, double>> sent_;  ///< poses that were sent, and the times of sending in ms
  std::optional<double> shown_ms_;                 ///< time at which the pose of the image on display was sent
  std::vector<double> latency_ms_;
};

}  // namespace insonate::train
