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

  /// Writes all data of a person in the database to a ZIP file, which only the user who runs the program can read. The
  /// file contains person.json, attempts.csv, and those recordings of the person that are in this database's folder. It
  /// contains no password, no secret, and no hash of a password or secret. It contains other people's ids but not their
  /// names, except the names of authors of comments and of raters. The person and administrators may call this
  /// function; the audit log gets an entry in both cases. Fails if the free space of the disk is less than `roomFactor`
  /// times the size of the recordings. On failure or cancellation `file` is unchanged.
  Result<PersonExport> exportTo(const std::string& person, const std::filesystem::path& file,
                                const Progress& progress = {}, int roomFactor = 1) const;

  /// Returns the counts of the data that erase() would delete or change. Allowed to users who may erase the person.
  Result<PersonExtent> previewErasure(const std::string& person) const;
  /// Erases a person for ever. The names become "Erased person 7f3a41c2". Deleted are the e-mail address, the password,
  /// all sessions, the person's classes as an instructor, recordings, comments on the person's attempts, texts in forms
  /// about the person, and names and reasons in the audit log; AuditLog::verify() still succeeds. The account is
  /// disabled and cannot be enabled again. Kept are the numbers of attempts, choices and numbers in forms, and
  /// everything that the person wrote about others. Erasing the person again deletes recordings that could not be
  /// deleted before. Administrators may erase other people, but not themselves. Workstations of the site erase the
  /// person when they next exchange data.
  Result<void> erase(const std::string& person) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
