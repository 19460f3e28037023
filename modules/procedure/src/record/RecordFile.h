#pragma once

#include "record/Bytes.h"

#include <insonate/core/Result.h>

#include <filesystem>
#include <span>

namespace insonate::record {

/// File to which data is only appended. Appended data is on the disk when append() returns.
class RecordFile {
 public:
  /// Creates the file. Fails if it exists or cannot be created.
  static Result<RecordFile> make(const std::filesystem::path& path);
  RecordFile(RecordFile&& other) noexcept;
  RecordFile& operator=(RecordFile&&) = delete;
  ~RecordFile();

  /// Tells whether a program is writing the file; also true if its file system has no locks.
  static bool isOpen(const std::filesystem::path& path);

  /// Appends bytes. If it fails, a part of them may have been appended.
  Result<void> append(std::span<const std::uint8_t> bytes);

 private:
  RecordFile(std::filesystem::path path, int file) : path_(std::move(path)), file_(file) {}
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace insonate::record
