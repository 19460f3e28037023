#include "conformance/Measure.h"
#include "conformance/Rig.h"

#include <insonate/ultrasound/PointSpread.h>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cmath>

namespace insonate::test {
namespace {

class Coherence : public EngineTest {};
INSONATE_FOR_ALL_ENGINES(Coherence);

constexpr int kLines = 256, kSamples = 500;

struct Bench {
  Probe probe;
  ImagingSettings settings;
  ScenePtr scene;

  explicit Bench(const std::string& name, double depth_mm = 0) : probe(probeNamed(name)) {
    settings = speckleSettings(probe, kLines, kSamples, 3);
    if (depth_mm > 0) settings.depth_mm = depth_mm;
    scene = evenScene(probe, settings, plainTable(), {}, 5);
  }
};

/// Correlation of two frames when the second is taken so many scanlines and samples further on.
double registered(const EnvelopeFrame& a, const EnvelopeFrame& b, int lines, int samples) {
  const Window of{30, kSamples - 30, 30, kLines - 30};
  const Window shifted{of.firstSample + samples, of.endSample + samples, of.firstLine + lines, of.endLine + lines};
  return correlation(valuesIn(a, of), valuesIn(b, shifted));
}

TEST_P(Coherence, LateralAndAxialShiftsMoveTheSameSpeckle) {
  const Bench bench("linear");
  const double pitch_mm = bench.probe.width_mm / kLines, step_mm = bench.settings.depth_mm / kSamples;
  const EnvelopeFrame still = render(bench.probe, bench.settings, bench.scene);
  for (const int lines : {1, 7, 20}) {
    const auto there = render(bench.probe, bench.settings, bench.scene, moved({lines * pitch_mm, 0, 0}));
    const double same = registered(still, there, -lines, 0);
    EXPECT_GT(same, 0.9) << lines << " scanlines sideways";
    record("lateral_" + std::to_string(lines) + "_scanlines", same);
  }
  for (const int samples : {1, 4, 25}) {
    const auto there = render(bench.probe, bench.settings, bench.scene, moved({0, 0, samples * step_mm}));
    const double same = registered(still, there, 0, -samples);
    // 2 mm deeper the slice is another: it closes toward its narrowest place.
    EXPECT_GT(same, samples < 25 ? 0.9 : 0.8) << samples << " samples deeper";
    record("axial_" + std::to_string(samples) + "_samples", same);
  }
}

/// Between the grid's places: half a step before and half a step after must be the same speckle, one step apart. The
/// grid is fine enough that half a step is a small part of the beam and of the pulse.
TEST_P(Coherence, ShiftsOfHalfAStepKeepTheSpeckle) {
  Bench bench("linear");
  bench.settings.scanlines = 2 * kLines, bench.settings.samples = 2 * kSamples;
  const double pitch_mm = bench.probe.width_mm / (2 * kLines), step_mm = bench.settings.depth_mm / (2 * kSamples);
  const EnvelopeFrame still = render(bench.probe, bench.settings, bench.scene);
  const auto sideways = render(bench.probe, bench.settings, bench.scene, moved({0.5 * pitch_mm, 0, 0}));
  const auto deeper = render(bench.probe, bench.settings, bench.scene, moved({0, 0, 0.5 * step_mm}));
  EXPECT_GT(registered(still, sideways, 0, 0), 0.9);
  EXPECT_GT(registered(still, deeper, 0, 0), 0.9);
  record("half_scanline", registered(still, sideways, 0, 0));
  record("half_sample", registered(still, deeper, 0, 0));
}

TEST_P(Coherence, TurningAboutTheApexMovesTheSameSpeckle) {
  for (const char* name : {"curvilinear", "phased"}) {
    const Bench bench(name, 60);
    const double pitch_deg = bench.probe.fovAngle_deg / kLines;
    const EnvelopeFrame still = render(bench.probe, bench.settings, bench.scene);
    for (const int lines : {1, 9}) {
      const Transform pose = turned({0, 1, 0}, lines * pitch_deg, {0, 0, -bench.probe.faceRadius_mm});
      const double same = registered(still, render(bench.probe, bench.settings, bench.scene, pose), -lines, 0);
      EXPECT_GT(same, 0.9) << name << " " << lines << " scanlines";
      record(std::string(name) + "_" + std::to_string(lines) + "_scanlines", same);
    }
  }
}

TEST_P(Coherence, SpeckleChangesAcrossTheSliceAsFastAsTheSliceIsThick) {
  for (const char* name : {"linear", "curvilinear"}) {
    const Bench bench(name, name[0] == 'c' ? 90 : 40);
    const SliceLaw slice = sliceLaw(bench.probe, bench.settings.frequency_MHz);
    const double focus_mm = bench.probe.elevationFocus_mm, thickness_mm = slice.thickness_mm(focus_mm);
    const double step_mm = bench.settings.depth_mm / kSamples;
    const Window atFocus{int(focus_mm / step_mm) - 60, int(focus_mm / step_mm) + 60, 20, kLines - 20};
    const auto still = valuesIn(render(bench.probe, bench.settings, bench.scene), atFocus);
    const auto sharedAt = [&](double y_mm) {
      return correlation(still,
                         valuesIn(render(bench.probe, bench.settings, bench.scene, moved({0, y_mm, 0})), atFocus));
    };
    EXPECT_GT(sharedAt(0.1 * thickness_mm), 0.8) << name;
    EXPECT_LT(sharedAt(2.2 * thickness_mm), 0.2) << name;
    EXPECT_LT(sharedAt(-4 * thickness_mm), 0.2) << name;
    for (const double share : {0.1, 0.25, 0.5, 1.0, 2.2})
      record(std::string(name) + "_at_" + std::to_string(int(100 * share)) + "_percent_of_thickness",
             sharedAt(share * thickness_mm));
  }
}

TEST_P(Coherence, SmallTurnsKeepTheSpeckle) {
  const Bench bench("linear");
  const auto still = valuesIn(render(bench.probe, bench.settings, bench.scene), {0, kSamples, 0, kLines});
  for (const auto& [name, axis] : {std::pair{"tilt", Vec3{1, 0, 0}}, {"rock", {0, 1, 0}}, {"turn", {0, 0, 1}}}) {
    const auto there = render(bench.probe, bench.settings, bench.scene, turned(axis, 0.15, {0, 0, 0}));
    const double same = correlation(still, valuesIn(there, wholeFrame(there)));
    EXPECT_GT(same, 0.8) << name << " by 0.15 degrees: at 40 mm a third of the beam's width";
    record(name, same);
  }
}

/// Everything that an image can hold, on a scene with an outside, a vessel, bone and gas.
struct RichBench {
  Probe probe = probeNamed("linear");
  ImagingSettings settings = settingsFor(probe);
  LabelPhantom phantom;
  AcousticTable table = *loadAcousticTable("neck");

