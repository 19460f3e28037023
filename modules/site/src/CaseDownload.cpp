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
#include <fstream>
#include <map>
#include <system_error>

namespace insonate {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char *kIndex = "published.json", *kPart = ".part";
/// Room that the download leaves to everything else on the disk.
constexpr std::int64_t kReserve_bytes = std::int64_t{500} << 20;

/// Lock on a folder, which ends with the program that holds it.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder) : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    isHeld_ = file_ >= 0 && ::flock(file_, LOCK_EX | LOCK_NB) == 0;
  }
  ~FolderLock() {
    if (file_ >= 0) ::close(file_);
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  bool isHeld() const { return isHeld_; }

 private:
  int file_;
  bool isHeld_ = false;
};

/// The id of the version that each title means.
using Index = std::map<std::string, std::string>;

Index readIndex(const fs::path& folder) {
  std::ifstream file(folder / kIndex);
  const json read = json::parse(file, nullptr, false);
  Index index;
  if (!read.is_object() || !read.contains("cases") || !read["cases"].is_object()) return index;
  for (const auto& [title, id] : read["cases"].items())
    if (id.is_string() && isCaseId(id.get_ref<const std::string&>())) index.emplace(title, id);
  return index;
}

Result<void> writeIndex(const fs::path& folder, const Index& index) {
  return writeAtomically(folder / kIndex,
                         json{{"cases", index}}.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

bool isComplete(const fs::path& folder, const std::string& id) {
  std::error_code error;
  return fs::is_directory(folder / id, error);
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

/// Downloads the missing bytes of a file. Returns a refusal of the server, else "".
Result<std::string> fetchFile(const SiteLink& server, const std::string& id, const PublishedCase::File& file,
                              const fs::path& to, Count& count) {
  std::error_code error;
  auto size_bytes = static_cast<std::int64_t>(fs::file_size(to, error));
  if (error || size_bytes > file.size_bytes) size_bytes = 0;
  std::ofstream out(to, size_bytes > 0 ? std::ios::binary | std::ios::app : std::ios::binary | std::ios::trunc);
  if (!count.add(size_bytes)) return fail(std::string(kCancelled));
  while (size_bytes < file.size_bytes) {
    const auto part = server.ask(kCaseFiles + id + '/' + file.name + '/' + std::to_string(size_bytes), std::string());
    if (!part) return tl::unexpected(part.error());
    if (part->isRefusal) return part->text;
    const auto bytes = static_cast<std::int64_t>(part->text.size());
    if (bytes == 0 || size_bytes + bytes > file.size_bytes)
      return "The server sent a part of '" + file.name + "' that does not fit.";
    if (!out.write(part->text.data(), bytes).flush())
      return fail("A case cannot be written to " + to.string() + ". Check the free space and the permissions.");
    size_bytes += bytes;
    if (!count.add(bytes)) return fail(std::string(kCancelled));
  }
  return std::string();
}

/// Returns why the downloaded files are not the offered case; "" if they are.
std::string whyNotWhole(const fs::path& part, const PublishedCase& offered) {
  const auto read = readCase(part);
  if (!read) return read.error().message;
  const CaseVersion& version = read->patient.manifest.version;
  const bool isSame = caseId(read->patient.manifest.title, version.content) == offered.id &&
                      version.voxels == voxelHashOf(read->patient) && version.content == contentHashOf(read->patient);
  return isSame ? std::string() : "Its content differs from its fingerprint.";
}

/// Downloads a case into its folder. Returns a sentence if this case cannot be had now, else "".
Result<std::string> fetchCase(const SiteLink& server, const PublishedCase& offered, const fs::path& folder,
                              const Progress& progress) {
  const fs::path part = folder / (offered.id + kPart);
  std::error_code error;
  const fs::space_info space = fs::space(folder, error);
  if (!error && static_cast<std::int64_t>(space.available) < offered.size_bytes() + kReserve_bytes)
    return "There is not enough free space for the case '" + offered.title + "'.";
  fs::create_directories(part, error);
  Count count{progress, "Downloading the case '" + offered.title + "'", 0,
              std::max(std::int64_t{1}, offered.size_bytes())};
  for (const PublishedCase::File& file : offered.files) {
    auto refused = fetchFile(server, offered.id, file, part / file.name, count);
    if (!refused) return refused;
    if (!refused->empty()) return "The case '" + offered.title + "' was not downloaded. " + *refused;
  }
  if (const std::string why = whyNotWhole(part, offered); !why.empty()) {
    fs::remove_all(part, error);
    return "The case '" + offered.title + "' did not arrive intact, and is downloaded again later. " + why;
  }
  fs::rename(part, folder / offered.id, error);
  if (error) return fail("A case cannot be moved to " + (folder / offered.id).string() + ": " + error.message() + ".");
  return std::string();
}

/// Parts of versions that the server does not offer any more are never completed.
void removeOldParts(const fs::path& folder, const std::vector<PublishedCase>& offered) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const fs::path name = entry.path().filename();
    const bool isOffered =
        std::ranges::any_of(offered, [&](const PublishedCase& one) { return one.id == name.stem().string(); });
    if (name.extension() == kPart && !isOffered) fs::remove_all(entry.path(), error);
  }
}

Result<std::vector<PublishedCase>> offeredBy(const SiteLink& server, const std::vector<std::string>& titles) {
  const auto list = server.ask(kCaseList, std::string());
  if (!list) return tl::unexpected(list.error());
  if (list->isRefusal) return fail(list->text);
  auto offered = readCaseList(list->text);
  if (!offered) return offered;
  std::erase_if(*offered,
                [&](const PublishedCase& one) { return std::ranges::find(titles, one.title) == titles.end(); });
  // The first case of a title is the one that counts.
  const auto rest = std::ranges::unique(*offered, {}, &PublishedCase::title);
  offered->erase(rest.begin(), rest.end());
  return offered;
}

Result<void> makePrivateFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) fs::permissions(folder, fs::perms::owner_all, error);
  if (error) return fail("The folder for cases, " + folder.string() + ", cannot be made: " + error.message() + ".");
  return {};
}

}  // namespace

