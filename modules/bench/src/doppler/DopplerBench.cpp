#include "doppler/TubeCase.h"

#include <insonate/bench/DopplerBench.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/MovingBlood.h>

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>

namespace insonate {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180;

double percent(double measured, double expected, double scale) {
  return 100 * std::abs(measured - expected) / std::abs(scale);
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * double(values.size())))];
}

/// Velocities at known angles, and just below and above the Nyquist velocity.
Result<void> addVelocities(const std::string& engine, DopplerBench& bench) {
  for (const double angle_deg : {30.0, 40.0, 50.0, 60.0, 70.0}) {
    auto tube = bench::TubeCase::make(angle_deg, 4);
    if (!tube) return tl::unexpected(tube.error());
    const double measured = tube->middleVelocity_mmps(engine, 200),
                 expected = 200 * std::cos(angle_deg * kRadiansPerDegree);
    bench.rows.push_back({engine, "velocity toward the probe", bench::fixed(angle_deg, 0) + " degrees", "mm/s",
                          expected, measured, percent(measured, expected, expected), 3});
  }
  auto tube = bench::TubeCase::make(0.01, 4);
  if (!tube) return tl::unexpected(tube.error());
  const double nyquist = nyquistVelocity_mmps(tube->color);
  for (const double share : {0.97, 1.03, 1.5}) {
    const double measured = tube->middleVelocity_mmps(engine, share * nyquist);
    const double expected = (share > 1 ? share - 2 : share) * nyquist;
    bench.rows.push_back({engine, "velocity at the Nyquist limit", bench::fixed(share, 2) + " of the Nyquist velocity",
                          "mm/s", expected, measured, percent(measured, expected, nyquist), 3});
  }
  return {};
}

/// Area of color over the area of the lumen, in the long axis of a tube with plug flow.
Result<void> addAreas(const std::string& engine, DopplerBench& bench) {
  auto tube = bench::TubeCase::make(60, 3);
  if (!tube) return tl::unexpected(tube.error());
  for (const double gain_dB : {-15.0, -10.0, -5.0, 0.0, 5.0, 10.0}) {
    tube->color.gain_dB = gain_dB;
    const auto [colored, lumen] = tube->areas_mm2(engine, 200);
    bench.rows.push_back({engine, "area of color", "gain " + bench::fixed(gain_dB, 0) + " dB", "mm2", lumen, colored,
                          percent(colored, lumen, lumen), 0});
  }
  return {};
}

/// Volume flow through cross-sections of the vessels of the built-in neck, from the velocities at points.
void addConservation(const PatientCase& neck, DopplerBench& bench) {
  BloodFlowModel model(neck.manifest.vessels);
  BloodFlow flow;
  model.at({}, 0.1, {}, flow);
  for (const char* name : {"right common carotid artery", "right internal jugular vein"})
    for (std::size_t v = 0; v < flow.tubes.size(); ++v) {
      if (neck.manifest.vessels[v].name != name) continue;
      const double expected = model.volumeFlow(v).now_mm3ps * 0.06;
      const BloodTube& tube = flow.tubes[v];
      const std::size_t last = tube.course.size() - 1;
      for (const std::size_t point : {last / 4, last / 2, 3 * last / 4}) {
        const double measured = bench::flowThrough_mm3ps(tube, tube.course[point]) * 0.06;
        bench.rows.push_back({"flow", "volume flow of the " + std::string(name),
                              "point " + std::to_string(point) + " of " + std::to_string(last), "mL/min", expected,
                              measured, percent(measured, expected, expected), 1});
      }
    }
}

/// Both imagers render the same pose in turn, so that other work on the computer affects both alike.
Result<ColorCost> costOf(const UltrasoundBenchPlan& plan, const AcousticScene& scene, const std::string& engine,
                         int threads, int frames) {
  ImagingSetup setup = plan.setup;
  setup.engine = engine;
  auto plain = Imager::make(setup);
  if (!plain) return tl::unexpected(plain.error());
  setup.color = colorSettingsFor(setup.probe, setup.settings);
  auto colored = Imager::make(setup);
  if (!colored) return tl::unexpected(colored.error());
  MovingBlood blood(plan.patient.manifest.vessels);
  ImagingFrame without, with;
  ColorCost cost;
  cost.engine = engine, cost.threads = threads;
  std::vector<double> color_ms;
  tbb::task_arena arena(threads);
  arena.execute([&] {
    std::vector<double> plain_ms, colored_ms;
    constexpr int kWarmUp = 2;
    for (int frame = 0; frame < frames + kWarmUp; ++frame) {
      plain->render(scene, plan.start, without);
      with.motion.blood = &blood.at({}, frame / 30.0, {}, plan.start);
      colored->render(scene, plan.start, with);
      if (frame < kWarmUp) continue;
      plain_ms.push_back(without.frame_ms), colored_ms.push_back(with.frame_ms);
      color_ms.push_back(with.stages.back().ms);
    }
    cost.plain_ms = quantile(plain_ms, 0.5), cost.plainMin_ms = quantile(plain_ms, 0);
    cost.colored_ms = quantile(colored_ms, 0.5), cost.coloredMin_ms = quantile(colored_ms, 0);
    cost.color_ms = quantile(color_ms, 0.5), cost.colorMin_ms = quantile(color_ms, 0);
  });
  cost.device = engine == "cpu" ? "the processor" : with.engineNote;
  return cost;
}

