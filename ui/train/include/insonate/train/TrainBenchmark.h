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

/// Measures how fast a workspace shows images, 3D and hands. For the window's thread; each `done` is called there
/// later, unless the workspace is deleted first.
class TrainBenchmark final {
 public:
  /// All of them must outlive this.
  TrainBenchmark(TrainModel& model, ui::ViewWidget& image, PatientViews& patient);
  ~TrainBenchmark();

  /// Moves the linear probe with its own settings for a while and times the images on the screen, while 3D and CT
  /// follow or stand still. There must be an image.
  void measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done);
  /// Measures with a needle in the hand and 3D following.
  void measureHands(double seconds, std::function<void(HandRates)> done);
  /// Turns the patient in 3D, and returns when that is done.
  OrbitRates measureOrbit(int steps);
  /// Shows the CT in 3D and moves there and with the probe, `seconds` each.
  void measureVolume(double seconds, std::function<void(VolumeRates)> done);

 private:
  TrainModel& model_;
  ui::ViewWidget& image_;
  PatientViews& patient_;
  std::unique_ptr<LiveMeasure> live_;
  std::unique_ptr<SceneMeasure> volume_;
};

}  // namespace insonate::train
