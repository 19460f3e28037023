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

/// Counts of the data that PersonData::erase() deletes or changes.
struct PersonExtent {
  std::int64_t attempts = 0;    ///< attempts, which are kept without the names of their recordings
  std::int64_t recordings = 0;  ///< recordings in the folder of this database, which are deleted
  std::int64_t comments = 0;    ///< comments on the person's attempts, which are deleted
  std::int64_t forms = 0;       ///< filled forms about the person, whose texts are deleted
  bool isErased = false;
};

/// Exports or erases all data of one person, as data protection law requires on request. May be used on any thread
/// except the GUI thread, since it waits for the disk or the server.
class PersonData {
 public:
  explicit PersonData(SignedIn by) : by_(std::move(by)) {}

  /// Writes everything that the database holds on a person to a ZIP file, readable by its owner alone: person.json,
  /// attempts.csv and the recordings that are kept here. The file has no password, no secret and no hash of either, and
  /// names other people by id, except authors of comments and raters. Allowed to the person and to administrators; the
  /// audit log has an entry in both cases. Fails if the disk has less room than `roomFactor` times the size of the
  /// recordings. On failure or cancellation `file` is unchanged.
  Result<PersonExport> exportTo(const std::string& person, const std::filesystem::path& file,
                                const Progress& progress = {}, int roomFactor = 1) const;

  /// Returns the counts of the data that erase() would delete or change. Allowed to users who may erase the person.
  Result<PersonExtent> previewErasure(const std::string& person) const;
  /// Erases a person for ever. The names become "Erased person 7f3a41c2"; the e-mail address, the password, all
  /// sessions, the person's classes as an instructor, recordings, comments on the person's attempts and texts in forms
  /// about the person are deleted; names and reasons in the audit log, too, whose check still succeeds. The account is
  /// disabled and cannot be enabled again. What stays: numbers of attempts, choices and numbers in forms, and
  /// everything that the person wrote about others. Erasing again deletes recordings that could not be deleted before.
  /// Allowed to administrators, not for themselves. Workstations of the site erase the person when they next exchange
  /// data.
  Result<void> erase(const std::string& person) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
