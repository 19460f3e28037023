#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>

namespace insonate::store {

/// The number of the newest schema that this program knows.
int newestSchema();

/// Beside a store's file.
std::filesystem::path copyBeforeMigration(const std::filesystem::path& file, int schema);

/// A file with tables that this program did not make is left alone.
Result<void> refuseForeign(Connection& connection);

/// Brings a store to the newest schema, each step in a transaction; of two programs that come at once, one does it. A
/// file that holds anything is first copied. Fails where a newer program made it.
Result<void> migrate(Connection& connection, const Address& address, std::int64_t now_us);

}  // namespace insonate::store
