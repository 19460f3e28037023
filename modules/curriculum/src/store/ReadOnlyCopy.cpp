#include "store/ReadOnlyCopy.h"

#include "store/sql/FileCopy.h"
#include "store/sql/PrivateFile.h"

#include <fcntl.h>
#include <unistd.h>

#include <QtCore/QTemporaryDir>

namespace insonate::store {
namespace {

namespace fs = std::filesystem;

bool isWritable(const fs::path& path) {
  return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) == 0;
}

/// Copies the file and its log. Without the index of the log (-shm), which SQLite cannot make here, no program has the
/// database open, so that the files do not change meanwhile.
Result<void> copyFiles(const fs::path& from, const fs::path& to) {
  for (const char* part : {"", "-wal"}) {
    const fs::path source = from.string() + part, copied = to.string() + part;
    std::error_code error;
    if (*part && !fs::exists(source, error)) continue;
    fs::copy_file(source, copied, fs::copy_options::overwrite_existing, error);
    if (!error) fs::permissions(copied, fs::perms::owner_read | fs::perms::owner_write, error);
    if (error) return fail("Could not copy " + source.string() + " for reading: " + error.message() + ".");
  }
  return {};
}

}  // namespace

bool isReadOnlyFile(const fs::path& database) {
  std::error_code error;
  if (!fs::is_regular_file(database, error)) return false;
  return !isWritable(database) || !isWritable(fs::absolute(database, error).parent_path());
}

struct ReadOnlyCopy::Folder {
  QTemporaryDir directory;
};

ReadOnlyCopy::ReadOnlyCopy() : folder_(std::make_unique<Folder>()) {}
ReadOnlyCopy::~ReadOnlyCopy() = default;

fs::path ReadOnlyCopy::file() const {
  return folder_->directory.filePath(QStringLiteral("curriculum.sqlite")).toStdString();
}

Result<std::unique_ptr<ReadOnlyCopy>> ReadOnlyCopy::make(const fs::path& database) {
  std::unique_ptr<ReadOnlyCopy> copy(new ReadOnlyCopy);
  if (!copy->folder_->directory.isValid())
    return fail("Could not make a temporary folder for reading " + database.string() + ": " +
                copy->folder_->directory.errorString().toStdString() + ".");
  makePrivate(copy->file());
  if (copyFile(database, copy->file())) return copy;
  // SQLite cannot open a database in WAL mode in a folder that it cannot write, unless another program has it open.
  if (auto copied = copyFiles(database, copy->file()); !copied) return tl::unexpected(copied.error());
  return copy;
}

}  // namespace insonate::store
