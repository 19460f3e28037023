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
  int schema = 0;       ///< schema number: number of the last migration
  std::int64_t people = 0, cohorts = 0, attempts = 0, forms = 0, auditEntries = 0, pendingUploads = 0;
};

/// Maintenance of a curriculum database: counts, verification, backup and export. For administrators only.
class StoreUpkeep {
 public:
  explicit StoreUpkeep(SignedIn by) : by_(std::move(by)) {}

  /// Returns address, schema number and numbers of rows of the database.
  Result<StoreFacts> facts() const;
  /// Checks the pages and keys of the database, the hashes of published curricula, and the audit log. Takes seconds.
  Result<void> verify() const;
  /// Copies a consistent snapshot of the database to `file`, even while other processes use the database. An existing
  /// `file` is replaced when the copy is complete. Recordings are copied to the folder FILE.recordings; recordings of
  /// earlier backups stay there. Fails for a database on a server, for which pg_dump makes backups.
  Result<void> backup(const std::filesystem::path& file, const Progress& progress = {}) const;
  /// Writes all data except passwords as one JSON object with a list for each table. Each attempt also has these
  /// fields: whether the attempt was voided; whether its recording broke off; and, according to the curriculum version
  /// for which the attempt was made, the assistance of its level and whether the attempt passed. The last two are null
  /// in free practice.
  Result<void> exportJson(const std::filesystem::path& file) const;
  /// Gives an existing PostgreSQL role exactly the permissions that insonate-server needs to run. The role cannot
  /// change tables and triggers, cannot delete entries of the audit log, can change these entries only to erase a
  /// person, and cannot change published curricula. Only the owner of the tables can call this function. Only the owner
  /// can later upgrade the database (migrateStore()); a server with the role cannot.
  Result<void> grantServerRole(const std::string& role) const;

 private:
  SignedIn by_;
};

/// Replaces a database file, which may be open, damaged or missing, by a backup. `administrator` and `password` are the
/// name and password of an administrator in the database to be replaced. If this database is missing, damaged or has no
/// people yet, they are those of an administrator in the backup. Pages, schema and audit log of the backup are checked
/// first. An entry in the audit log of the restored database then states who restored the backup and where the log of
/// the replaced database ended. The replaced file is kept as FILE.before-restore. The recordings of the backup are
/// added to the existing recordings; none is deleted.
Result<void> restoreStore(const std::filesystem::path& file, const std::filesystem::path& backup,
                          const std::string& administrator, const std::string& password);

/// Upgrades a database to the newest schema on behalf of an administrator. The password is checked before anything
/// except the audit log is changed. CurriculumStore::open() also upgrades a database.
Result<void> migrateStore(const std::string& address, const std::string& administrator, const std::string& password,
                          const StoreServices& services = {});

}  // namespace insonate
