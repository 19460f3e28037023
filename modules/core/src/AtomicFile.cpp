#include "FolderPart.h"

#include <insonate/core/AtomicFile.h>

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace insonate {
namespace fs = std::filesystem;
namespace {

// Data must be on the disk before the file is renamed: otherwise a crash would leave an empty file under the final
// name.
bool flushToDisk(const fs::path& file) {
  const int fd = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (fd < 0) return false;
  const bool ok = ::fsync(fd) == 0;
  ::close(fd);
  return ok;
}

/// Errors name the target, since the user does not know the temporary path beside it.
std::string naming(const fs::path& target, const fs::path& beside, std::string sentence) {
  const std::string from = beside.string(), to = target.string();
  for (std::size_t at = sentence.find(from); at != std::string::npos; at = sentence.find(from, at + to.size()))
    sentence.replace(at, from.size(), to);
  return sentence;
}

template <class Write>
Result<void> guarded(const fs::path& beside, const fs::path& target, const Write& write) {
  try {
    Result<void> written = write(beside);
    if (!written) return fail(naming(target, beside, written.error().message));
    return written;
  } catch (const std::exception& e) {
    return fail("Could not write " + target.string() + ": " + naming(target, beside, e.what()));
  }
}

tl::unexpected<Error> couldNotWrite(const fs::path& target, const std::error_code& error) {
  return fail("Could not write " + target.string() + ": " + error.message() + ".");
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
  const fs::path beside = partBeside(target);
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

Result<void> checkFolderTarget(const fs::path& target) {
  if (target.empty()) return fail("The name of the folder to write is empty.");
  const fs::path folder = target.has_filename() ? target : target.parent_path();
  std::error_code error;
  if (fs::is_symlink(folder, error) && !fs::exists(folder, error))
    return fail(folder.string() +
                " is a link to a folder that does not exist. Remove the link or name another folder.");
  if (fs::exists(folder, error) && !fs::is_directory(folder, error))
    return fail(folder.string() + " is a file; a folder is needed.");
  if (auto ok = parentExists(folder); !ok) return fail(ok.error().message + " Create it first.");
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  for (const fs::path& place : {parent, folder})
    if (fs::exists(place, error) && ::access(place.c_str(), W_OK | X_OK) != 0)
      return fail("Could not write " + folder.string() + ": the folder " + place.string() +
                  " cannot be written; choose another.");
  return {};
}

namespace {

bool sharesNames(const fs::path& a, const fs::path& b) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(a, error))
    if (fs::exists(b / entry.path().filename(), error)) return true;
  return false;
}

/// Links the other files of `folder`, which are neither replaced nor superseded, into the new folder (hard links).
std::error_code carryOver(const fs::path& folder, const fs::path& beside,
                          const std::vector<std::string_view>& superseded) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path name = entry.path().filename();
    if (fs::exists(beside / name, error) || std::ranges::find(superseded, name.string()) != superseded.end()) continue;
    const auto options = fs::copy_options::recursive | fs::copy_options::copy_symlinks;
    fs::copy(entry.path(), beside / name, options | fs::copy_options::create_hard_links, error);
    if (error) {  // a file system without hard links
      fs::remove_all(beside / name, error);
      fs::copy(entry.path(), beside / name, options, error);
    }
    if (error) return error;
  }
  return error;
}

/// Exchanges the two folders: afterwards the old one is at `beside`.
std::error_code swapFolders(const fs::path& beside, const fs::path& folder) {
  if (::renameat2(AT_FDCWD, beside.c_str(), AT_FDCWD, folder.c_str(), RENAME_EXCHANGE) == 0) return {};
  std::error_code error;
  const fs::path old = oldBeside(folder);
  fs::rename(folder, old, error);
  if (error) return error;
  fs::rename(beside, folder, error);
  std::error_code ignored;
  fs::rename(old, error ? folder : beside, ignored);
  return error;
}

std::error_code moveInto(const fs::path& beside, const fs::path& folder) {
  std::error_code error;
  for (const auto& file : fs::directory_iterator(beside)) {
    fs::rename(file.path(), folder / file.path().filename(), error);
    if (error) break;
  }
  return error;
}

std::error_code putInPlace(const fs::path& beside, const fs::path& folder,
                           const std::vector<std::string_view>& superseded) {
  std::error_code error;
  if (!fs::exists(folder, error)) {
    fs::rename(beside, folder, error);
    return error;
  }
  const bool isCurrent = fs::equivalent(folder, ".", error);
  if (isCurrent || !sharesNames(beside, folder)) return moveInto(beside, folder);
  const auto permissions = fs::status(folder, error).permissions();
  if (error = carryOver(folder, beside, superseded); error) return error;
  fs::permissions(beside, permissions, error);
  return swapFolders(beside, folder);
}

}  // namespace

Result<void> writeFolderAtomically(const fs::path& target, const std::function<Result<void>(const fs::path&)>& write,
                                   const std::vector<std::string_view>& superseded) {
  std::error_code error;
  if (auto ok = checkFolderTarget(target); !ok) return ok;
  const fs::path named = target.has_filename() ? target : target.parent_path();
  // A symbolic link keeps pointing to the written folder.
  const fs::path folder = fs::exists(named, error) ? fs::canonical(named, error) : named;
  if (error) return couldNotWrite(named, error);
  removeAbandonedParts(folder.has_parent_path() ? folder.parent_path() : fs::path("."), folder.filename().string());
  const FolderPart part(folder);
  if (part.error()) return couldNotWrite(named, part.error());
  const fs::path& beside = part.path();
  if (auto written = guarded(beside, named, write); !written) return written;
  for (const auto& file : fs::recursive_directory_iterator(beside, error))
    if (file.is_regular_file() && !flushToDisk(file.path()))
      return fail("Could not write " + named.string() + " to the disk.");
  if (error = putInPlace(beside, folder, superseded); error) return couldNotWrite(named, error);
  return {};
}

}  // namespace insonate
