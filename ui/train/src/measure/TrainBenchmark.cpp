#include "../model/TrainModel.h"
#include "../patient3d/PatientViews.h"
#include "JumpMeasure.h"
#include "LiveMeasure.h"
#include "SceneMeasure.h"

#include <insonate/train/TrainBenchmark.h>
#include <insonate/ui/ViewWidget.h>
#include <insonate/views/SceneTiming.h>

#include <utility>

namespace insonate::train {

TrainBenchmark::TrainBenchmark(TrainModel& model, ui::ViewWidget& image, PatientViews& patient)
    : model_(model), image_(image), patient_(patient) {}

TrainBenchmark::~TrainBenchmark() = default;

void TrainBenchmark::measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done) {
  patient_.setFollowing(viewsFollow);
  live_ = std::make_unique<LiveMeasure>(model_.imaging, model_.live, model_.motion, image_, seconds,
                                        [this, done = std::move(done)](const LiveRates& rates) {
                                          patient_.setFollowing(true);
                                          done(rates);
                                        });
}

void TrainBenchmark::measureJumps(int jumps, std::function<void(JumpRates)> done) {
  jumps_ =
      std::make_unique<JumpMeasure>(model_.patientCase, model_.live, model_.motion, image_, jumps, std::move(done));
}

void TrainBenchmark::measureHands(double seconds, std::function<void(HandRates)> done) {
  HapticControl& hands = model_.hands;
  hands.takeNeedle(NeedlePlane::InPlane);
  measureLive(seconds, true, [&hands, done = std::move(done)](const LiveRates& live) {
    const TickTiming ticks = hands.session().tickTiming();
    hands.removeNeedle();
    done({live.imagesPerSecond, double(ticks.ticks), double(ticks.late), ticks.p50_us, ticks.p99_us, ticks.p999_us,
          ticks.max_us});
  });
}

OrbitRates TrainBenchmark::measureOrbit(int steps) {
  views::SceneView& scene = patient_.scene();
  const views::FrameTimes times = views::timeOrbit(scene, steps);
  return {times.perSecond(), times.median_ms(), times.percentile95_ms(), QString::fromStdString(scene.rendererName())};
}

void TrainBenchmark::measureVolume(double seconds, std::function<void(VolumeRates)> done) {
  volume_ = std::make_unique<SceneMeasure>(model_.motion, patient_.sceneWidget(), seconds, std::move(done));
}

}  // namespace insonate::train