/// The reference computes a frame in seconds, and is left out.
Result<void> addCosts(const UltrasoundBenchPlan& plan, const AcousticScene& scene,
                      const std::vector<std::string>& engines, bool quick, const Progress& progress,
                      DopplerBench& bench) {
  for (const std::string& engine : engines) {
    if (engine == "reference") continue;
    // A graphics card leaves only the display stages to the processor.
    const int all = tbb::info::default_concurrency();
    for (const int threads : engine == "glsl" ? std::vector{all} : std::vector{1, 2}) {
      if (!report(progress, "Measuring the cost of color", 0.7)) return fail(std::string(kCancelled));
      auto cost = costOf(plan, scene, engine, threads, quick ? 15 : 100);
      if (!cost) return tl::unexpected(cost.error());
      bench.costs.push_back(*cost);
    }
  }
  return {};
}

SpectralCost spectralCostOf(const UltrasoundBenchPlan& plan, const AcousticScene& scene, int images) {
  constexpr double kImagesPerSecond = 30;
  constexpr int kSoundRate_Hz = 48000;
  const SpectralSettings gate = spectralSettingsFor(plan.setup.probe, plan.setup.settings);
  SpectralDoppler doppler(plan.setup.probe, plan.setup.settings, gate);
  DopplerSound sound(gate.prf_Hz, kSoundRate_Hz, 1);
  MovingBlood blood(plan.patient.manifest.vessels);
  std::vector<double> hold_ms, spectrum_ms, sound_ms, power;
  std::vector<float> samples;
  const auto timed = [](std::vector<double>& times_ms, const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times_ms.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  };
  for (int image = 0; image < images; ++image) {
    const double time_s = image / kImagesPerSecond;
    timed(hold_ms, [&] { doppler.hold(scene, plan.start, {}, blood.at({}, time_s, {}, plan.start)); });
    for (double step_s = 0; step_s < 1 / kImagesPerSecond; step_s += kSpectrumStep_s) {
      timed(spectrum_ms, [&] { doppler.spectrum(blood.again({}, time_s + step_s), {}, power); });
      samples.clear();
      timed(sound_ms, [&] { sound.append(power, 0, kSpectrumStep_s, samples); });
    }
  }
  SpectralCost cost{quantile(hold_ms, 0.5), quantile(spectrum_ms, 0.5), quantile(sound_ms, 0.5)};
  cost.perSecond_ms = kImagesPerSecond * cost.hold_ms + (cost.spectrum_ms + cost.sound_ms) / kSpectrumStep_s;
  return cost;
}

}  // namespace

Result<DopplerBench> runDopplerBench(bool quick, const Progress& progress) {
  DopplerBench bench;
  const auto plan = ultrasoundBenchPlan(quick, progress);
  if (!plan) return tl::unexpected(plan.error());
  std::vector<std::string> engines;
  for (const std::string& engine : colorDopplerNames()) {
    if (const auto doppler = makeColorDoppler(engine); !doppler) {
      bench.notes.push_back("The engine " + engine + " was left out. " + doppler.error().message);
      continue;
    }
    engines.push_back(engine);
    if (!report(progress, "Measuring color Doppler", engine == "cpu" ? 0.4 : 0.2)) return fail(std::string(kCancelled));
    if (auto ok = addVelocities(engine, bench); !ok) return tl::unexpected(ok.error());
    if (auto ok = addAreas(engine, bench); !ok) return tl::unexpected(ok.error());
  }
  addConservation(plan->patient, bench);
  const auto scene = makeScene(plan->patient, plan->setup, sceneRegion(plan->setup, plan->start), progress);
  if (!scene) return tl::unexpected(scene.error());
  if (auto ok = addCosts(*plan, **scene, engines, quick, progress, bench); !ok) return tl::unexpected(ok.error());
  bench.spectral = spectralCostOf(*plan, **scene, quick ? 10 : 60);
  const auto notes = {
      "Velocities: plug flow of 200 mm/s in a tube with a radius of 4 mm, in the middle of the color box, without "
      "noise.",
      "Areas: a tube with a radius of 3 mm in its long axis, plug flow, with noise. Above the area of the lumen, color "
      "blooms over the walls.",
      "Volume flows: at the systolic peak, integrated over the velocities in circles around the center line.",
      "Cost: workload W1 (256 scanlines of 1000 samples, three planes, three looks), the default color box of the "
      "linear "
      "probe over the right jugular vein. The stage color includes the display of color."};
  bench.notes.insert(bench.notes.begin(), notes.begin(), notes.end());
  return bench;
}

}  // namespace insonate
