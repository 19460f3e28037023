#include "ultrasound/EngineRows.h"
#include "ultrasound/FrameTimer.h"
#include "ultrasound/MachineLimits.h"
#include "ultrasound/PlainLoop.h"
#include "ultrasound/Realism.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/cases/Phantom.h>
#include <insonate/cases/StartPose.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/ultrasound/FrameCost.h>

#include <hwy/targets.h>
#include <tbb/info.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

namespace insonate {
namespace {

using namespace bench;

constexpr std::uint32_t kPhantomSeed = 1;
constexpr std::string_view kW1Engine = "cpu";

/// Small movements of a hand: 0.3 mm out of the plane, 0.15 mm sideways and a fifth of a degree for each frame.
std::vector<Transform> movingProbe(const Transform& start) {
  constexpr int kPoses = 16;
  std::vector<Transform> path;
  for (int i = 0; i < kPoses; ++i) {
    const double angle = 0.2 * i * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    const Transform step{{{Vec3{c, s, 0}, Vec3{-s, c, 0}, Vec3{0, 0, 1}}}, {0.15 * i, 0.3 * i, 0}};
    path.push_back(start * step);
  }
  return path;
}

std::string processorName() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos) return line.substr(line.find(": ") + 2);
  return "unknown";
}

BenchComputer describeMachine(double seconds) {
  BenchComputer machine;
  machine.processor = processorName();
  machine.vectors = hwy::TargetName(hwy::SupportedTargets() & -hwy::SupportedTargets());
  machine.cores = tbb::info::default_concurrency();
  for (const int threads : {1, machine.cores}) {
    if (!machine.limits.empty() && threads == 1) break;
    const MachineLimits l = measureMachine(threads, seconds / 2);
    machine.limits.push_back({threads, l.multiplyAdd_GFLOPs, l.cache_GBps, l.memory_GBps});
  }
  return machine;
}

/// Stages of W1; those of processors compared with the limits of the same number of threads.
std::vector<StageLimits> stageLimits(const UltrasoundBench& bench, const std::vector<StageCost>& work) {
  std::vector<StageLimits> all;
  const UltrasoundBenchRow& w1 = bench.rows.front();
  for (const UltrasoundBenchRow& row : bench.rows) {
    const bool same = row.engine != "reference" && row.look == w1.look && row.scanlines == w1.scanlines &&
                      row.samples == w1.samples && row.elevationPlanes == w1.elevationPlanes;
    if (!same) continue;
    const auto limits = std::find_if(bench.machine.limits.begin(), bench.machine.limits.end(),
                                     [&](const BenchComputer::Limits& l) { return l.threads == row.threads; });
    for (const StageTime& stage : row.stages) {
      StageLimits s{.engine = row.engine, .stage = stage.name, .threads = row.threads, .time = stage};
      const auto known = row.engine == kW1Engine ? std::ranges::find(work, stage.name, &StageCost::name) : work.end();
      if (known != work.end() && stage.min_ms > 0 && limits != bench.machine.limits.end()) {
        // Times of the engine are sums over threads, so that rates apply to one thread.
        const bool summed = known - work.begin() < 4;
        const double share = summed ? limits->threads : 1;
        s.operations = known->operations, s.bytes = known->bytes;
        s.giga_operationsPerSecond = known->operations / stage.min_ms / 1e6 * share;
        s.gigabytesPerSecond = known->bytes / stage.min_ms / 1e6 * share;
        s.percentOfArithmetic = 100 * s.giga_operationsPerSecond / limits->multiplyAdd_GFLOPs;
        s.percentOfCache = 100 * s.gigabytesPerSecond / limits->cache_GBps;
        s.percentOfMemory = 100 * s.gigabytesPerSecond / limits->memory_GBps;
      }
      all.push_back(s);
    }
  }
  return all;
}

FrameTimes timePlainLoop(const UltrasoundBenchPlan& plan, const std::vector<Transform>& path) {
  PlainLoop loop(plan.patient, plan.setup);
  BModeImage image;
  const Patience patience{.least = 3, .seconds = plan.secondsPerRow};
  return timeFrames(patience, [&](int i) { loop.render(path[i % path.size()], image); });
}

