#pragma once

#include "store/sql/Connection.h"

#include <insonate/core/Result.h>

#include <filesystem>

namespace insonate::store {

/// A copy of a file's store as of one moment, while others work with it; replaces `file` once it is whole.
Result<void> copyToFile(Connection& from, const std::filesystem::path& file);

/// The same of a file that is not open here and is only read.
Result<void> copyFile(const std::filesystem::path& from, const std::filesystem::path& to);

/// Replaces all that is in `to` by what is in `from`, in one transaction; others that have it open see it at once.
Result<void> copyInto(Connection& from, Connection& to);

}  // namespace insonate::store
