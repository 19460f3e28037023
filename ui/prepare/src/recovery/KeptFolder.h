#pragma once

#include <insonate/core/Result.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace insonate::prepare {

/// A folder that keeps the unsaved work on one case. A lock on the folder, which ends with the program, prevents that
/// two programs use one folder. The functions may be called on any thread, but not concurrently.
class KeptFolder {
 public:
  /// Makes and locks a new folder in `root`, which is created if it is missing.
  static Result<std::shared_ptr<KeptFolder>> make(const std::filesystem::path& root);
  /// Locks a folder whose program has ended; null if a program uses the folder, or if its file system has no locks.
  static std::shared_ptr<KeptFolder> take(const std::filesystem::path& folder);
  /// Returns the folders in `root`, including those that are in use.
  static std::vector<std::filesystem::path> foldersIn(const std::filesystem::path& root);
  /// Releases the lock. The files stay.
  ~KeptFolder();
  KeptFolder(const KeptFolder&) = delete;
  KeptFolder& operator=(const KeptFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// File with the unsaved work (cases/UnsavedWork.h).
  std::filesystem::path workFile() const { return path_ / "unsaved.work"; }
  /// Folder of a copy of the case, if the case was never saved.
  std::filesystem::path caseCopy() const { return path_ / "case"; }

  /// Deletes the folder.
  void remove();
  /// Renames the folder, so that it is not found any more, and returns its new name.
  std::filesystem::path setAside();

 private:
  KeptFolder(std::filesystem::path path, int lock) : path_(std::move(path)), lock_(lock) {}

  std::filesystem::path path_;
  int lock_;
};

}  // namespace insonate::prepare