/// Start poses over the first target: those whose name equals that of the first pose up to the comma.
std::vector<StartPose> viewsOf(const PatientCase& patient, bool every) {
  std::vector<StartPose> views;
  const auto place = [](const StartPose& pose) { return pose.name.substr(0, pose.name.find(',')); };
  for (const StartPose& pose : patient.manifest.startPoses)
    if (views.empty() || (every && place(pose) == place(views.front()))) views.push_back(pose);
  return views;
}

Result<void> addRealism(const UltrasoundBenchPlan& plan, const ImagingSetup& setup, const PatientCase& patient,
                        const std::string& variant, std::size_t firstView, UltrasoundBench& bench) {
  const std::vector<StartPose> views = viewsOf(patient, plan.everyView);
  for (std::size_t v = firstView; v < views.size(); ++v) {
    const auto pose = patientFromProbe(views[v].position_mm, views[v].axial, views[v].lateral);
    if (!pose) return tl::unexpected(pose.error());
    const auto scene = makeScene(patient, setup, regionOf(setup.probe, setup.settings, *pose));
    if (!scene) return tl::unexpected(scene.error());
    measureRealism(**scene, setup, *pose, variant, views[v].name, bench);
  }
  return {};
}

/// Devices that engines ran on, and the reasons for missing engines.
std::vector<std::string> engineNotes() {
  std::vector<std::string> notes;
  for (const std::string& name : engineNames()) {
    const auto engine = makeEngine(name);
    if (!engine)
      notes.push_back("The engine " + name + " is left out. " + engine.error().message);
    else if (!(*engine)->note().empty())
      notes.push_back("The engine " + name + " ran on " + std::string((*engine)->note()) + ".");
  }
  return notes;
}

constexpr const char* kAboutTimes =
    "median_ms, p95_ms and min_ms are wall-clock times of whole frames, engine and display, with a moving probe; other "
    "programs on the machine lengthen them. cpu_ms is the processor time of the whole program for one frame.";
constexpr const char* kAboutErrors =
    "envelope_error_percent and ssim compare with the reference engine at the same settings and poses. "
    "discretisation_error_percent and discretisation_ssim compare with a dense frame of the reference engine, speckle "
    "left out: more elevation planes hold other scatterers, so that speckle itself cannot converge. gate_mm is the "
    "distance at which echoes are summed; more samples bring it down only to 0.42 of the pulse. Rows of displaced "
    "tissue show what a displacement of the probe's plane adds to a frame, its computation left out; rows of a needle "
    "what one adds that crosses half of the image at 45 degrees.";
constexpr const char* kAboutPlainLoop =
    "The plain loop is a scalar loop of the same workload without boundaries, layers, textures, looks and display "
    "filters, compiled with the same options.";
constexpr const char* kAboutStages =
    "Stage times of the engine cpu are sums over threads, those of the display are wall-clock. Of the engine glsl, "
    "upload is the processor's time, read-back all that remains of the frame (commands, waiting, copying); the stages "
    "between were measured on the card. Operations and bytes are "
    "estimates of what the model asks for, by formula. A frame's data fit the caches, so that more than 100 % of the "
    "memory's bandwidth is no mistake. Integer work and work that is no multiply-add cannot reach the arithmetic peak.";
constexpr const char* kAboutOthers =
    "Reported elsewhere for this workload on other machines, one core: 28 ms for a well-known simulator without "
    "speckle "
    "statistics, beam width or slice thickness; 21 ms for a plain scalar loop; 8 ms for an optimised study, 3.8 ms on "
    "two cores.";

}  // namespace

Result<UltrasoundBenchPlan> ultrasoundBenchPlan(bool quick, const Progress& progress) {
  UltrasoundBenchPlan plan;
  plan.variant = phantomVariants().front().name;
  auto patient = makePhantom(plan.variant, kPhantomSeed, progress);
  if (!patient) return tl::unexpected(patient.error());
  plan.patient = std::move(*patient);
  auto probe = loadProbe("linear");
  if (!probe) return tl::unexpected(probe.error());
  auto tissues = loadAcousticTable("neck");
  if (!tissues) return tl::unexpected(tissues.error());
  plan.setup = {*probe, settingsFor(*probe), std::move(*tissues), std::string(kW1Engine)};
  const auto pose = autoStartPose(plan.patient);
  if (!pose) return tl::unexpected(pose.error());
  const auto start = patientFromProbe(pose->position_mm, pose->axial, pose->lateral);
  if (!start) return tl::unexpected(start.error());
  plan.start = *start;
  if (quick) {
    plan.scanlines = {128}, plan.samples = {500}, plan.elevationPlanes = {1, 5};
    plan.poses = 1, plan.denseScanlines = 512, plan.densePlanes = 7;
    plan.secondsPerRow = 0.2, plan.secondsForLimits = 0.3;
    plan.everyView = false;
    return plan;
  }
  plan.scanlines = {64, 128, 256, 384, 512};
  plan.samples = {250, 500, 900, 1000, 2000};
  plan.elevationPlanes = {1, 3, 5, 7, 9};
  for (const char* variant : {"small-vein", "head-turned", "deep-in-fat", "vein-over-artery"})
    plan.realismVariants.emplace_back(variant);
  return plan;
}

