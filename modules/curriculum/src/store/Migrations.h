#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>

namespace insonate::store {

/// Number of the newest schema that this program knows.
int newestSchema();

/// Returns the path of the backup that is made before a migration, beside the database file.
std::filesystem::path copyBeforeMigration(const std::filesystem::path& file, int schema);

/// Fails on a database with tables that this program did not make, so that foreign files are not changed.
Result<void> refuseForeign(Connection& connection);

/// Upgrades a database to the newest schema, each migration in one transaction. If two programs start at once, only one
/// of them migrates. A file that is not empty is first copied. Fails if a newer program version made the database.
Result<void> migrate(Connection& connection, const Address& address, std::int64_t now_us);

}  // namespace insonate::store