Result<CaseDownloadReport> downloadCases(const SiteLink& server, const std::vector<std::string>& titles,
                                         const fs::path& folder, const Progress& progress) {
  const auto offered = offeredBy(server, titles);
  if (!offered) return tl::unexpected(offered.error());
  if (auto made = makePrivateFolder(folder); !made) return tl::unexpected(made.error());
  const FolderLock lock(folder);
  if (!lock.isHeld()) return fail("Another program is downloading cases to " + folder.string() + ".");
  const Index before = readIndex(folder);
  Index index;
  CaseDownloadReport result;
  removeOldParts(folder, *offered);
  for (const PublishedCase& one : *offered) {
    if (!isComplete(folder, one.id)) {
      auto trouble = fetchCase(server, one, folder, progress);
      if (!trouble) return tl::unexpected(trouble.error());
      if (trouble->empty())
        result.titles.push_back(one.title);
      else
        result.troubles.push_back(std::move(*trouble));
    }
    const auto former = before.find(one.title);
    if (isComplete(folder, one.id))
      index[one.title] = one.id;
    else if (former != before.end())
      index.insert(*former);
  }
  if (index != before)
    if (auto written = writeIndex(folder, index); !written) return tl::unexpected(written.error());
  return result;
}

std::optional<fs::path> downloadedCase(const fs::path& folder, const std::string& title) {
  const Index index = readIndex(folder);
  const auto known = index.find(title);
  if (known == index.end() || !isComplete(folder, known->second)) return std::nullopt;
  return folder / known->second;
}

std::optional<fs::path> downloadedVersion(const fs::path& folder, const std::string& voxelHash) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error))
    if (isCaseId(entry.path().filename().string()))
      if (const auto found = findVersion(entry.path(), voxelHash)) return found;
  return std::nullopt;
}

std::vector<std::string> downloadedTitles(const fs::path& folder) {
  std::vector<std::string> titles;
  for (const auto& [title, id] : readIndex(folder)) titles.push_back(title);
  return titles;
}

}  // namespace insonate
