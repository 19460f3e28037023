#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/video/AttemptVideo.h>

#include <filesystem>
#include <memory>

namespace insonate {

/// Writes the ultrasound images of an attempt, without texts and marks, as a DICOM clip (see writeDicomClip()) from its
/// recording and its case. The frames are those of writeAttemptVideo(); they are black while no probe is held. The file
/// is written atomically. Fails as writeAttemptVideo() does, and if the scale or the size of the image changes during
/// the attempt, since a DICOM clip has one scale.
Result<void> writeAttemptClip(std::shared_ptr<const AttemptRecording> recording,
                              std::shared_ptr<const PatientCase> patient, const std::filesystem::path& target,
                              const AttemptVideoOptions& options = {}, const Progress& progress = {});

}  // namespace insonate
