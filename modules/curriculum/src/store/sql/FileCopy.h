#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate::store {

/// Copies an SQLite database in its state at one moment, even while other processes use the database. Replaces `file`
/// once the copy is complete.
Result<void> copyToFile(Connection& from, const std::filesystem::path& file);

/// Copies an SQLite file that is not open in this process; the source is only read.
Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Replaces all contents of the database `to` by the contents of `from`, in one transaction; other connections see the
/// change at once.
Result<void> copyInto(Connection& from, Connection& to);

}  // namespace insonate::store
