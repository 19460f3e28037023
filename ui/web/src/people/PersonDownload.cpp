#include "people/PersonDownload.h"

#include "people/Accounts.h"
#include "people/DownloadSlots.h"

#include <insonate/curriculum/PersonData.h>

#include <QUuid>
#include <chrono>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

namespace insonate::web {
namespace {

namespace fs = std::filesystem;

/// A file that exists only while its answer is sent. It lies beside the recordings, whose disk has room for them.
class TemporaryDownload {
 public:
  TemporaryDownload(const CurriculumStore& store, std::shared_ptr<const void> slot) : slot_(std::move(slot)) {
    std::error_code error;
    const fs::path folder = store.recordings().empty() ? fs::temp_directory_path(error) / "insonate-downloads"
                                                       : fs::absolute(store.recordings()).parent_path() / "downloads";
    fs::create_directory(folder, error);
    fs::permissions(folder, fs::perms::owner_all, error);
    removeAbandoned(folder);
    path_ = folder / (QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString() + ".zip");
  }
  ~TemporaryDownload() {
    std::error_code error;
    fs::remove(path_, error);
  }
  TemporaryDownload(const TemporaryDownload&) = delete;
  TemporaryDownload& operator=(const TemporaryDownload&) = delete;

  const fs::path& path() const { return path_; }

 private:
  /// Removes the files of a server that was killed.
  static void removeAbandoned(const fs::path& folder) {
    std::error_code error;
    const auto yesterday = fs::file_time_type::clock::now() - std::chrono::hours(24);
    for (const auto& entry : fs::directory_iterator(folder, error))
      if (entry.path().extension() == ".zip" && entry.last_write_time(error) < yesterday)
        fs::remove(entry.path(), error);
  }

  std::shared_ptr<const void> slot_;
  fs::path path_;
};

constexpr const char* kUnwritten =
    "The server could not write the file with the data. Ask an administrator whether its disk is full.";

/// Paths of the server are not for users.
Response refusalOf(const Visit& visit, const std::string& sentence, const fs::path& file) {
  const bool hasPath = sentence.find(file.parent_path().parent_path().string()) != std::string::npos;
  return hasPath ? refusal(visit, 503, kUnwritten) : refusal(visit, 403, sentence);
}

Response sendData(const Visit& visit, const std::string& person) {
  auto slot = visit.downloads.take(person);
  if (!slot) return refusal(visit, 429, slot.error().message);
  const auto file = std::make_shared<const TemporaryDownload>(visit.store, *std::move(slot));
  // The disk also has to take the recordings that arrive meanwhile.
  const auto written = PersonData(*visit.by).exportTo(person, file->path(), {}, 2);
  std::error_code error;
  const std::uintmax_t size_bytes = written ? fs::file_size(file->path(), error) : 0;
  if (!written) return refusalOf(visit, written.error().message, file->path());
  if (error) return refusal(visit, 503, kUnwritten);
  Response response = download("personal-data.zip", "application/zip", {});
  response.file = file->path(), response.fileSize = size_bytes, response.fileOwner = file;
  return response;
}

}  // namespace

Markup downloadSection(const Visit& visit, const std::string& person) {
  const bool isOwn = person == visit.by->person().id;
  return section("Personal data",
                 note(isOwn ? "A ZIP file with everything that this server stores about you: account, classes, "
                              "attempts, recordings, comments, forms, sessions and log entries."
                            : "A ZIP file with everything that this server stores about the person: account, classes, "
                              "attempts, recordings, comments, forms, sessions and log entries.") +
                     postForm(visit, isOwn ? "/me/data" : accountAddress(person) + "/data", {},
                              isOwn ? "Download my data" : "Download data"));
}

Response downloadOwnData(const Visit& visit, const Parts& /*parts*/) {
  return sendData(visit, visit.by->person().id);
}

Response downloadPersonData(const Visit& visit, const Parts& parts) {
  return sendData(visit, parts[0]);
}

}  // namespace insonate::web
