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

struct StoreFacts {
  std::string place{};  ///< file, or server without the password
  int schema = 0;       ///< number of the last migration
  std::int64_t people = 0, cohorts = 0, attempts = 0, forms = 0, auditEntries = 0, pendingUploads = 0;
};

/// Backup, restore and verification of a store. For administrators only.
class StoreUpkeep {
 public:
  explicit StoreUpkeep(SignedIn by) : by_(std::move(by)) {}

  Result<StoreFacts> facts() const;
  /// Reads all pages and keys, and checks the hashes of published texts and the audit log. Takes seconds.
  Result<void> verify() const;
  /// Copies a file's store as it is at one moment, while other processes use it. Replaces `file` once the copy is
  /// complete. The store's recordings are copied to FILE.recordings; recordings of an earlier backup stay there. Fails
  /// for a server's store, which is backed up by pg_dump.
  Result<void> backup(const std::filesystem::path& file, const Progress& progress = {}) const;
  /// Writes everything except passwords as one JSON object with a list for each table. For each attempt it also
  /// contains whether it was voided, whether its recording broke off, and, by the curriculum version for which the
  /// attempt was made, the level's assistance and whether the attempt passed; the last two are null in free practice.
  Result<void> exportJson(const std::filesystem::path& file) const;

 private:
  SignedIn by_;
};

/// Replaces a store's file, which may be open, damaged or missing, by a backup. `administrator` and `password` belong
/// to the replaced store; if that store is missing, damaged or has no people yet, they belong to the backup. The backup
/// is checked first: its pages, its schema, and its audit log, which records who restored it and where the replaced log
/// ended. The former file is kept as FILE.before-restore. The backup's recordings are added to the store's recordings;
/// none of the store's recordings is deleted.
Result<void> restoreStore(const std::filesystem::path& file, const std::filesystem::path& backup,
                          const std::string& administrator, const std::string& password);

/// Upgrades a store for one of its administrators, whose password is checked before anything but the log is changed.
/// Opening a store upgrades it too, for any user, but gives no user new permissions.
Result<void> migrateStore(const std::string& address, const std::string& administrator, const std::string& password,
                          const StoreServices& services = {});

}  // namespace insonate
