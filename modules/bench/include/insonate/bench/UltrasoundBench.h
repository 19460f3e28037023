#pragma once

#include <insonate/bench/PictureMeasures.h>
#include <insonate/core/Progress.h>
#include <insonate/simulator/Imager.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Plan of the measurements. All of them use one case and a probe that moves from `start`.
struct UltrasoundBenchPlan {
  PatientCase patient;
  std::string variant;  ///< name of the case in the tables
  ImagingSetup setup;   ///< workload W1; its engine is ignored
  Transform start;      ///< patientFromProbe

  std::vector<int> scanlines, samples, elevationPlanes;  ///< each varied around the setup's own
  bool thesisLook = true;                                ///< one more set of rows with the look "thesis"
  int poses = 2;                                         ///< at which the engines are compared
  int denseScanlines = 1024, densePlanes = 9;            ///< of the frame that rows are measured against
  double secondsPerRow = 0.5;
  double secondsForLimits = 0.6;

  bool everyView = true;                     ///< measure realism of all start poses over the first target
  std::vector<std::string> realismVariants;  ///< built-in necks measured besides `patient`
};

/// The built-in textbook neck with workload W1: 256 scanlines of 1000 samples, 3 planes, to 820 x 616, under the linear
/// probe over the right jugular vein. Quick: fewer rows, one image for realism.
Result<UltrasoundBenchPlan> ultrasoundBenchPlan(bool quick, const Progress& progress = {});

struct FrameTimes {
  int frames = 0;
  double median_ms = 0, p95_ms = 0, min_ms = 0;  ///< on the clock
  double cpu_ms = 0;                             ///< median processor time of the whole program, all threads together
};

struct StageTime {
  std::string name;
  double median_ms = 0, min_ms = 0;  ///< of the engine: summed over threads
};

/// One engine with one set of settings and threads.
struct UltrasoundBenchRow {
  std::string engine;
  std::string look;  ///< "coherent" or "thesis", and ", displaced" where the tissue is, ", needle" where there is one
  int threads = 1;
  int scanlines = 0, samples = 0, elevationPlanes = 0, width = 0, height = 0;
  double gate_mm = 0;  ///< distance at which echoes are summed along a scanline; follows from the samples
  FrameTimes times;
  std::vector<StageTime> stages;
  /// Against the reference engine with the same settings: RMS difference of the linear envelope over its RMS, and mean
  /// structural similarity of the displayed pictures. How well the engine computes the model.
  double envelopeError_percent = 0, ssim = 1;
  /// Against a dense frame of the reference engine, speckle left out on both sides, resampled to the row's beams. How
  /// well the row's grid resolves the model. Speckle must be left out: more planes hold other scatterers.
  /// NaN for the look "thesis", whose pixels are filtered and have no beam to resolve, and for displaced tissue and a
  /// needle.
  double discretisationError_percent = 0, discretisationSsim = 1;
};

/// One stage of W1 against what the machine can do at best; from the least times seen.
struct StageLimits {
  std::string stage;
  int threads = 1;
  StageTime time;
  double operations = 0, bytes = 0;  ///< of the model, by formula (ultrasound/FrameWork.h); 0 where not known
  double giga_operationsPerSecond = 0, gigabytesPerSecond = 0;
  double percentOfArithmetic = 0, percentOfCache = 0, percentOfMemory = 0;
};

struct BenchComputer {
  std::string processor, vectors;  ///< widest instruction set used
  int cores = 1;
  struct Limits {
    int threads = 1;
    double multiplyAdd_GFLOPs = 0, cache_GBps = 0, memory_GBps = 0;
  };
  std::vector<Limits> limits;  ///< measured in the same run: one thread, then all
};

/// One measure of one image beside what 15 real neck images gave.
struct RealismRow {
  std::string variant, view, measure, patch;
  PictureBox box;  ///< where the patch lies; empty where several were used
  double value = 0;
  double low = 0, median = 0, high = 0;
  bool inRange = false;
};

/// An image that realism was measured on.
struct BenchPicture {
  std::string name;  ///< of its file, without extension
  BModeImage image;
};

struct UltrasoundBench {
  BenchComputer machine;
  std::vector<UltrasoundBenchRow> rows;  ///< workload W1 first
  FrameTimes plainLoop;                  ///< a plain scalar loop of W1 without layers, one thread
  std::vector<StageLimits> stages;
  std::vector<RealismRow> realism;
  std::vector<BenchPicture> pictures;
  std::vector<std::string> notes;
};

/// Minutes of work on the calling thread's machine. Fails with a sentence where the setup is refused or the pose sees
/// nothing of the case, and when cancelled.
Result<UltrasoundBench> runUltrasoundBench(const UltrasoundBenchPlan& plan, const Progress& progress = {});

/// rows, stages, realism, machine, plain_loop and notes. Values that are not finite are null.
nlohmann::json toJson(const UltrasoundBench& bench);

/// Refuses, before any work, a folder that cannot be made or written.
Result<void> checkBenchFolder(const std::filesystem::path& folder);

/// ultrasound.json, ultrasound.csv, stages.csv, realism.csv, plots as SVG, images as PNG and index.md; all of them or
/// none.
Result<void> writeUltrasoundBench(const UltrasoundBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
