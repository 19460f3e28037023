#pragma once

#include <insonate/bench/ImageMeasures.h>
#include <insonate/core/Progress.h>
#include <insonate/simulator/Imager.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// Plan of the ultrasound benchmark. All measurements use one case and a probe that moves from `start`.
struct UltrasoundBenchPlan {
  PatientCase patient;
  std::string variant;  ///< name of the case in the tables
  /// setup that is measured first (workload W1); ImagingSetup::engine is ignored
  ImagingSetup setup;
  Transform start;  ///< patientFromProbe at the beginning of the motion

  /// Numbers of scanlines, samples and elevation planes to measure. One of the three is varied at a time; the others
  /// are those of `setup`.
  std::vector<int> scanlines, samples, elevationPlanes;
  bool thesisLook = true;  ///< true: the rendering style "thesis" is measured, too
  int poses = 2;           ///< number of poses at which the engines are compared
  /// numbers of scanlines and planes of the dense frame with which other frames are compared
  int denseScanlines = 1024, densePlanes = 9;
  double secondsPerRow = 0.5;
  double secondsForLimits = 0.6;

  bool everyView = true;                     ///< true: realism is measured for all start poses of the first target
  bool penetration = true;                   ///< true: the penetration of all machines is measured
  std::vector<std::string> realismVariants;  ///< built-in necks that are measured in addition to `patient`
};

/// Makes the plan for the built-in textbook neck. Main workload W1: 256 scanlines of 1000 samples in 3 planes, an image
/// of 820 x 616, the linear probe over the right jugular vein. `quick`: fewer measurements, and one image for realism.
Result<UltrasoundBenchPlan> ultrasoundBenchPlan(bool quick, const Progress& progress = {});

struct FrameTimes {
  int frames = 0;
  double median_ms = 0, p95_ms = 0, min_ms = 0;  ///< wall-clock time per frame: median, 95th percentile, minimum
  double cpu_ms = 0;  ///< median processor time per frame, summed over all threads of the program
};

struct StageTime {
  std::string name;
  double median_ms = 0, min_ms = 0;  ///< computing time; of the engine cpu, the sum over threads
};

/// Measurements of one engine with one set of settings and a number of threads.
struct UltrasoundBenchRow {
  std::string engine;
  /// Rendering style, "coherent" or "thesis"; followed by ", displaced" if tissue is displaced, and by ", needle" if
  /// there is a needle.
  std::string look;
  int threads = 1;
  int scanlines = 0, samples = 0, elevationPlanes = 0, width = 0, height = 0;
  /// Distance along a scanline between the depths at which echoes are computed; follows from the number of samples.
  double gate_mm = 0;
  FrameTimes times;
  std::vector<StageTime> stages;
  /// Difference from the engine `reference` with the same settings, which measures how exactly the engine computes the
  /// model: RMS difference of the linear envelope relative to the RMS of the envelope, and mean structural similarity
  /// of the B-mode images.
  double envelopeError_percent = 0, ssim = 1;
  /// Difference from a dense frame, i.e. a frame of the engine `reference` with many more scanlines and planes. It
  /// measures how well this number of scanlines, samples and planes resolves the model. Both frames are rendered
  /// without speckle, since different planes contain different scatterers; the dense frame is resampled to the beams of
  /// this row. NaN for the rendering style "thesis", displaced tissue and a needle.
  double discretisationError_percent = 0, discretisationSsim = 1;
};

/// Speed of one stage of workload W1, computed from the minimum time of the stage and compared with the limits of the
/// computer. For stages on a graphics card only times are known.
struct StageLimits {
  std::string engine, stage;
  int threads = 1;
  StageTime time;
  /// operations and bytes of the stage by formula (ultrasound/FrameCost.h); 0: unknown
  double operations = 0, bytes = 0;
  double giga_operationsPerSecond = 0, gigabytesPerSecond = 0;
  double percentOfArithmetic = 0, percentOfCache = 0, percentOfMemory = 0;
};

struct BenchComputer {
  std::string processor, vectors;  ///< name of the processor, and widest vector instruction set used
  int cores = 1;
  struct Limits {
    int threads = 1;
    double multiplyAdd_GFLOPs = 0, cache_GBps = 0, memory_GBps = 0;
  };
  std::vector<Limits> limits;  ///< limits measured in the same run, first with one thread, then with all threads
};

/// One measured property of a simulated image, compared with its values in 15 real neck images.
struct RealismRow {
  std::string variant, view, measure, patch;
  PixelBox box;  ///< part of the image that was measured; empty if several parts were used
  double value = 0;
  double low = 0, median = 0, high = 0;
  bool inRange = false;
};

/// Penetration of a machine's image in tissue whose attenuation the built-in TGC compensates: the depth at which echoes
/// are as strong as the noise (IEC 61391-2), measured on displayed images.
struct PenetrationRow {
  std::string machine, probe;
  /// frequency of the machine for this probe; with harmonic imaging, the received frequency
  double frequency_MHz = 0;
  /// -noise_dB divided by the attenuation (for comparison, Szabo and Lewin 2013: 60 cm MHz divided by the frequency)
  double expected_mm = 0;
  /// penetration without harmonic imaging; 0 if the noise is stronger than the echoes at all depths
  double penetration_mm = 0;
  double harmonic_mm = 0;  ///< penetration with harmonic imaging
  /// reduction of the echo-to-noise ratio by harmonic imaging; NaN if the echoes never exceed the noise
  double loss_dB = 0;
};

/// An image for which realism was measured.
struct BenchImage {
  std::string name;  ///< file name of the image, without extension
  BModeImage image;
};

struct UltrasoundBench {
  BenchComputer machine;
  /// measurements of engines and settings; the measurements of UltrasoundBenchPlan::setup come first
  std::vector<UltrasoundBenchRow> rows;
  FrameTimes plainLoop;  ///< times of a simple scalar program (PlainLoop) with UltrasoundBenchPlan::setup, one thread
  std::vector<StageLimits> stages;
  std::vector<RealismRow> realism;
  std::vector<PenetrationRow> penetration;
  std::vector<BenchImage> pictures;
  std::vector<std::string> notes;
};

/// Runs the ultrasound benchmark, which takes minutes. Fails with a sentence if the setup is invalid, if a pose shows
/// no tissue of the case, or if cancelled.
Result<UltrasoundBench> runUltrasoundBench(const UltrasoundBenchPlan& plan, const Progress& progress = {});

/// Measures the penetration with and without harmonic imaging, with the frequency and noise of these settings. Takes
/// less than a second.
Result<PenetrationRow> measurePenetration(const Probe& probe, const ImagingSettings& settings);
/// Measures the penetration of all machines() with all probe presets.
Result<std::vector<PenetrationRow>> penetrationRows(const Progress& progress = {});

/// Returns rows, stages, realism, penetration, machine, plain_loop and notes as JSON. Values that are not finite are
/// null.
nlohmann::json toJson(const UltrasoundBench& bench);

/// Checks that the folder for the results can be created and written, before a benchmark starts.
Result<void> checkBenchFolder(const std::filesystem::path& folder);

/// Writes ultrasound.json, ultrasound.csv, stages.csv, realism.csv, penetration.csv, plots as SVG, images as PNG and
/// index.md; either all of them or none.
Result<void> writeUltrasoundBench(const UltrasoundBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
