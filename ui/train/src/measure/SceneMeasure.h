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

/// Turns the patient with the CT cast in 3D, comes nearer, lets it rest, and moves the probe before it; counts the
/// images, and how long the window's thread is away from its events meanwhile.
class SceneMeasure : public QObject {
 public:
  /// `seconds` for each movement. `done` is called once, on the window's thread.
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
  int renderings_ = 0;                                 ///< at the part's begin
  int beatRenderings_ = 0;                             ///< at the last beat
  std::vector<double> movingHolds_ms_, restHolds_ms_;  ///< with an image
};

}  // namespace insonate::train
