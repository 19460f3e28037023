#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Fingerprint of everything from which an attempt on this case is computed: sizes, tissues (see cases/TissueLabels.h)
/// and CT. Recorded attempts name it. Takes some tenths of a second for a large CT.
std::string voxelHashOf(const PatientCase& patient);

/// Fingerprint of everything that makes a different case for a trainee: voxels, targets and start poses. Titles,
/// colors and what is shown may change without affecting it.
std::string contentHashOf(const PatientCase& patient);

/// The day of today here, for a version: "2026-11-22".
std::string today();

/// Writes a case to its folder, like writeCase(), and returns its version. If the folder holds another content, that
/// stays under `versions/NUMBER` in it, so that attempts on it can be replayed; the number goes up by one. The same
/// content keeps its number and date. Readers of the old case keep what they read. Two simultaneous saves, also from
/// two programs, follow one another, and neither version is lost. `date` is a day without a time, `author` may be
/// empty.
Result<CaseVersion> saveCaseVersion(const PatientCase& patient, const std::filesystem::path& folder,
                                    const std::string& date, const std::string& author, const Progress& progress = {});

/// Searches a case and its earlier versions for the folder whose CT and labels have this voxelHashOf(); readCase()
/// reads it. None if this version is not kept here.
std::optional<std::filesystem::path> findVersion(const std::filesystem::path& folder, const std::string& voxelHash);

/// Versions that are kept, the latest first; empty for a case that has none. Reads no volumes.
std::vector<CaseVersion> versionsOf(const std::filesystem::path& folder);

/// Publishes the case of a folder as a fixed version under `versions/NUMBER`, which trainees get from now on,
/// independent of later saves, until another one is published. Fails if the folder holds another content than `seen`,
/// which its author has checked. Does not check whether it is fit.
Result<CaseVersion> publishCase(const PatientCase& seen, const std::filesystem::path& folder, const std::string& date,
                                const Progress& progress = {});

/// Number of the version that trainees get; 0 if none is published.
int publishedVersion(const std::filesystem::path& folder);

/// Folder of the published version of a case; the case's own folder if none is published.
std::filesystem::path caseForTraining(const std::filesystem::path& folder);

/// The case of which this folder is a kept version; none for any other folder.
std::optional<std::filesystem::path> caseOfVersion(const std::filesystem::path& folder);

}  // namespace insonate
