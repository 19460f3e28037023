#include "ultrasound/FrameTimer.h"

#include <insonate/core/ProcessorTime.h>

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>

namespace insonate::bench {
namespace {

using Clock = std::chrono::steady_clock;

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto at = std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())));
  std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(at), values.end());
  return values[at];
}

}  // namespace

FrameTimes timeFrames(const Patience& patience, const std::function<void(int frame)>& frame) {
  for (int i = 0; i < patience.warmUp; ++i) frame(i);
  std::vector<double> wall_ms, cpu_ms;
  const auto begin = Clock::now();
  for (int i = 0; i < patience.most; ++i) {
    const double cpu = processTime_ms();
    const auto start = Clock::now();
    frame(patience.warmUp + i);
    const auto end = Clock::now();
    wall_ms.push_back(std::chrono::duration<double, std::milli>(end - start).count());
    cpu_ms.push_back(processTime_ms() - cpu);
    if (i + 1 >= patience.least && std::chrono::duration<double>(end - begin).count() > patience.seconds) break;
  }
  return {static_cast<int>(wall_ms.size()), quantile(wall_ms, 0.5), quantile(wall_ms, 0.95), quantile(wall_ms, 0),
          quantile(cpu_ms, 0.5)};
}

void PlaneContents::render(Imager& imager, const AcousticScene& scene, const Transform& patientFromProbe,
                           ImagingFrame& frame) const {
  if (!needle) return imager.render(scene, patientFromProbe, displacement, nullptr, frame);
  Needle inPatient = *needle;
  inPatient.tip_mm = patientFromProbe * needle->tip_mm;
  inPatient.direction = patientFromProbe.linear * needle->direction;
  inPatient.bevelNormal = patientFromProbe.linear * needle->bevelNormal;
  imager.render(scene, patientFromProbe, displacement, &inPatient, frame);
}

TimedFrames timeImager(Imager& imager, const AcousticScene& scene, std::span<const Transform> path,
                       const PlaneContents& contents, int threads, const Patience& patience) {
  tbb::task_arena arena(threads);
  TimedFrames result;
  ImagingFrame frame;
  std::vector<std::vector<double>> stages;
  const int period = std::max(1, 2 * (static_cast<int>(path.size()) - 1));
  arena.execute([&] {
    result.times = timeFrames(patience, [&](int i) {
      const int at = i % period;
      contents.render(imager, scene, path[std::min(at, period - at)], frame);
      stages.resize(frame.stages.size());
      if (i < patience.warmUp) return;
      for (std::size_t s = 0; s < stages.size(); ++s) stages[s].push_back(frame.stages[s].ms);
    });
  });
  for (std::size_t s = 0; s < stages.size(); ++s)
    result.stages.push_back({frame.stages[s].name, quantile(stages[s], 0.5), quantile(stages[s], 0)});
  return result;
}

}  // namespace insonate::bench
