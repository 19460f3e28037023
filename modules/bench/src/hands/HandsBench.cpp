#include "hands/HandScenes.h"

#include <insonate/bench/HandsBench.h>
#include <insonate/camera/HandTracker.h>
#include <insonate/core/ProcessorTime.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace insonate {
namespace {

using bench::HandScene;

constexpr const char* kImages =
    "Rendered images at 30 fps of the built-in bodies `needle` and `probe` in hand-like motions (three sinusoids on "
    "each "
    "axis) with shading, noise, motion blur, blur of the lens, lens distortion and a background with edges. The "
    "distance "
    "from the camera is 50 cm unless the condition states another.";
constexpr const char* kBodies =
    "The tip of the needle is 85 mm from the middle of its body; the center of the probe's face is 120 mm from the "
    "middle "
    "of its body. Errors are in the camera frame.";
constexpr const char* kLens =
    "The lens is known exactly, and the bodies are exact, except in the condition 'paper body': each tag is off by 0.3 "
    "mm "
    "and turned by 0.5 degrees (standard deviations), and the print is 0.3 % too large.";
constexpr const char* kMethods =
    "Corners: joint pose of the corners of all tags. Intensities: the same, refined by the gray values. Both are "
    "filtered.";
constexpr const char* kLatency =
    "Latency is computed: half the exposure, one frame interval (33.3 ms) for readout and transfer, computing, and the "
    "filter's lag. It was not measured with a real camera. All rows of an image are exposed at the same time; the "
    "rolling "
    "shutter of most webcams is not simulated.";

constexpr double kFrame_s = 1.0 / 30, kFrame_ms = 1e3 * kFrame_s;

double rootMeanSquare(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return values.empty() ? 0 : std::sqrt(sum / double(values.size()));
}

double percentileOf(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, std::size_t(share * double(values.size())))];
}

Vec3 tipOf(const TagBody& body, const Transform& cameraFromBody) {
  return cameraFromBody * body.bodyFromTool.offset;
}
Vec3 axisOf(const TagBody& body, const Transform& cameraFromBody) {
  return cameraFromBody.linear * body.bodyFromTool.linear.column[2];
}

/// The course of the needle's tip by one method.
struct Course {
  std::vector<double> times_s;
  std::vector<Vec3> tips;
  std::vector<double> tips_mm, directions_deg, probes_mm;
  int frames = 0, seen = 0;

  void add(const HandScene& scene, const std::vector<TrackedHand>& states, double time_s) {
    ++frames;
    const Transform needle = scene.objects[0].cameraFromBody(time_s), probe = scene.objects[1].cameraFromBody(time_s);
    if (states[0].sight == HandSight::kTracked) {
      ++seen;
      const Vec3 a = axisOf(scene.needle, states[0].cameraFromBody), b = axisOf(scene.needle, needle);
      times_s.push_back(time_s);
      tips.push_back(tipOf(scene.needle, states[0].cameraFromBody));
      tips_mm.push_back(norm(tips.back() - tipOf(scene.needle, needle)));
      directions_deg.push_back(std::atan2(norm(cross(a, b)), dot(a, b)) * 180 / std::numbers::pi);
    }
    if (states[1].sight == HandSight::kTracked)
      probes_mm.push_back(norm(tipOf(scene.probe, states[1].cameraFromBody) - tipOf(scene.probe, probe)));
  }

  HandsBenchErrors errors() const {
    return {rootMeanSquare(tips_mm), percentileOf(tips_mm, 0.95), rootMeanSquare(directions_deg),
            rootMeanSquare(probes_mm), double(seen) / std::max(1, frames)};
  }

  /// The delay with which the tips follow the truth best, ms.
  double lag_ms(const HandScene& scene) const {
    double best_ms = 0, least = 1e30;
    for (double delay_ms = -40; delay_ms <= 60; delay_ms += 0.5) {
      double sum = 0;
      for (std::size_t i = 0; i < tips.size(); ++i) {
        const Vec3 d = tips[i] - tipOf(scene.needle, scene.objects[0].cameraFromBody(times_s[i] - 1e-3 * delay_ms));
        sum += dot(d, d);
      }
      if (sum < least) least = sum, best_ms = delay_ms;
    }
    return best_ms;
  }

  double jitter_mm() const {
    Vec3 mean;
    for (const Vec3& tip : tips) mean = mean + tip / double(tips.size());
    std::vector<double> distances;
    for (const Vec3& tip : tips) distances.push_back(norm(tip - mean));
    return rootMeanSquare(distances);
  }
};

double speedOf(const HandScene& scene, int frames) {
  std::vector<double> speeds;
  for (int i = 0; i < frames; ++i) {
    const double t = i * kFrame_s, dt = 1e-3;
    speeds.push_back(norm(tipOf(scene.needle, scene.objects[0].cameraFromBody(t + dt)) -
                          tipOf(scene.needle, scene.objects[0].cameraFromBody(t))) /
                     dt);
  }
  return rootMeanSquare(speeds);
}

std::optional<HandsBenchRow> measured(const HandScene& scene, int frames, unsigned seed, double begin, double share,
                                      const Progress& progress) {
  SimulatedCamera camera(scene.sensor, seed);
  const std::vector<TagBody> bodies{scene.needle, scene.probe};
  HandTracker byCorners(scene.sensor.lens, bodies, PoseMethod::kCorners), byIntensities(scene.sensor.lens, bodies);
  Course corners, intensities;
  std::vector<double> costs_ms;
  const int settle = std::min(15, frames / 3);
  for (int i = 0; i < frames; ++i) {
    if (!report(progress, "Tracking hands", begin + share * i / frames)) return std::nullopt;
    const double time_s = i * kFrame_s;
    CameraFrame frame = camera.render(scene.objects, time_s);
    ++frame.time_ns;
    const auto& first = byCorners.process(frame);
    const double before_ms = threadTime_ms();
    const auto& second = byIntensities.process(frame);
    if (i < settle) continue;
    costs_ms.push_back(threadTime_ms() - before_ms);
    corners.add(scene, first, time_s), intensities.add(scene, second, time_s);
  }
  HandsBenchRow row;
  row.condition = scene.name, row.width = scene.sensor.lens.width, row.height = scene.sensor.lens.height;
  row.frames = int(costs_ms.size()), row.speed_mmps = speedOf(scene, frames);
  row.corners = corners.errors(), row.intensities = intensities.errors();
  row.cost_ms = percentileOf(costs_ms, 0.5), row.core = row.cost_ms / kFrame_ms;
  if (row.speed_mmps > 1)
    row.lag_ms = intensities.lag_ms(scene);
  else
    row.jitter_mm = intensities.jitter_mm();
  row.latency_ms = 0.5 * scene.sensor.exposure_ms + kFrame_ms + row.cost_ms + row.lag_ms;
  return row;
}

}  // namespace

Result<HandsBench> runHandsBench(bool quick, const Progress& progress) {
  const auto scenes = bench::handScenes();
  if (!scenes) return tl::unexpected(scenes.error());
  HandsBench bench;
  const std::size_t count = quick ? 2 : scenes->size();
  const int frames = quick ? 12 : 45;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = 1.0 / double(count);
    constexpr unsigned kSeed = 20260;
    auto row = measured((*scenes)[i], frames, kSeed + unsigned(i), double(i) * share, share, progress);
    if (!row) return fail(std::string(kCancelled));
    bench.rows.push_back(std::move(*row));
  }
  bench.notes = {kImages, kBodies, kLens, kMethods, kLatency};
  return bench;
}

}  // namespace insonate
