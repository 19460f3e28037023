#pragma once

#include <insonate/simulator/PictureFiles.h>

#include <map>
#include <string>

namespace insonate::cli {

/// Paths of the files to write for an image. Empty: the file is not wanted.
struct OutputTargets {
  std::string picture, envelope, displacement, layers;
  std::string suffix;  ///< part of the layers' file names

  /// Adds an index to each file's name: F.png becomes F_0007.png.
  OutputTargets numbered(std::size_t index) const;
};

/// Checks before the computation. Fails if a file name's ending is misleading, a folder is missing or not writable, or
/// a file of the case would be overwritten.
Result<void> checkTargets(const OutputTargets& targets, const std::filesystem::path& caseFolder);

/// Writes all images or, on failure or cancellation, none. Creates the folder if it is missing.
Result<void> writePictures(const std::map<std::string, BModeImage>& pictures, const std::filesystem::path& folder);

}  // namespace insonate::cli
