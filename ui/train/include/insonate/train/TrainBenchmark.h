#pragma once

#include <insonate/train/LiveRates.h>

#include <functional>
#include <memory>

namespace insonate::ui {
class ViewWidget;
}

namespace insonate::train {

class JumpMeasure;
class LiveMeasure;
class PatientViews;
class SceneMeasure;
struct TrainModel;

/// Measures the speed of a Train workspace: live images, 3D view and force loop. May be used only on the window's
/// thread. When a measurement is complete, its `done` is called on this thread, unless the workspace is deleted first.
class TrainBenchmark final {
 public:
  /// All arguments must outlive this object.
  TrainBenchmark(TrainModel& model, ui::ViewWidget& image, PatientViews& patient);
  ~TrainBenchmark();

  /// Moves the linear probe with its default settings for `seconds` and measures the frame rate on the screen.
  /// `viewsFollow`, true: the 3D view and the CT follow the probe. A live image must be shown before the call.
  void measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done);
  /// Moves the probe to `jumps` random places of the skin and measures the time to the image of each place, while the
  /// 3D view and the CT follow the probe.
  void measureJumps(int jumps, std::function<void(JumpRates)> done);
  /// Measures the force loop for `seconds` while a device moves the needle and the 3D view follows the probe.
  void measureHands(double seconds, std::function<void(HandRates)> done);
  /// Turns the 3D view by this number of steps and returns the frame rate. Blocks until the last step.
  OrbitRates measureOrbit(int steps);
  /// Shows the CT in the 3D view, and measures for `seconds` each while the view orbits, while it zooms, and while the
  /// probe moves.
  void measureVolume(double seconds, std::function<void(VolumeRates)> done);

 private:
  TrainModel& model_;
  ui::ViewWidget& image_;
  PatientViews& patient_;
  std::unique_ptr<LiveMeasure> live_;
  std::unique_ptr<JumpMeasure> jumps_;
  std::unique_ptr<SceneMeasure> volume_;
};

}  // namespace insonate::train
