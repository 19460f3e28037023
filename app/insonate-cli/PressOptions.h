#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/TissueMechanics.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace insonate::cli {

/// Command-line options for the probe's pressure and the patient's blood pressure.
struct PressOptions {
  std::optional<double> force_N, indent_mm, cvp_mmHg, trendelenburg_deg, map_mmHg, time_s, footprint_mm;
  std::string deformation, mechanics, pressure;
  bool sticking = false;

  void addTo(CLI::App& command);
};

/// The checked values of PressOptions.
struct PressPlan {
  TissueMechanics mechanics;
  Physiology physiology;
  std::optional<double> force_N, indent_mm;
  std::optional<double> time_s;  ///< without a value, blood is at its mean pressure

  bool moves() const { return force_N || indent_mm; }
};

/// Checks the options. If no deformation model is named, `elastic` is used if an option or `displacementWanted` needs a
/// model; else tissue does not deform.
Result<PressPlan> readPress(const PressOptions& options, bool displacementWanted);

}  // namespace insonate::cli
