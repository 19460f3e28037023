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
  Transform start;      ///< patientFromProbe at the beginning

  /// Values measured; each setting is varied while the others stay as in `setup`.
  std::vector<int> scanlines, samples, elevationPlanes;
  bool thesisLook = true;                      ///< measure also with the rendering style "thesis"
  int poses = 2;                               ///< number of poses at which the engines are compared
  int denseScanlines = 1024, densePlanes = 9;  ///< sizes of the frame to which rows are compared
  double secondsPerRow = 0.5;
  double secondsForLimits = 0.6;

  bool everyView = true;                     ///< measure realism for all start poses of the first target
  bool penetration = true;                   ///< measure the penetration of all machines
  std::vector<std::string> realismVariants;  ///< built-in necks that are measured in addition to `patient`
};

/// Makes the plan for the built-in textbook neck. Workload W1: 256 scanlines of 1000 samples, 3 planes, to an image of
/// 820 x 616, under the linear probe over the right jugular vein. `quick`: fewer rows, and one image for realism.
Result<UltrasoundBenchPlan> ultrasoundBenchPlan(bool quick, const Progress& progress = {});

struct FrameTimes {
  int frames = 0;
  double median_ms = 0, p95_ms = 0, min_ms = 0;  ///< wall-clock time
  double cpu_ms = 0;                             ///< median processor time of the whole program, summed over threads
};

struct StageTime {
  std::string name;
  double median_ms = 0, min_ms = 0;  ///< times of the engine's stages are summed over threads
};

/// Measurements of one engine with one set of settings and a number of threads.
struct UltrasoundBenchRow {
  std::string engine;
  std::string look;  ///< "coherent" or "thesis"; followed by ", displaced" if tissue is displaced, and ", needle" if
                     ///< there is a needle
  int threads = 1;
  int scanlines = 0, samples = 0, elevationPlanes = 0, width = 0, height = 0;
  /// Distance between the gates at which echoes are summed along a scanline; follows from the samples.
  double gate_mm = 0;
  FrameTimes times;
  std::vector<StageTime> stages;
  /// Difference from the reference engine with the same settings, which shows how well the engine computes the model:
  /// RMS difference of the linear envelope over the envelope's RMS, and mean structural similarity of the displayed
  /// images.
  double envelopeError_percent = 0, ssim = 1;
  /// Difference from a dense frame of the reference engine, which shows how well the row's grid resolves the model.
  /// Both frames are made without speckle, since more planes contain other scatterers; the dense frame is resampled to
  /// the row's beams. NaN for the rendering style "thesis", whose pixels are filtered and have no beam to resolve, and
  /// for displaced tissue and a needle.
  double discretisationError_percent = 0, discretisationSsim = 1;
};

/// One stage of W1 compared with the machine's limits; from the minimum times.
struct StageLimits {
  std::string stage;
  int threads = 1;
  StageTime time;
  double operations = 0, bytes = 0;  ///< work of the model by formula (ultrasound/FrameWork.h); 0 if unknown
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
  std::vector<Limits> limits;  ///< measured in the same run: with one thread, then with all
};

/// One measure of one image, compared with the values of 15 real neck images.
struct RealismRow {
  std::string variant, view, measure, patch;
  PictureBox box;  ///< box of the patch; empty if several patches were used
  double value = 0;
  double low = 0, median = 0, high = 0;
  bool inRange = false;
};

/// Penetration of a machine's image in tissue whose attenuation the built-in TGC compensates: the depth at which echoes
/// are as strong as the noise (IEC 61391-2), measured on displayed images.
struct PenetrationRow {
  std::string machine, probe;
  double frequency_MHz = 0;   ///< the machine's own for this probe; with harmonic imaging, the received frequency
  double expected_mm = 0;     ///< -noise_dB over the attenuation; Szabo and Lewin 2013: 60 cm MHz over the frequency
  double penetration_mm = 0;  ///< without harmonic imaging; 0 if the noise is stronger at all depths
  double harmonic_mm = 0;     ///< with harmonic imaging
  double loss_dB = 0;  ///< echo over noise that harmonic imaging costs; NaN if it never stands clear of the noise
};

/// An image for which realism was measured.
struct BenchPicture {
  std::string name;  ///< name of the image's file, without extension
  BModeImage image;
};

struct UltrasoundBench {
  BenchComputer machine;
  std::vector<UltrasoundBenchRow> rows;  ///< workload W1 first
  FrameTimes plainLoop;                  ///< times of a plain scalar loop of W1 without layers, one thread
  std::vector<StageLimits> stages;
  std::vector<RealismRow> realism;
  std::vector<PenetrationRow> penetration;
  std::vector<BenchPicture> pictures;
  std::vector<std::string> notes;
};

/// Runs the benchmark, which takes minutes on this machine. Fails with a sentence if the setup is invalid, if a pose
/// shows no tissue of the case, or if cancelled.
Result<UltrasoundBench> runUltrasoundBench(const UltrasoundBenchPlan& plan, const Progress& progress = {});

/// Measures the penetration with and without harmonic imaging, with the frequency and noise of these settings. Takes
/// less than a second.
Result<PenetrationRow> measurePenetration(const Probe& probe, const ImagingSettings& settings);
/// Measures the penetration of all machines() with all probe presets.
Result<std::vector<PenetrationRow>> penetrationRows(const Progress& progress = {});

/// Returns rows, stages, realism, penetration, machine, plain_loop and notes as JSON. Values that are not finite are
/// null.
nlohmann::json toJson(const UltrasoundBench& bench);

/// Checks that a folder can be created and written. Call it before any work.
Result<void> checkBenchFolder(const std::filesystem::path& folder);

/// Writes ultrasound.json, ultrasound.csv, stages.csv, realism.csv, penetration.csv, plots as SVG, images as PNG and
/// index.md; either all of them or none.
Result<void> writeUltrasoundBench(const UltrasoundBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
