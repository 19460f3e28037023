#include "record/RecordFile.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace insonate::record {

Result<RecordFile> RecordFile::make(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
  if (file >= 0) {
    // isOpen() looks for this lock. A file system without locks only keeps the file from being recovered.
    (void)::flock(file, LOCK_EX | LOCK_NB);
    return RecordFile(path, file);
  }
  if (errno == EEXIST)
    return fail("The recording " + path.string() + " is in progress, or was not completed; rename that file first.");
  return fail("The recording " + path.string() + " cannot be started: " + std::strerror(errno) + ".");
}

RecordFile::RecordFile(RecordFile&& other) noexcept
    : path_(std::move(other.path_)), file_(std::exchange(other.file_, -1)) {}

RecordFile::~RecordFile() {
  if (file_ >= 0) ::close(file_);
}

bool RecordFile::isOpen(const std::filesystem::path& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool isFree = ::flock(file, LOCK_EX | LOCK_NB) == 0;
  ::close(file);
  return !isFree;
}

Result<void> RecordFile::append(std::span<const std::uint8_t> bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t written = ::write(file_, bytes.data() + done, bytes.size() - done);
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) break;
    done += static_cast<std::size_t>(written);
  }
  if (done == bytes.size() && ::fdatasync(file_) == 0) return {};
  return fail(path_.string() + " can no longer be written: " + std::strerror(errno) +
              ". The recording up to this moment is kept there.");
}

}  // namespace insonate::record
