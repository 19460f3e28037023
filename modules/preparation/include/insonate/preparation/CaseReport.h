#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/preparation/StudyPreparation.h>

#include <filesystem>
#include <string>

namespace insonate {

/// Writes the folder of images and facts about a prepared case, from which updateReportPage() makes the page: slices
/// with the outlines of the structures, the patient from the front, ultrasound at up to four start poses, findings and
/// warnings. The folder replaces an earlier one in one step. Takes some seconds.
Result<void> writeCaseReport(const PreparedStudy& prepared, const std::string& id, const std::filesystem::path& folder,
                             const Progress& progress = {});

/// Writes a folder with the reason why a study could not be prepared, for updateReportPage().
Result<void> writeFailureReport(const std::string& id, const std::string& reason, const std::filesystem::path& folder);

/// Tells whether a folder holds the report of a case that was prepared.
bool isReportOfCase(const std::filesystem::path& folder);

/// Writes `index.html` in `reports` from all folders of reports there, failures first. Programs that call this function
/// at the same time wait for each other, so that the last page has all reports.
Result<void> updateReportPage(const std::filesystem::path& reports);

}  // namespace insonate
