#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/TissueMechanics.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace insonate::cli {

/// Command-line options for compression by the probe and the patient's blood pressure.
struct PressOptions {
  std::optional<double> force_N, indent_mm, cvp_mmHg, trendelenburg_deg, map_mmHg, time_s, footprint_mm;
  std::string deformation, mechanics, pressure;
  bool sticking = false, pneumothorax = false;

  void addTo(CLI::App& command);
};

/// Compression and blood pressure as given by the command line, checked.
struct PressPlan {
  TissueMechanics mechanics;
  Physiology physiology;
  std::optional<double> force_N, indent_mm;
  /// time in the cycles of heartbeat and breathing; empty: blood is at its mean pressure
  std::optional<double> time_s;

  bool moves() const { return force_N || indent_mm; }
};

/// Checks the options. Without a named deformation model, `elastic` is used if an option or `displacementRequested` (a
/// displacement is to be written) needs one; else tissue does not deform.
Result<PressPlan> readPress(const PressOptions& options, bool displacementRequested);

}  // namespace insonate::cli
