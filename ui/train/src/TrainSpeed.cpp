// The part of the workspace that measures how fast it is.
#include "TrainParts.h"
#include "measure/LiveMeasure.h"
#include "measure/SceneMeasure.h"
#include "patient3d/PatientViews.h"

#include <insonate/views/SceneTiming.h>

namespace insonate::train {

void TrainWorkspace::Parts::measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done) {
  patient->setFollowing(viewsFollow);
  measure_ = std::make_unique<LiveMeasure>(model.imaging, model.live, model.motion, *imageWidget_, seconds,
                                           [this, done = std::move(done)](const LiveRates& rates) {
                                             patient->setFollowing(true);
                                             done(rates);
                                           });
}

void TrainWorkspace::Parts::measureHands(double seconds, std::function<void(HandRates)> done) {
  HandsControl& hands = model.hands;
  hands.takeNeedle(NeedlePlane::Along);
  measureLive(seconds, true, [&hands, done = std::move(done)](const LiveRates& live) {
    const TickTiming ticks = hands.session().timing();
    hands.layNeedleDown();
    done({live.imagesPerSecond, double(ticks.ticks), double(ticks.late), ticks.p50_us, ticks.p99_us, ticks.p999_us,
          ticks.max_us});
  });
}

OrbitRates TrainWorkspace::Parts::measureOrbit(int steps) {
  views::SceneView& scene = patient->scene();
  const views::FrameTimes times = views::timeOrbit(scene, steps);
  return {times.perSecond(), times.median_ms(), times.percentile95_ms(), QString::fromStdString(scene.graphics())};
}

void TrainWorkspace::Parts::measureVolume(double seconds, std::function<void(VolumeRates)> done) {
  volumeMeasure_ = std::make_unique<SceneMeasure>(model.motion, patient->sceneWidget(), seconds, std::move(done));
}

}  // namespace insonate::train
