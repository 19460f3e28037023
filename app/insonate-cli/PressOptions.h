#pragma once

#include <insonate/deformation/Physiology.h>
#include <insonate/simulator/TissueMechanics.h>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace insonate::cli {

/// Options of the command line about the probe's pressure and the patient's blood.
struct PressOptions {
  std::optional<double> force_N, indent_mm, cvp_mmHg, trendelenburg_deg, map_mmHg, time_s, footprint_mm;
  std::string deformation, mechanics, pressure;
  bool sticking = false;

  void addTo(CLI::App& command);
};

/// The same, read and checked.
struct PressPlan {
  TissueMechanics mechanics;
  Physiology physiology;
  std::optional<double> force_N, indent_mm;
  std::optional<double> time_s;  ///< without one, blood is at its mean pressure

  bool moves() const { return force_N || indent_mm; }
};

/// Without a model by name, tissue gives way (by `elastic`) only where an option would have no effect otherwise.
Result<PressPlan> readPress(const PressOptions& options, bool displacementWanted);

}  // namespace insonate::cli
