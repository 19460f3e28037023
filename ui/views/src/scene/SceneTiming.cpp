#include <insonate/views/SceneTiming.h>
#include <insonate/views/SceneView.h>

#include <algorithm>
#include <chrono>

namespace insonate::views {
namespace {

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ptrdiff_t(share * double(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double timeRender_ms(SceneView& view) {
  const auto start = std::chrono::steady_clock::now();
  view.render();
  view.finish();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

double FrameTimes::median_ms() const {
  return quantile(moving_ms, 0.5);
}

double FrameTimes::percentile95_ms() const {
  return quantile(moving_ms, 0.95);
}

double FrameTimes::perSecond() const {
  const double median = median_ms();
  return median > 0 ? 1000 / median : 0;
}

FrameTimes timeOrbit(SceneView& view, int steps, double step_deg) {
  FrameTimes times;
  if (steps < 1) return times;
  const bool wasMoving = view.isMoving();
  view.setMoving(true);
  // The first image creates buffers and shaders.
  timeRender_ms(view);
  for (int step = 0; step < steps; ++step) {
    view.orbit(step_deg, 0);
    times.moving_ms.push_back(timeRender_ms(view));
  }
  view.orbit(-step_deg * steps, 0);
  view.setMoving(false);
  times.still_ms = timeRender_ms(view);
  view.setMoving(wasMoving);
  return times;
}

}  // namespace insonate::views
