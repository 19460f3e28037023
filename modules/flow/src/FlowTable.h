#pragma once

#include <complex>
#include <string>
#include <vector>

namespace insonate {

/// Volume flow over a heartbeat, relative to its mean, as a Fourier series.
struct Waveform {
  static constexpr int kHarmonics = 14;
  std::string name;
  /// Complex amplitudes c of the harmonics 1 to kHarmonics: flow = 1 + sum of Re(c exp(2 pi i n phase)).
  std::vector<std::complex<double>> harmonic;
  /// Sign of the change of a vein's flow by breathing: 1 for more flow during inspiration, -1 below the diaphragm,
  /// where inspiration raises the pressure in the abdomen.
  double breathing = 1;
};

/// Contents of resources/flow/adult.json.
struct FlowTable {
  struct Entry {
    std::string vessel;
    double flow_mm3ps = 0;
    int waveform = 0;
  };
  std::vector<Entry> vessels;
  std::vector<Waveform> waveforms;
  double arteryShear_perS = 0, veinShear_perS = 0;
  int arteryWaveform = 0, veinWaveform = 0;
  double breathing_permmHg = 0;
};

/// The table comes with the program; a test reads it.
const FlowTable& adultFlowTable();

}  // namespace insonate
