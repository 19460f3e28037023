#pragma once

#include <insonate/simulator/LiveImaging.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace insonate::cli {

/// Options of the command line about an attempt's images.
struct AttemptPictureOptions {
  std::string folder;
  double every_s = 1;

  void addTo(CLI::App& command);
  bool wanted() const { return !folder.empty(); }
  std::int64_t every_us() const;  ///< a multiple of 1000
};

using TakeFrame = std::function<Result<void>(const LiveFrame&)>;

/// Writes what `make` hands over: a PNG each, named by its time in milliseconds, and pictures.json, which tells of each
/// image time, force, indentation and a fingerprint of its envelope. The folder is new or empty; it is there with all
/// of them, or not at all. Returns the list.
Result<nlohmann::json> writeAttemptPictures(const AttemptPictureOptions& options,
                                            const std::function<Result<void>(const TakeFrame&)>& make);

}  // namespace insonate::cli
