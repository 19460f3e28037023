#pragma once

#include <filesystem>

namespace insonate::store {

/// Makes a database file readable and writable only by its owner, before it contains anything. An existing file that
/// belongs to the user loses the rights of others. SQLite gives its auxiliary files the same rights. If the file cannot
/// be made, SQLite reports the error later.
void makePrivate(const std::filesystem::path& database);

}  // namespace insonate::store
