#pragma once

#include <insonate/simulator/PictureFiles.h>

#include <map>
#include <string>

namespace insonate::cli {

/// Files for an image and its companions; empty: not wanted.
struct OutputTargets {
  std::string picture, envelope, displacement, layers;
  std::string suffix;  ///< of the layers' file names

  /// F.png becomes F_0007.png.
  OutputTargets numbered(std::size_t index) const;
};

/// Refuses, before any work, endings that mislead and folders that are missing or cannot be written.
/// Refuses also to write over a file of the case.
Result<void> checkTargets(const OutputTargets& targets, const std::filesystem::path& caseFolder);

/// All of them or none, also when cancelled; the folder is created when missing.
Result<void> writePictures(const std::map<std::string, BModeImage>& pictures, const std::filesystem::path& folder);

}  // namespace insonate::cli