Result<UltrasoundBench> runUltrasoundBench(const UltrasoundBenchPlan& plan, const Progress& progress) {
  ImagingSetup setup = plan.setup;
  setup.engine = kW1Engine;
  setup.tissues = withMarks(setup.tissues);
  if (auto imager = Imager::make(setup); !imager) return tl::unexpected(imager.error());
  const std::vector<Transform> path = movingProbe(plan.start);
  if (auto ok = checkPosesTouchVolume(plan.patient, setup, path); !ok) return tl::unexpected(ok.error());
  Region region = regionOf(setup.probe, setup.settings, path.front());
  for (const SceneRun& run : sceneRuns(setup, path))
    for (int axis = 0; axis < 3; ++axis) {
      region.low_mm[axis] = std::min(region.low_mm[axis], run.region.low_mm[axis]);
      region.high_mm[axis] = std::max(region.high_mm[axis], run.region.high_mm[axis]);
    }
  const auto scene = makeScene(plan.patient, setup, region, progress);
  if (!scene) return tl::unexpected(scene.error());

  UltrasoundBench bench;
  bench.machine = describeMachine(plan.secondsForLimits);
  UltrasoundBenchPlan marked = plan;
  marked.setup = setup;
  const auto rows = EngineRows::make(marked, **scene, path);
  if (!rows) return tl::unexpected(rows.error());
  const double steps = double(rows->settings().size() + plan.realismVariants.size() + 1);
  double done = 0;
  for (const ImagingSettings& settings : rows->settings()) {
    if (!report(progress, "measuring engines", done++ / steps)) return fail(std::string(kCancelled));
    if (auto ok = rows->measure(settings, bench.rows); !ok) return tl::unexpected(ok.error());
    if (&settings != &rows->settings().front()) continue;
    if (auto ok = rows->measureDisplaced(bench.rows); !ok) return tl::unexpected(ok.error());
    if (auto ok = rows->measureNeedle(bench.rows); !ok) return tl::unexpected(ok.error());
  }
  bench.plainLoop = timePlainLoop(marked, path);
  bench.stages = stageLimits(bench, frameCost(setup.probe, setup.settings, **scene));

  if (!report(progress, "measuring images", done++ / steps)) return fail(std::string(kCancelled));
  const std::vector<StartPose> views = viewsOf(plan.patient, false);
  measureRealism(**scene, setup, plan.start, plan.variant, views.empty() ? "start" : views.front().name, bench);
  if (auto ok = addRealism(plan, setup, plan.patient, plan.variant, 1, bench); !ok) return tl::unexpected(ok.error());
  for (const std::string& variant : plan.realismVariants) {
    if (!report(progress, "measuring images", done++ / steps)) return fail(std::string(kCancelled));
    const auto patient = makePhantom(variant, kPhantomSeed);
    if (!patient) return tl::unexpected(patient.error());
    if (auto ok = addRealism(plan, setup, *patient, variant, 0, bench); !ok) return tl::unexpected(ok.error());
  }
  if (plan.penetration) {
    auto penetration = penetrationRows(progress);
    if (!penetration) return tl::unexpected(penetration.error());
    bench.penetration = std::move(*penetration);
  }
  bench.notes = engineNotes();
  for (const char* about : {kAboutTimes, kAboutErrors, kAboutPlainLoop, kAboutStages, kAboutOthers})
    bench.notes.emplace_back(about);
  report(progress, "measuring images", 1);
  return bench;
}

}  // namespace insonate