  explicit RichBench(double voxel_mm = 0.7)
      : phantom(paint(gridOver({-42, -28, -14}, {42, 28, 70}, voxel_mm), [](Vec3 p) {
          if (p.z < 0.02 * p.x * p.x) return kBackground;
          if (std::hypot(p.x - 3, p.z - 14) < 5 || std::hypot(p.x - 21, p.z - 25, 0.5 * p.y) < 4) return kVein;
          if (std::hypot(p.x + 10, p.z - 22) < 4) return kAirway;
          return p.z > 30 ? kBone : p.z > 8 ? kMuscle : kFat;
        })) {
    settings.scanlines = 100, settings.samples = 333;
  }
};

TEST_P(Coherence, SamePoseSameImageForAnyNumberOfThreads) {
  const RichBench bench;
  const ScenePtr scene = sceneOf(bench.phantom, bench.table, regionAround(bench.probe, bench.settings));
  const Transform pose = turned({1, 2, 3}, 12);
  const EnvelopeFrame first = render(bench.probe, bench.settings, scene, pose);
  EXPECT_TRUE(identical(first, render(bench.probe, bench.settings, scene, pose)));
  for (const int threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tbb::task_arena arena(threads);
    EnvelopeFrame frame;
    arena.execute([&] { frame = render(bench.probe, bench.settings, scene, pose); });
    EXPECT_TRUE(identical(first, frame)) << threads << " threads";
  }
}

TEST_P(Coherence, ManyMoreThreadsThanCores) {
  const RichBench bench;
  const ScenePtr scene = sceneOf(bench.phantom, bench.table, regionAround(bench.probe, bench.settings));
  const EnvelopeFrame first = render(bench.probe, bench.settings, scene);
  const tbb::global_control more(tbb::global_control::max_allowed_parallelism, 32);
  tbb::task_arena arena(32);
  EnvelopeFrame frame;
  arena.execute([&] { frame = render(bench.probe, bench.settings, scene); });
  EXPECT_TRUE(identical(first, frame));
}

TEST_P(Coherence, OneEngineForManyFramesRemembersNothing) {
  const RichBench bench;
  const ScenePtr scene = sceneOf(bench.phantom, bench.table, regionAround(bench.probe, bench.settings, {}, 3));
  const auto engine = makeEngine(GetParam());
  ASSERT_TRUE(engine);
  EnvelopeFrame first, other, again;
  (*engine)->prepare(bench.probe, bench.settings);
  (*engine)->render(*scene, {}, first);
  (*engine)->render(*scene, moved({2, 1, 0}), other);
  (*engine)->render(*scene, {}, again);
  EXPECT_FALSE(identical(first, other));
  EXPECT_TRUE(identical(first, again));
}

TEST_P(Coherence, TheSceneMayBeAnySizeThatHoldsTheFrame) {
  const Region whole{{-100, -100, -100}, {100, 100, 100}};
  for (const double voxel_mm : {0.7, 1.0, 2.0}) {
    const RichBench bench(voxel_mm);
    const Region tight = regionAround(bench.probe, bench.settings);
    const EnvelopeFrame fitted = render(bench.probe, bench.settings, sceneOf(bench.phantom, bench.table, tight));
    const EnvelopeFrame roomy = render(bench.probe, bench.settings, sceneOf(bench.phantom, bench.table, whole));
    EXPECT_LT(relativeError(fitted, roomy), 1e-3) << voxel_mm << " mm voxels";
    record("relative_error_" + std::to_string(int(10 * voxel_mm)), relativeError(fitted, roomy));
  }
}

}  // namespace
}  // namespace insonate::test
