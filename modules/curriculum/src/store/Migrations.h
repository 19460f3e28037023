#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>

namespace insonate::store {

/// Number of the newest schema that this program knows.
int newestSchema();

/// Path of the copy that is made before a migration, beside the store's file.
std::filesystem::path copyBeforeMigration(const std::filesystem::path& file, int schema);

/// Fails on a file with tables that this program did not make; such a file is not changed.
Result<void> refuseForeign(Connection& connection);

/// Brings a store to the newest schema, each step in one transaction. If two programs start at once, only one of them
/// migrates. A file that is not empty is first copied. Fails if a newer program made the store.
Result<void> migrate(Connection& connection, const Address& address, std::int64_t now_us);

}  // namespace insonate::store
