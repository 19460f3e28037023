// The part of the workspace that measures how fast it is.
#include "TrainParts.h"
#include "measure/LiveMeasure.h"
#include "measure/SceneMeasure.h"
#include "scene/PatientViews.h"

#include <insonate/views/SceneTiming.h>

#include <vtkRenderWindow.h>

namespace insonate::train {

void TrainWorkspace::Parts::measureLive(double seconds, bool viewsFollow, std::function<void(LiveRates)> done) {
  patient->setFollowing(viewsFollow);
  measure_ = std::make_unique<LiveMeasure>(session, *imageWidget_, seconds,
                                           [this, done = std::move(done)](const LiveRates& rates) {
                                             patient->setFollowing(true);
                                             done(rates);
                                           });
}

OrbitRates TrainWorkspace::Parts::measureOrbit(int steps) {
  views::SceneView& scene = patient->scene();
  const views::FrameTimes times = views::timeOrbit(scene, steps);
  OrbitRates rates{times.perSecond(), times.median_ms(), times.percentile95_ms(), {}};
  if (vtkRenderWindow* window = scene.renderer()->GetRenderWindow())
    for (const QString& line : QString::fromUtf8(window->ReportCapabilities()).split(QLatin1Char('\n')))
      if (line.startsWith(QLatin1String("OpenGL renderer string:")))
        rates.graphics = line.section(QLatin1Char(':'), 1).trimmed();
  return rates;
}

void TrainWorkspace::Parts::measureVolume(double seconds, std::function<void(VolumeRates)> done) {
  volumeMeasure_ = std::make_unique<SceneMeasure>(session, patient->sceneWidget(), seconds, std::move(done));
}

}  // namespace insonate::train
