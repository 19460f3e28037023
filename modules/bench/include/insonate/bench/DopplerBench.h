#pragma once

#include <insonate/bench/UltrasoundBench.h>

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate {

/// One measurement of color Doppler whose answer is known.
struct DopplerBenchRow {
  std::string engine, measure, condition, unit;
  double expected = 0, measured = 0;
  double error_percent = 0;  ///< difference relative to `expected`, or to the Nyquist velocity for aliasing
  double limit_percent = 0;  ///< largest permitted error; 0: none was set
};

/// Times of the frames of workload W1 with and without color, measured in turn in the same run.
struct ColorCost {
  std::string engine, device;  ///< device: graphics card, or "the processor"
  int threads = 1;             ///< threads of the processor
  double plain_ms = 0, colored_ms = 0,
         color_ms = 0;  ///< median times: frames without and with color; the stage `color`
  double plainMin_ms = 0, coloredMin_ms = 0, colorMin_ms = 0;  ///< minimum times
};

/// Median times of PW Doppler on one thread, in the gate of the default settings over the right jugular vein.
struct SpectralCost {
  double hold_ms = 0;       ///< once for each image: the tissue and the vessels in the gate
  double spectrum_ms = 0;   ///< each spectrum
  double sound_ms = 0;      ///< sound of each spectrum
  double perSecond_ms = 0;  ///< computing time for one second: 30 images and 200 spectra with sound
};

struct DopplerBench {
  std::vector<DopplerBenchRow> rows;
  std::vector<ColorCost> costs;
  SpectralCost spectral;
  std::vector<std::string> notes;
};

/// Runs the benchmark of Doppler: velocity at known angles, aliasing, area of color by gain, conservation of flow
/// in the built-in neck, and the cost of color and spectra on workload W1. `quick`: fewer frames. Fails if cancelled.
Result<DopplerBench> runDopplerBench(bool quick, const Progress& progress = {});

nlohmann::json toJson(const DopplerBench& bench);

/// Writes doppler.json, doppler.csv, cost.csv, spectral.csv and doppler.md; either all of them or none.
Result<void> writeDopplerBench(const DopplerBench& bench, const std::filesystem::path& folder);

}  // namespace insonate
