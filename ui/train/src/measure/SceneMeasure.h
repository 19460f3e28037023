#pragma once

#include <insonate/train/LiveRates.h>

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>
#include <functional>
#include <vector>

namespace insonate::ui {
class ViewWidget;
}
namespace insonate::views {
class SceneView;
}

namespace insonate::train {

class ProbeMotion;

/// Measures 3D with the volume-rendered CT: turns the view, zooms, lets the view rest, and moves the probe. Counts
/// frames, and measures for how long the window's thread does not process events.
class SceneMeasure : public QObject {
 public:
  /// Each movement takes `seconds`. `done` is called once, on the window's thread.
  SceneMeasure(ProbeMotion& motion, ui::ViewWidget& scene, double seconds, std::function<void(VolumeRates)> done);
  ~SceneMeasure() override;

 private:
  enum class Part { Warm, Orbit, Zoom, Rest, Follow, LastRest, End };
  bool rests() const { return part_ == Part::Warm || part_ == Part::Rest || part_ == Part::LastRest; }
  void tick();
  void begin(Part part);
  void end(double part_s);
  void move(double part_s);
  void finish();

  ProbeMotion& motion_;
  ui::ViewWidget& widget_;
  views::SceneView& scene_;
  const double seconds_;
  const bool ctWasVisible_;
  std::function<void(VolumeRates)> done_;
  VolumeRates rates_;
  Part part_ = Part::Warm;
  QTimer beat_;
  QElapsedTimer sinceBeat_, sincePart_;
  double moved_s_ = 0, beatProcessor_ms_ = 0;
  int renderings_ = 0;      ///< number of renderings at the beginning of the present part of the measurement
  int beatRenderings_ = 0;  ///< number of renderings at the last timer tick
  /// Durations for which the window processed no events, in intervals in which a frame was drawn: while the view moved
  /// (movingHolds_ms_) and while it was at rest (restHolds_ms_).
  std::vector<double> movingHolds_ms_, restHolds_ms_;
};

}  // namespace insonate::train
