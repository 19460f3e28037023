#include "store/sql/PrivateFile.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace insonate::store {

void makePrivate(const std::filesystem::path& database) {
  // Opens only a new file here: closing a file that SQLite has open would release SQLite's locks.
  if (const int file = ::open(database.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR); file >= 0)
    ::close(file);
  for (const char* part : {"", "-wal", "-shm"}) {
    const std::string path = database.string() + part;
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && (status.st_mode & 0077) != 0 &&
        status.st_uid == ::geteuid())
      (void)::chmod(path.c_str(), status.st_mode & 0700);
  }
}

}  // namespace insonate::store
