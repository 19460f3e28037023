#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <memory>

namespace insonate::store {

/// Tells whether the database file exists, but the user cannot write it or its folder. SQLite needs both.
bool isReadOnlyFile(const std::filesystem::path& database);

/// A private copy of a database file that the user can only read. The copy is deleted with the object. It is needed
/// since SQLite reads a database in WAL mode only if it can write files beside it.
class ReadOnlyCopy {
 public:
  static Result<std::unique_ptr<ReadOnlyCopy>> make(const std::filesystem::path& database);
  ~ReadOnlyCopy();
  ReadOnlyCopy(const ReadOnlyCopy&) = delete;
  ReadOnlyCopy& operator=(const ReadOnlyCopy&) = delete;

  std::filesystem::path file() const;

 private:
  ReadOnlyCopy();

  struct Folder;
  const std::unique_ptr<Folder> folder_;
};

}  // namespace insonate::store
