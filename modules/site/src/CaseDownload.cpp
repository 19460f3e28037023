#include "CaseMessages.h"

#include <insonate/cases/CaseListing.h>
#include <insonate/cases/CaseVersions.h>
#include <insonate/core/AtomicFile.h>
#include <insonate/site/CaseDownload.h>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <map>
#include <system_error>
#include <utility>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char *kIndex = "published.json", *kPart = ".part", *kDamaged = ".damaged";
/// Room that the download leaves to everything else on the disk.
constexpr std::int64_t kReserve_bytes = std::int64_t{500} << 20;
/// A case that does not fit its fingerprint is not downloaded again and again.
constexpr std::chrono::hours kPauseAfterDamage{24};

/// Lock on a folder, which ends with the program that holds it. File systems without locks have none.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    isOfAnother_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  }
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool isOfAnother() const { return isOfAnother_; }

 private:
  int file_;
  bool isOfAnother_ = false;
};

/// The id of the version that each title means; "" for a case that the server offers and that is not here yet.
using Index = std::map<std::string, std::string>;

Index readIndex(const fs::path& folder) {
  std::ifstream file(folder / kIndex);
  const json read = json::parse(file, nullptr, false);
  Index index;
  if (!read.is_object() || !read.contains("cases") || !read["cases"].is_object()) return index;
  for (const auto& [title, id] : read["cases"].items())
    if (const auto* text = id.get_ptr<const std::string*>(); text && (text->empty() || isCaseId(*text)))
      index.emplace(title, *text);
  return index;
}

