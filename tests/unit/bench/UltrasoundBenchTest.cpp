#include "support/SmallCase.h"
#include "support/TestData.h"

#include <insonate/bench/UltrasoundBench.h>
#include <insonate/simulator/ProbePose.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

namespace insonate {
namespace {

using testing::HasSubstr;

UltrasoundBenchPlan smallPlan() {
  UltrasoundBenchPlan plan;
  plan.patient = test::smallCase();
  auto& labels = plan.patient.labels.voxels;
  std::replace(labels.begin(), labels.end(), std::uint8_t{kSoftTissue}, std::uint8_t{kThyroid});  // an even tissue
  plan.variant = "block";
  plan.setup = {*loadProbe("linear"), {}, *loadAcousticTable("neck"), "cpu"};
  plan.setup.settings = settingsFor(plan.setup.probe);
  ImagingSettings& settings = plan.setup.settings;
  settings.depth_mm = 30, settings.scanlines = 48, settings.samples = 250;
  settings.width = 200, settings.height = 160;
  plan.start = *patientFromProbe({0, 0, 0}, {0, 1, 0}, {1, 0, 0});
  plan.scanlines = {24, 48}, plan.samples = {200}, plan.elevationPlanes = {1};
  plan.poses = 1, plan.denseScanlines = 96, plan.densePlanes = 5;
  plan.secondsPerRow = plan.secondsForLimits = 0;
  plan.penetration = false;
  return plan;
}

const UltrasoundBench& smallBench() {
  static const Result<UltrasoundBench> bench = runUltrasoundBench(smallPlan());
  if (!bench) throw std::runtime_error(bench.error().message);
  return *bench;
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

TEST(UltrasoundBench, HasARowForEveryEngineAndSize) {
  const UltrasoundBench& bench = smallBench();
  std::set<std::tuple<std::string, int, int, int>> kinds;
  for (const UltrasoundBenchRow& row : bench.rows)
    if (row.look == "coherent") kinds.insert({row.engine, row.scanlines, row.samples, row.elevationPlanes});
  std::size_t engines = 0;
  for (const std::string& engine : engineNames()) {
    if (!makeEngine(engine)) continue;
    ++engines;
    EXPECT_TRUE(kinds.contains({engine, 48, 250, 3})) << engine;
    EXPECT_TRUE(kinds.contains({engine, 24, 250, 3})) << engine;
    EXPECT_TRUE(kinds.contains({engine, 48, 200, 3})) << engine;
    EXPECT_TRUE(kinds.contains({engine, 48, 250, 1})) << engine;
  }
  EXPECT_EQ(kinds.size(), 4 * engines);
  EXPECT_EQ(bench.rows.front().scanlines, 48) << "the workload comes first";
  EXPECT_EQ(bench.rows.back().look, "thesis");
}

TEST(UltrasoundBench, TimesAndErrorsMakeSense) {
  for (const UltrasoundBenchRow& row : smallBench().rows) {
    EXPECT_GT(row.times.frames, 0);
    EXPECT_GT(row.times.min_ms, 0);
    EXPECT_LE(row.times.min_ms, row.times.median_ms);
    EXPECT_LE(row.times.median_ms, row.times.p95_ms);
    EXPECT_FALSE(row.stages.empty());
    const bool reference = row.engine == "reference";
    EXPECT_LT(row.envelopeError_percent, reference ? 1e-9 : 0.5);
    EXPECT_GT(row.ssim, 0.99);
    EXPECT_GT(row.gate_mm, 0);
    if (row.look != "coherent") continue;
    EXPECT_GT(row.discretisationError_percent, 0);
    EXPECT_LT(row.discretisationError_percent, 60);
    EXPECT_GT(row.discretisationSsim, 0.5);
    EXPECT_LT(row.discretisationSsim, 1);
  }
}

TEST(UltrasoundBench, DisplacedTissueAndANeedleAreMeasuredBesideTheWorkload) {
  for (const char* what : {"coherent, displaced", "coherent, needle"}) {
    int rows = 0;
    for (const UltrasoundBenchRow& row : smallBench().rows)
      if (row.look == what) {
        ++rows;
        EXPECT_EQ(row.scanlines, smallBench().rows.front().scanlines);
        EXPECT_TRUE(std::isnan(row.discretisationError_percent));
      }
    EXPECT_GE(rows, 2) << "each engine: " << what;
  }
}

TEST(UltrasoundBench, FewerScanlinesResolveLess) {
  const auto errorOf = [](int scanlines) -> double {
    for (const UltrasoundBenchRow& row : smallBench().rows)
      if (row.engine == "reference" && row.scanlines == scanlines && row.samples == 250 && row.elevationPlanes == 3)
        return row.discretisationError_percent;
    return NAN;
  };
  EXPECT_GT(errorOf(24), errorOf(48));
}

TEST(UltrasoundBench, MachineAndStagesAreFinite) {
  const UltrasoundBench& bench = smallBench();
  ASSERT_FALSE(bench.machine.limits.empty());
  EXPECT_EQ(bench.machine.limits.front().threads, 1);
  for (const BenchComputer::Limits& l : bench.machine.limits) {
    EXPECT_GT(l.multiplyAdd_GFLOPs, 0);
    EXPECT_TRUE(std::isfinite(l.multiplyAdd_GFLOPs));
    EXPECT_GT(l.cache_GBps, 0);
    EXPECT_TRUE(std::isfinite(l.cache_GBps));
    EXPECT_GT(l.memory_GBps, 0);
    EXPECT_TRUE(std::isfinite(l.memory_GBps));
  }
  EXPECT_GT(bench.plainLoop.median_ms, 0);
  ASSERT_FALSE(bench.stages.empty());
  int known = 0;
  for (const StageLimits& stage : bench.stages) {
    EXPECT_TRUE(std::isfinite(stage.percentOfArithmetic)) << stage.stage;
    EXPECT_GE(stage.percentOfArithmetic, 0);
    known += stage.operations > 0;
  }
  EXPECT_GE(known, 8) << "stages have lost their names";
}

TEST(UltrasoundBench, RealismFindsTheVeinAndTheBone) {
  std::set<std::string> measures;
  for (const RealismRow& row : smallBench().realism) {
    EXPECT_EQ(row.variant, "block");
    EXPECT_EQ(row.view, "over the vein");
    EXPECT_TRUE(std::isfinite(row.value)) << row.measure;
    EXPECT_EQ(row.inRange, row.value >= row.low && row.value <= row.high);
    EXPECT_TRUE(measures.insert(row.measure).second) << row.measure;
    if (row.measure == "lumen over surroundings") {
      EXPECT_LT(row.value, 0.5);
      EXPECT_EQ(row.patch, "1 vessel");
    }
    if (row.measure == "line over tissue above") {
      EXPECT_GT(row.value, 1.5);
    }
  }
  EXPECT_TRUE(measures.contains("grey mean"));
  EXPECT_TRUE(measures.contains("lumen mean"));
  EXPECT_TRUE(measures.contains("grain lateral FWHM, mm"));
  EXPECT_TRUE(measures.contains("bone or pleura line grey"));
  EXPECT_FALSE(measures.contains("muscle mean")) << "there is no sternocleidomastoid";
}

TEST(UltrasoundBench, JsonHasTheNamesThatScriptsRelyOn) {
  const nlohmann::json object = toJson(smallBench());
  ASSERT_FALSE(object.at("rows").empty());
  for (const nlohmann::json& row : object["rows"])
    for (const char* name : {"engine", "threads", "scanlines", "samples", "elevation_planes", "width", "height", "look",
                             "median_ms", "p95_ms", "envelope_error_percent", "ssim"})
      EXPECT_TRUE(row.contains(name) && !row[name].is_null()) << name;
  EXPECT_EQ(object["rows"][0]["look"], "coherent");
  EXPECT_FALSE(object.at("realism").empty());
  EXPECT_FALSE(object.at("stages").empty());
  EXPECT_TRUE(object.at("machine").contains("processor"));
}

TEST(UltrasoundBench, WritesTablesAndPlots) {
  const test::TemporaryFolder folder;
  const auto target = folder / "bench";
  const auto written = writeUltrasoundBench(smallBench(), target);
  ASSERT_TRUE(written) << written.error().message;
  for (const char* name : {"stages.svg", "time-agreement.svg", "time-error.svg", "time-planes.svg", "time-samples.svg",
                           "time-scanlines.svg"})
    EXPECT_THAT(contentOf(target / name), testing::EndsWith("</svg>\n")) << name;
  EXPECT_EQ(nlohmann::json::parse(contentOf(target / "ultrasound.json")), toJson(smallBench()));
  const std::string rows = contentOf(target / "ultrasound.csv");
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), std::ptrdiff_t(smallBench().rows.size() + 1));
  const std::string realism = contentOf(target / "realism.csv");
  EXPECT_EQ(std::count(realism.begin(), realism.end(), '\n'), std::ptrdiff_t(smallBench().realism.size() + 1));
  EXPECT_FALSE(contentOf(target / "stages.csv").empty());
  EXPECT_THAT(contentOf(target / "block-over-the-vein.png"), testing::StartsWith("\x89PNG"));
  EXPECT_THAT(contentOf(target / "index.md"), HasSubstr("time-error.svg"));
  EXPECT_TRUE(writeUltrasoundBench(smallBench(), target)) << "a second run replaces the first";
}

TEST(UltrasoundBench, RefusesFoldersThatCannotBe) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "file") << "text";
  const auto aFile = checkBenchFolder(folder / "file");
  ASSERT_FALSE(aFile);
  EXPECT_THAT(aFile.error().message, HasSubstr("is a file"));
  const auto noParent = writeUltrasoundBench(smallBench(), folder.path() / "none" / "bench");
  ASSERT_FALSE(noParent);
  EXPECT_THAT(noParent.error().message, HasSubstr("does not exist"));
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

