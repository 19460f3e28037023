#pragma once

#include <insonate/simulator/ImageFiles.h>

#include <map>
#include <string>

namespace insonate::cli {

/// Paths of the files that `render` writes for an image; an empty path: the file is not written.
struct OutputTargets {
  std::string picture, envelope, displacement, layers, mMode;
  std::string suffix;  ///< text added to the file names of the effect layers

  /// Returns the targets with an index added to each file's name: F.png becomes F_0007.png.
  OutputTargets numbered(std::size_t index) const;
};

/// Checks the paths before the computation. Fails if a file name's ending does not fit its format, a folder is missing
/// or not writable, or a file of the case would be overwritten.
Result<void> checkTargets(const OutputTargets& targets, const std::filesystem::path& caseFolder);

/// Writes images by file name as PNG: all or, on failure or cancellation, none. Creates the folder if it is missing.
Result<void> writePictures(const std::map<std::string, BModeImage>& pictures, const std::filesystem::path& folder);

}  // namespace insonate::cli
