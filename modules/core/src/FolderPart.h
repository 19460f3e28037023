#pragma once

#include <filesystem>
#include <optional>

namespace insonate {

/// Returns a hidden path beside a target, with the target's extension, that no other writer uses.
std::filesystem::path partBeside(const std::filesystem::path& target);

/// A temporary folder that is filled beside its target and then replaces it. A file lock tells other programs that the
/// folder is in use; the system releases the lock when this process ends, even after a crash. On a file system without
/// locks, removeAbandonedParts() does not remove such folders.
class FolderPart {
 public:
  explicit FolderPart(const std::filesystem::path& target);
  /// Removes the unfinished folder.
  ~FolderPart();
  FolderPart(const FolderPart&) = delete;
  FolderPart& operator=(const FolderPart&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Returns the error that occurred when the folder was created; an empty code if there was none.
  const std::error_code& error() const { return error_; }

 private:
  std::filesystem::path path_;
  std::error_code error_;
  int lock_ = -1;
};

/// Returns the hidden path of a target's old folder during a replacement in two steps, on systems that cannot exchange
/// folders in one step.
std::filesystem::path oldBeside(const std::filesystem::path& target);

}  // namespace insonate
