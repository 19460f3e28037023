#pragma once

#include <filesystem>

namespace insonate::store {

/// Makes a database's file readable and writable by its owner alone, before anything is in it; a file that is there
/// already loses the rights of others, as far as it belongs to the user. SQLite gives the files that it keeps beside it
/// the same rights. What cannot be made is left to SQLite, which says why.
void makePrivate(const std::filesystem::path& database);

}  // namespace insonate::store
