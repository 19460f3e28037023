#pragma once

#include "Presser.h"

#include <insonate/ultrasound/ColorSettings.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <string>

namespace insonate::cli {

/// Options for M-mode: one scanline of the image over time.
struct MModeOptions {
  double line = 0.5;   ///< scanline, as a fraction of the field of view from its left edge
  double seconds = 4;  ///< duration

  void addTo(CLI::App& command, std::string& file);
};

/// Renders M-mode at a pose and writes it as a PNG, with a column for each 20 ms from `start_s` on, in the cycles of
/// heartbeat and breathing. Persistence and color of the setup are not used. Leaves the tissue of `presser` in its last
/// state. Fails if Ctrl-C or SIGTERM has stopped the command.
Result<void> writeMMode(const MModeOptions& options, const ImagingSetup& setup, const AcousticScene& scene,
                        Presser& presser, double start_s, std::uint32_t noiseSeed, const std::string& file);

}  // namespace insonate::cli
