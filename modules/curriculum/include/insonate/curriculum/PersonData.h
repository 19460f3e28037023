#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace insonate {

/// Numbers of the attempts and recordings in an export.
struct PersonExport {
  std::int64_t attempts = 0, recordings = 0;
};

/// Answers requests that concern all data of one person. May be used on any thread except the GUI thread, since it
/// waits for the disk or the server.
class PersonData {
 public:
  explicit PersonData(SignedIn by) : by_(std::move(by)) {}

  /// Writes everything that the database holds on a person to a ZIP file, readable by its owner alone: person.json,
  /// attempts.csv and the recordings that are kept here. The file has no password, no secret and no hash of either, and
  /// names other people by id, except authors of comments and raters. Allowed to the person and to administrators; the
  /// audit log has an entry in both cases. On failure or cancellation `file` is unchanged.
  Result<PersonExport> exportTo(const std::string& person, const std::filesystem::path& file,
                                const Progress& progress = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
