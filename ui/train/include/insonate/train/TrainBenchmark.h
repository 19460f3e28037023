#pragma once

#include <insonate/train/LiveRates.h>

#include <functional>
#include <memory>

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

class LiveMeasure;
class PatientViews;
class SceneMeasure;
struct TrainModel;

/// Measures the speed of a Train workspace: images, 3D and haptic servo. For the window's thread; each `done` is called
/// on that thread, later, unless the workspace is deleted first.
class TrainBenchmark final {
 public:
  /// All arguments must outlive this object.
  TrainBenchmark(TrainModel& model, ui::ViewWidget& image, PatientViews& patient);
  ~TrainBenchmark();

  /// Moves the linear probe with its default settings for `seconds` and times the images on the screen. `viewsFollow`:
  /// 3D and CT follow the probe. A live image must be shown before the call.
  void measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done);
  /// Measures the servo for `seconds` with a needle in the hand and 3D following the probe.
  void measureHands(double seconds, std::function<void(HandRates)> done);
  /// Turns the 3D view by this number of steps; returns after the last.
  OrbitRates measureOrbit(int steps);
  /// Shows the CT in 3D and measures while the view orbits, while it zooms, and while the probe moves, `seconds` each.
  void measureVolume(double seconds, std::function<void(VolumeRates)> done);

 private:
  TrainModel& model_;
  ui::ViewWidget& image_;
  PatientViews& patient_;
  std::unique_ptr<LiveMeasure> live_;
  std::unique_ptr<SceneMeasure> volume_;
};

}  // namespace insonate::train