Result<void> writeIndex(const fs::path& folder, const Index& index) {
  return writeAtomically(folder / kIndex,
                         json{{"cases", index}}.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

/// Tells whether a case is in the folder. A power failure can leave files that are too short.
bool isWhole(const fs::path& folder, const PublishedCase& offered) {
  std::error_code error;
  return std::ranges::all_of(offered.files, [&](const PublishedCase::File& file) {
    return fs::file_size(folder / offered.id / file.name, error) == static_cast<std::uint64_t>(file.size_bytes);
  });
}

/// Progress of one download over several files.
struct Count {
  const Progress& progress;
  std::string doing;
  std::int64_t done_bytes = 0, all_bytes = 1;

  bool add(std::int64_t bytes) {
    done_bytes += bytes;
    return report(progress, doing, static_cast<double>(done_bytes) / static_cast<double>(all_bytes));
  }
};

std::int64_t sizeOf(const fs::path& file) {
  std::error_code error;
  const auto size_bytes = fs::file_size(file, error);
  return error ? 0 : static_cast<std::int64_t>(size_bytes);
}

/// Downloads the missing bytes of a file. Returns a refusal of the server, else "".
Result<std::string> fetchFile(const SiteLink& server, const std::string& id, const PublishedCase::File& file,
                              const fs::path& to, Count& count) {
  std::int64_t size_bytes = sizeOf(to);
  if (size_bytes > file.size_bytes) size_bytes = 0;
  std::ofstream out(to, size_bytes > 0 ? std::ios::binary | std::ios::app : std::ios::binary | std::ios::trunc);
  if (!count.add(size_bytes)) return fail(std::string(kCancelled));
  while (size_bytes < file.size_bytes) {
    const auto part =
        server.send("case-files/" + id + '/' + file.name + '/' + std::to_string(size_bytes), std::string());
    if (!part) return tl::unexpected(part.error());
    if (part->isRefusal) return part->text;
    const auto bytes = static_cast<std::int64_t>(part->text.size());
    if (bytes == 0 || size_bytes + bytes > file.size_bytes)
      return "The server sent another number of bytes of '" + file.name + "' than it announced.";
    if (!out.write(part->text.data(), bytes).flush())
      return "Check the free space and the permissions of " + to.parent_path().string() + ".";
    size_bytes += bytes;
    if (!count.add(bytes)) return fail(std::string(kCancelled));
  }
  return std::string();
}

/// Tells whether the files in a folder are the offered case.
bool isOffered(const fs::path& folder, const PublishedCase& offered) {
  const auto read = readCase(folder);
  if (!read) return false;
  const CaseVersion& version = read->patient.manifest.version;
  return caseId(read->patient.manifest.title, version.content) == offered.id &&
         version.voxels == voxelHashOf(read->patient) && version.content == contentHashOf(read->patient);
}

/// Moves the complete files to their place, so that each is on the disk before the folder has its name.
Result<void> moveToPlace(const fs::path& part, const fs::path& place) {
  auto moved = writeFolderAtomically(place, [&](const fs::path& beside) -> Result<void> {
    for (const std::string& name : caseFileNames()) {
      std::error_code error;
      if (fs::exists(part / name, error)) fs::rename(part / name, beside / name, error);
      if (error) return fail(error.message() + ".");
    }
    return {};
  });
  std::error_code ignored;
  fs::remove_all(part, ignored);
  return moved;
}

/// Describes an offer; a new copy of the files on the server makes another offer.
std::string offerText(const PublishedCase& offered) {
  return caseListText({offered});
}

/// Tells whether the same offer was downloaded a short while ago and did not fit its fingerprint.
bool wasDamaged(const fs::path& marker, const PublishedCase& offered) {
  std::error_code error;
  const auto time = fs::last_write_time(marker, error);
  if (error || fs::file_time_type::clock::now() - time > kPauseAfterDamage) return false;
  std::ifstream file(marker);
  return std::string(std::istreambuf_iterator<char>(file), {}) == offerText(offered);
}

std::string damageSentence(const PublishedCase& offered) {
  return "The case '" + offered.title +
         "' from the server does not fit its fingerprint. Ask the server's administrator to copy the case to the "
         "server "
         "again.";
}

/// Returns why there is no room for the missing bytes of a case; "" if there is.
std::string whyNoRoom(const PublishedCase& offered, const fs::path& part) {
  std::int64_t missing_bytes = offered.size_bytes();
  for (const PublishedCase::File& file : offered.files) missing_bytes -= sizeOf(part / file.name);
  std::error_code error;
  const fs::space_info space = fs::space(part.parent_path(), error);
  if (error || static_cast<std::int64_t>(space.available) >= missing_bytes + kReserve_bytes) return {};
  return "There is too little free space for the case '" + offered.title + "'. Free " +
         std::to_string((missing_bytes + kReserve_bytes) / 1'000'000 + 1) + " MB on the disk of " +
         part.parent_path().string() + ".";
}

/// Downloads a case to its folder. Returns the reason, with what to do, if the case cannot be used now, else "".
Result<std::string> fetchCase(const SiteLink& server, const PublishedCase& offered, const fs::path& folder,
                              const Progress& progress) {
  const fs::path part = folder / (offered.id + kPart), marker = folder / (offered.id + kDamaged);
  if (wasDamaged(marker, offered)) return damageSentence(offered);
  if (std::string why = whyNoRoom(offered, part); !why.empty()) return why;
  std::error_code error;
  fs::create_directories(part, error);
  Count count{progress, "Downloading the case '" + offered.title + "'", 0, offered.size_bytes()};
  for (const PublishedCase::File& file : offered.files) {
    auto refused = fetchFile(server, offered.id, file, part / file.name, count);
    if (!refused) return refused;
    if (!refused->empty()) return "The case '" + offered.title + "' was not downloaded. " + *refused;
  }
  if (!isOffered(part, offered)) {
    fs::remove_all(part, error);
    if (auto written = writeAtomically(marker, offerText(offered)); !written) return written.error().message;
    return damageSentence(offered);
  }
  fs::remove(marker, error);
  const auto moved = moveToPlace(part, folder / offered.id);
  return moved ? std::string() : "The case '" + offered.title + "' was not stored. " + moved.error().message;
}

/// Parts of versions that the server does not offer any more are never completed.
void removeOldParts(const fs::path& folder, const std::vector<PublishedCase>& offered) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const fs::path name = entry->path().filename();
    const std::string id = name.stem().string();
    const bool isOurs = isCaseId(id) && (name.extension() == kPart || name.extension() == kDamaged);
    if (isOurs && std::ranges::find(offered, id, &PublishedCase::id) == offered.end()) old.push_back(entry->path());
  }
  for (const fs::path& path : old) fs::remove_all(path, error);
}