TEST(UltrasoundBench, RefusesWhatCannotBeRendered) {
  UltrasoundBenchPlan plan = smallPlan();
  plan.setup.settings.depth_mm = -1;
  EXPECT_FALSE(runUltrasoundBench(plan));
  plan = smallPlan();
  plan.start.offset = {5000, 0, 0};
  EXPECT_FALSE(runUltrasoundBench(plan));
  const auto cancelled = runUltrasoundBench(smallPlan(), [](std::string_view, double) { return false; });
  ASSERT_FALSE(cancelled);
  EXPECT_EQ(cancelled.error().message, kCancelled);
}

/// Echoes fall by 0.73 dB/cm/MHz beside a constant noise: both depths follow from the noise alone.
TEST(Penetration, HarmonicImagingLosesTwelveDecibels) {
  const double kHarmonicLoss_dB = 12;
  for (const char* name : {"linear", "curvilinear", "phased"}) {
    const Probe probe = *loadProbe(name);
    const ImagingSettings settings = settingsFor(probe);
    const auto row = measurePenetration(probe, settings);
    ASSERT_TRUE(row) << row.error().message;
    const double slope_dBpmm = kTgc_dBpcmMHz * settings.frequency_MHz / 10;
    EXPECT_NEAR(row->expected_mm, 44 / slope_dBpmm, 0.1) << name;
    EXPECT_NEAR(row->penetration_mm, row->expected_mm, 1.5 / slope_dBpmm) << name;
    EXPECT_NEAR(row->penetration_mm - row->harmonic_mm, kHarmonicLoss_dB / slope_dBpmm, 2 / slope_dBpmm) << name;
    EXPECT_NEAR(row->loss_dB, kHarmonicLoss_dB, 0.7) << name;
  }
}

TEST(Penetration, LouderNoiseComesNearer) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.noise_dB = -34;
  const auto row = measurePenetration(probe, settings);
  ASSERT_TRUE(row) << row.error().message;
  EXPECT_NEAR(row->penetration_mm, 34 / (kTgc_dBpcmMHz * settings.frequency_MHz / 10), 3);
}

}  // namespace
}  // namespace insonate
