#include "FolderPart.h"

#include <insonate/core/AtomicFile.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <string>
#include <string_view>
#include <vector>

namespace insonate {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kPart = ".part-", kOld = ".old-", kDigits = "0123456789";

fs::path hiddenBeside(const fs::path& target, std::string_view kind) {
  static std::atomic<unsigned> counter{0};
  const std::string tag = std::string(kind) + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  // ".nrrd" of "labels.seg.nrrd" must stay last: writers choose their format by it.
  return target.parent_path() / ("." + target.stem().string() + tag + target.extension().string());
}

/// Name of the target of a part or an old folder; empty for other names.
std::string targetOf(const std::string& name, std::string_view kind) {
  const std::size_t tag = name.rfind(kind);
  if (!name.starts_with('.') || tag == std::string::npos || tag < 2) return {};
  const std::size_t process = tag + kind.size(), dash = name.find_first_not_of(kDigits, process);
  if (dash == std::string::npos || dash == process || name[dash] != '-') return {};
  const std::size_t end = std::min(name.find_first_not_of(kDigits, dash + 1), name.size());
  if (end == dash + 1 || (end < name.size() && name[end] != '.')) return {};
  return name.substr(1, tag - 1) + name.substr(end);
}

/// Opens a folder and locks it. Negative if another program holds the lock, or if the file system has no locks.
int locked(const fs::path& folder, int how) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  if (file >= 0 && ::flock(file, how) == 0) return file;
  if (file >= 0) ::close(file);
  return -1;
}

void removeUnlessWritten(const fs::path& part) {
  const int lock = locked(part, LOCK_EX | LOCK_NB);
  if (lock < 0) return;
  std::error_code ignored;
  fs::remove_all(part, ignored);
  ::close(lock);
}

}  // namespace

fs::path partBeside(const fs::path& target) {
  return hiddenBeside(target, kPart);
}

fs::path oldBeside(const fs::path& target) {
  return hiddenBeside(target, kOld);
}

FolderPart::FolderPart(const fs::path& target) {
  do {
    path_ = partBeside(target);
    if (!fs::create_directory(path_, error_)) return;
    lock_ = locked(path_, LOCK_EX);
    // Another program may have removed the folder as abandoned before it was locked.
  } while (!fs::exists(path_, error_));
}

FolderPart::~FolderPart() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
  if (lock_ >= 0) ::close(lock_);
}

void removeAbandonedParts(const fs::path& parent, const std::string& target) {
  std::vector<std::string> hidden;
  std::error_code error;
  for (fs::directory_iterator entry(parent, error); !error && entry != fs::directory_iterator(); entry.increment(error))
    hidden.push_back(entry->path().filename().string());
  for (const std::string& name : hidden) {
    const std::string of = targetOf(name, kPart);
    if (of.empty() || (!target.empty() && of != target)) continue;
    const bool swapped =
        std::ranges::any_of(hidden, [&](const std::string& other) { return targetOf(other, kOld) == of; });
    if (!swapped) removeUnlessWritten(parent / name);
  }
}

}  // namespace insonate
