#pragma once

#include <filesystem>
#include <optional>

namespace insonate {

/// A hidden name beside a target that no other writer uses; its extension is that of the target.
std::filesystem::path partBeside(const std::filesystem::path& target);

/// A folder that is filled beside its target. A lock marks it as in use for other programs; the lock ends with this
/// process, however that ends. On a file system without locks, leftovers are never taken for abandoned.
class FolderPart {
 public:
  explicit FolderPart(const std::filesystem::path& target);
  /// Removes the unfinished folder.
  ~FolderPart();
  FolderPart(const FolderPart&) = delete;
  FolderPart& operator=(const FolderPart&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// Why it could not be made.
  const std::error_code& error() const { return error_; }

 private:
  std::filesystem::path path_;
  std::error_code error_;
  int lock_ = -1;
};

/// Hidden name of the old folder while a new one replaces it in two steps, where the system has no single step for it.
std::filesystem::path oldBeside(const std::filesystem::path& target);

}  // namespace insonate
