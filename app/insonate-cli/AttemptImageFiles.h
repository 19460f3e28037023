#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace insonate::cli {

/// Command-line options for writing the ultrasound images of an attempt to files.
struct AttemptImageOptions {
  std::string folder;
  double every_s = 1;

  void addTo(CLI::App& command);
  bool wanted() const { return !folder.empty(); }
  std::int64_t every_us() const;  ///< interval between images, a multiple of 1000
};

using TakeFrame = std::function<Result<void>(const LiveFrame&)>;

/// Writes the images of an attempt as PNG files named by their time in milliseconds, and pictures.json, which lists
/// time, force, indentation and envelope fingerprint of every image; returns the list. `make` makes the images and
/// passes each to its argument. The folder must be new or empty. Either all files are written, or none.
Result<nlohmann::json> writeAttemptPictures(const AttemptImageOptions& options,
                                            const std::function<Result<void>(const TakeFrame&)>& make);

}  // namespace insonate::cli
