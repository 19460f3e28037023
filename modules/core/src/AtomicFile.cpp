#include <insonate/core/AtomicFile.h>

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <fstream>

namespace insonate {
namespace fs = std::filesystem;
namespace {

fs::path besideOf(const fs::path& target) {
  static std::atomic<unsigned> counter{0};
  const std::string tag = ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  std::string name = target.stem().string();
  std::string extension = target.extension().string();
  // "labels.seg.nrrd" must keep ".nrrd" last: writers choose their format by it.
  return target.parent_path() / ("." + name + tag + extension);
}

// Data must be on the disk before the name is: a crash in between would leave an empty file under the final name.
bool flushToDisk(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool ok = ::fsync(fd) == 0;
  ::close(fd);
  return ok;
}

template <class Write>
Result<void> guarded(const fs::path& beside, const fs::path& target, const Write& write) {
  try {
    return write(beside);
  } catch (const std::exception& e) {
    return fail("Could not write " + target.string() + ": " + e.what());
  }
}

Result<void> parentExists(const fs::path& target) {
  std::error_code error;
  const fs::path parent = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, error))
    return fail("Could not write " + target.string() + ": the folder " + parent.string() + " does not exist.");
  return {};
}

}  // namespace

Result<void> writeAtomically(const fs::path& target, const std::function<Result<void>(const fs::path&)>& write) {
  if (auto ok = parentExists(target); !ok) return ok;
  const fs::path beside = besideOf(target);
  Result<void> written = guarded(beside, target, write);
  std::error_code error;
  if (written && !flushToDisk(beside)) written = fail("Could not write " + target.string() + " to the disk.");
  if (written) {
    fs::rename(beside, target, error);
    if (error) written = fail("Could not write " + target.string() + ": " + error.message() + ".");
  }
  if (!written) fs::remove(beside, error);
  return written;
}

Result<void> writeAtomically(const fs::path& target, std::string_view bytes) {
  return writeAtomically(target, [&](const fs::path& beside) -> Result<void> {
    std::ofstream out(beside, std::ios::binary);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out)
      return fail("Could not write " + target.string() +
                  ": the disk is full or the folder cannot be written. Free space or choose another folder.");
    return {};
  });
}

Result<void> writeFolderAtomically(const fs::path& target, const std::function<Result<void>(const fs::path&)>& write) {
  const fs::path folder = target.has_filename() ? target : target.parent_path();
  if (auto ok = parentExists(folder); !ok) return ok;
  const fs::path beside = besideOf(folder);
  std::error_code error;
  fs::create_directory(beside, error);
  if (error) return fail("Could not write " + folder.string() + ": " + error.message() + ".");
  Result<void> written = guarded(beside, folder, write);
  for (const auto& file : fs::recursive_directory_iterator(beside, error)) {
    if (written && file.is_regular_file() && !flushToDisk(file.path()))
      written = fail("Could not write " + folder.string() + " to the disk.");
  }
  if (written) {
    if (!fs::exists(folder, error)) {
      fs::rename(beside, folder, error);
    } else {
      for (const auto& file : fs::directory_iterator(beside)) {
        fs::rename(file.path(), folder / file.path().filename(), error);
        if (error) break;
      }
    }
    if (error) written = fail("Could not write " + folder.string() + ": " + error.message() + ".");
  }
  fs::remove_all(beside, error);
  return written;
}

}  // namespace insonate
