#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace insonate::cli {

/// Command-line options for an attempt's images.
struct AttemptPictureOptions {
  std::string folder;
  double every_s = 1;

  void addTo(CLI::App& command);
  bool wanted() const { return !folder.empty(); }
  std::int64_t every_us() const;  ///< a multiple of 1000
};

using TakeFrame = std::function<Result<void>(const LiveFrame&)>;

/// Writes each image that `make` passes on as a PNG named by its time in milliseconds, and pictures.json, which lists
/// time, force, indentation and envelope fingerprint of every image. The folder must be new or empty. Either all files
/// are written, or none. Returns the list.
Result<nlohmann::json> writeAttemptPictures(const AttemptPictureOptions& options,
                                            const std::function<Result<void>(const TakeFrame&)>& make);

}  // namespace insonate::cli
