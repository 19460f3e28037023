#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate::store {

/// A copy of a file's store as of one moment, while others work with it; replaces `file` once it is whole.
Result<void> copyToFile(Connection& from, const std::filesystem::path& file);

/// Copies a file that is not open here and is only read.
Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Replaces all contents of `to` by those of `from`, in one transaction; other connections see the change at once.
Result<void> copyInto(Connection& from, Connection& to);

}  // namespace insonate::store
