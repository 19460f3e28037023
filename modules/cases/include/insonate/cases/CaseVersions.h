#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace insonate {

/// Returns a fingerprint of the data on which the simulation of an attempt (one recorded procedure of a trainee)
/// depends: grid, tissues (see cases/TissueLabels.h) and CT. Recorded attempts store this fingerprint. Takes some
/// tenths of a second for a large CT.
std::string voxelHashOf(const PatientCase& patient);

/// Returns a fingerprint of the data of a case that affect trainees: voxels, targets and start poses. Titles, colors
/// and display settings do not affect the fingerprint.
std::string contentHashOf(const PatientCase& patient);

/// Returns today's date, local time, in the form in which a version stores dates: "2026-11-22".
std::string today();

/// Writes a case to its folder, like writeCase(), and returns its version. If the folder holds a case with different
/// content, that case is kept under `versions/NUMBER` in the folder, so that attempts on it can be replayed, and the
/// new version gets the next number. Unchanged content keeps its number and date. Programs that have read the old case
/// are not affected. If two programs or threads save at the same time, one waits for the other, and both versions are
/// kept. `date` is a day without a time; `author` may be empty.
Result<CaseVersion> saveCaseVersion(const PatientCase& patient, const std::filesystem::path& folder,
                                    const std::string& date, const std::string& author, const Progress& progress = {});

/// Searches a case and its earlier versions for the version with this voxelHashOf(). Returns its folder, for
/// readCase(); no value if no version has this hash.
std::optional<std::filesystem::path> findVersion(const std::filesystem::path& folder, const std::string& voxelHash);

/// Returns the versions of a case that are kept in its folder, the latest first; empty if there are none. Does not read
/// volumes.
std::vector<CaseVersion> versionsOf(const std::filesystem::path& folder);

/// Publishes the case in a folder: keeps the case as an unchanging version under `versions/NUMBER`. Trainees get this
/// version until another version is published; later saves do not affect the published version. `seen` is the case that
/// the author has checked; fails if the content of the folder differs from `seen`. A case whose title has changed since
/// it was published gets a new version. Does not check whether the case is fit for training.
Result<CaseVersion> publishCase(const PatientCase& seen, const std::filesystem::path& folder, const std::string& date,
                                const Progress& progress = {});

/// Returns the number of the version that trainees get; 0 if none is published.
int publishedVersion(const std::filesystem::path& folder);

/// Searches those versions of a case that are published or were published before, for the version with this
/// voxelHashOf(). Returns its folder; no value if there is none. Does not read volumes.
std::optional<std::filesystem::path> findPublishedVersion(const std::filesystem::path& folder,
                                                          const std::string& voxelHash);

/// Returns the folder of a case's published version; the case's own folder if none is published.
std::filesystem::path caseForTraining(const std::filesystem::path& folder);

/// Returns the folder of the case to which a version folder belongs; no value if the folder is not a version folder.
std::optional<std::filesystem::path> caseOfVersion(const std::filesystem::path& folder);

}  // namespace insonate
