#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/simulator/LiveImaging.h>
#include <insonate/views/Caliper.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace insonate::train {

/// Formats in which a clip is saved.
enum class ClipFormat { Video, Dicom, Images };

/// Returns the format that belongs to the ending of a file: .webm, .dcm, else a folder of images.
ClipFormat clipFormatOf(const std::filesystem::path& target);

/// The images of a clip, oldest first and at least one, and the measurements on each image.
struct SavedClip {
  std::vector<std::shared_ptr<const LiveFrame>> frames{};
  std::vector<views::Caliper> calipers{};
  std::shared_ptr<const PatientCase> patient{};
  std::string seed{};  ///< text that no other clip of this case has
};

/// Writes a clip to a file (.webm or .dcm) or a new folder, and returns the number of images. A video shows the images
/// of scaledPicture(). A DICOM clip contains the images alone, as gray values, or the images of scaledPicture() if
/// there are measurements; it begins after the last change of depth or size, since it has one scale. The target is
/// written completely or not at all. May be called on any thread. Fails with a sentence, or when cancelled.
Result<int> writeClip(const SavedClip& clip, const std::filesystem::path& target, const Progress& progress);

}  // namespace insonate::train
