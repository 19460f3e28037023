#include "KeptFolder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdlib>
#include <system_error>

namespace insonate::prepare {
namespace fs = std::filesystem;
namespace {

const std::string kNew = ".new-", kKept = "case-", kAside = "damaged-";
constexpr const char* kLock = "lock";

}  // namespace

Result<std::shared_ptr<KeptFolder>> KeptFolder::make(const fs::path& root) {
  std::error_code error;
  fs::create_directories(root, error);
  // The folder may contain images of patients.
  fs::permissions(root, fs::perms::owner_all, error);
  std::string begun = (root / (kNew + "XXXXXX")).string();
  if (!::mkdtemp(begun.data())) return fail("Unsaved work cannot be kept: " + root.string() + " cannot be written.");
  const int lock = ::open((fs::path(begun) / kLock).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  // take() looks for this lock. On a file system without locks, the folder is never taken.
  if (lock >= 0) (void)::flock(lock, LOCK_EX | LOCK_NB);
  // The folder has its name, by which other programs find it, only after it is locked.
  const fs::path path = root / (kKept + begun.substr(begun.size() - 6));
  fs::rename(begun, path, error);
  if (lock >= 0 && !error) return std::shared_ptr<KeptFolder>(new KeptFolder(path, lock));
  if (lock >= 0) ::close(lock);
  fs::remove_all(begun, error);
  return fail("Unsaved work cannot be kept: " + path.string() + " cannot be written.");
}

std::shared_ptr<KeptFolder> KeptFolder::take(const fs::path& folder) {
  const int lock = ::open((folder / kLock).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return nullptr;
  if (::flock(lock, LOCK_EX | LOCK_NB) == 0) return std::shared_ptr<KeptFolder>(new KeptFolder(folder, lock));
  ::close(lock);
  return nullptr;
}

std::vector<fs::path> KeptFolder::foldersIn(const fs::path& root) {
  std::vector<fs::path> folders;
  std::error_code error;
  for (fs::directory_iterator entry(root, error), end; !error && entry != end; entry.increment(error))
    if (entry->path().filename().string().starts_with(kKept)) folders.push_back(entry->path());
  return folders;
}

KeptFolder::~KeptFolder() {
  ::close(lock_);
}

void KeptFolder::remove() {
  std::error_code error;
  // Without this file nothing is restored, even if the program ends now.
  fs::remove(workFile(), error);
  fs::remove_all(path_, error);
}

fs::path KeptFolder::setAside() {
  const std::string name = path_.filename().string();
  const fs::path aside = path_.parent_path() / (kAside + name.substr(kKept.size()));
  std::error_code error;
  fs::rename(path_, aside, error);
  if (!error) path_ = aside;
  return path_;
}

}  // namespace insonate::prepare
