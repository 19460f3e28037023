#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>

namespace insonate {

/// Address, schema and numbers of rows of a curriculum database.
struct StoreFacts {
  std::string place{};  ///< file of the database, or server without the password
  int schema = 0;       ///< schema number: that of the last migration
  std::int64_t people = 0, cohorts = 0, attempts = 0, forms = 0, auditEntries = 0, pendingUploads = 0;
};

/// Maintenance of a curriculum database: counts, verification, backup and export. For administrators only.
class StoreUpkeep {
 public:
  explicit StoreUpkeep(SignedIn by) : by_(std::move(by)) {}

  Result<StoreFacts> facts() const;
  /// Checks all pages and keys of the database, the hashes of published curricula and the audit log. Takes seconds.
  Result<void> verify() const;
  /// Copies the database to `file` as it is at one moment, also while other processes use it; an existing `file` is
  /// replaced once the copy is complete. Recordings are copied to FILE.recordings, in addition to those of earlier
  /// backups. Fails for a database on a server, which is backed up by pg_dump.
  Result<void> backup(const std::filesystem::path& file, const Progress& progress = {}) const;
  /// Writes all data except passwords as one JSON object with a list for each table. Each attempt also has fields that
  /// say whether it was voided, whether its recording broke off, and, by the curriculum version for which the attempt
  /// was made, the level's assistance and whether the attempt passed; the last two are null in free practice.
  Result<void> exportJson(const std::filesystem::path& file) const;

 private:
  SignedIn by_;
};

/// Replaces a database file, which may be open, damaged or missing, by a backup. `administrator` and `password` belong
/// to the replaced database; if that one is missing, damaged or has no people yet, to the backup. Pages, schema and
/// audit log of the backup are checked first; the log then records who restored it and where the replaced log ended.
/// The former file is kept as FILE.before-restore. The backup's recordings are added to the existing ones; none is
/// deleted.
Result<void> restoreStore(const std::filesystem::path& file, const std::filesystem::path& backup,
                          const std::string& administrator, const std::string& password);

/// Upgrades a database to the newest schema on behalf of an administrator, whose password is checked before anything
/// but the log is changed. CurriculumStore::open() upgrades a database, too.
Result<void> migrateStore(const std::string& address, const std::string& administrator, const std::string& password,
                          const StoreServices& services = {});

}  // namespace insonate