Result<std::vector<PublishedCase>> offeredBy(const SiteLink& server, const std::vector<std::string>& titles) {
  const auto list = server.send("cases", std::string());
  if (!list) return tl::unexpected(list.error());
  if (list->isRefusal) return fail(list->text);
  auto offered = readCaseList(list->text);
  if (!offered) return offered;
  std::erase_if(*offered,
                [&](const PublishedCase& one) { return std::ranges::find(titles, one.title) == titles.end(); });
  return offered;
}

/// Makes the folder, which only its owner may read. An existing folder stays as it is.
Result<void> makePrivateFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::create_directories(folder, error)) fs::permissions(folder, fs::perms::owner_all, error);
  if (error) return fail("The folder for cases, " + folder.string() + ", cannot be made: " + error.message() + ".");
  return {};
}

/// Cases that are not complete yet keep their former version.
Index indexOf(const fs::path& folder, const std::vector<PublishedCase>& offered, const Index& before) {
  Index index;
  for (const PublishedCase& one : offered) {
    const auto former = before.find(one.title);
    index[one.title] = isWhole(folder, one) ? one.id : former == before.end() ? std::string() : former->second;
  }
  return index;
}

}  // namespace

Result<CaseDownloadReport> downloadCases(const SiteLink& server, const std::vector<std::string>& titles,
                                         const fs::path& folder, const Progress& progress) {
  const auto offered = offeredBy(server, titles);
  if (!offered) return tl::unexpected(offered.error());
  if (auto made = makePrivateFolder(folder); !made) return tl::unexpected(made.error());
  const FolderLock lock(folder);
  if (lock.isOfAnother()) return fail("Another program is downloading cases to " + folder.string() + ".");
  Index index = readIndex(folder);
  const auto renewIndex = [&]() -> Result<void> {
    Index now = indexOf(folder, *offered, index);
    return now == std::exchange(index, now) ? Result<void>() : writeIndex(folder, now);
  };
  removeOldParts(folder, *offered);
  if (auto written = renewIndex(); !written) return tl::unexpected(written.error());
  CaseDownloadReport result;
  for (const PublishedCase& one : *offered) {
    if (isWhole(folder, one)) continue;
    auto trouble = fetchCase(server, one, folder, progress);
    if (!trouble) return tl::unexpected(trouble.error());
    if (trouble->empty())
      result.titles.push_back(one.title);
    else
      result.errors.push_back(std::move(*trouble));
    if (auto written = renewIndex(); !written) return tl::unexpected(written.error());
  }
  return result;
}

DownloadState downloadStateOf(const fs::path& folder, const std::string& title) {
  const Index index = readIndex(folder);
  const auto known = index.find(title);
  if (known == index.end()) return {};
  std::error_code error;
  if (known->second.empty() || !fs::is_directory(folder / known->second, error)) return {.isExpected = true};
  return {.isExpected = true, .place = folder / known->second};
}

std::optional<fs::path> downloadedVersion(const fs::path& folder, const std::string& voxelHash) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (isCaseId(entry->path().filename().string()))
      if (auto found = findVersion(entry->path(), voxelHash)) return found;
  return std::nullopt;
}

std::vector<fs::path> downloadedCases(const fs::path& folder) {
  std::vector<fs::path> places;
  for (const auto& [title, id] : readIndex(folder))
    if (const auto place = downloadStateOf(folder, title).place) places.push_back(*place);
  return places;
}

}  // namespace insonate
