#pragma once

#include <filesystem>

namespace insonate::store {

/// Makes a database file readable and writable only by its owner: an empty new file, or an existing file that belongs
/// to the user. SQLite gives its auxiliary files the same rights. If the file cannot be created, SQLite reports the
/// error later.
void makePrivate(const std::filesystem::path& database);

}  // namespace insonate::store
