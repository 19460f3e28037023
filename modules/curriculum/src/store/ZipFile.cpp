#include "store/ZipFile.h"

#include "store/sql/PrivateFile.h"

#include <minizip/zip.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <fstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace insonate::store {
namespace {

/// Above this size, an entry needs the format ZIP64.
constexpr std::uint64_t kLargestPlain_bytes = 0xFFFFFFFE;

zip_fileinfo infoOf(std::int64_t time_us) {
  const std::time_t seconds = time_us / 1'000'000;
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  zip_fileinfo info{};
  info.tmz_date.tm_sec = static_cast<unsigned>(parts.tm_sec),
  info.tmz_date.tm_min = static_cast<unsigned>(parts.tm_min);
  info.tmz_date.tm_hour = static_cast<unsigned>(parts.tm_hour);
  info.tmz_date.tm_mday = static_cast<unsigned>(parts.tm_mday);
  info.tmz_date.tm_mon = static_cast<unsigned>(parts.tm_mon);
  info.tmz_date.tm_year = static_cast<unsigned>(parts.tm_year + 1900);
  return info;
}

class ZipWriter {
 public:
  ZipWriter(const std::filesystem::path& file, std::int64_t time_us)
      : file_(file), info_(infoOf(time_us)), zip_(zipOpen64(file.c_str(), APPEND_STATUS_CREATE)) {}
  ~ZipWriter() {
    if (zip_) zipClose(zip_, nullptr);
  }
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  Result<void> put(const ZipEntry& entry) {
    if (!zip_) return unwritable();
    const bool isText = entry.source.empty();
    std::error_code error;
    const std::uint64_t size_bytes = isText ? entry.bytes.size() : std::filesystem::file_size(entry.source, error);
    if (error) return unreadable(entry);
    if (zipOpenNewFileInZip64(zip_, entry.name.c_str(), &info_, nullptr, 0, nullptr, 0, nullptr,
                              isText ? Z_DEFLATED : 0, Z_DEFAULT_COMPRESSION,
                              size_bytes > kLargestPlain_bytes ? 1 : 0) != ZIP_OK)
      return unwritable();
    if (auto done = isText ? putBytes(entry.bytes) : putSource(entry); !done) return done;
    return zipCloseFileInZip(zip_) == ZIP_OK ? Result<void>() : unwritable();
  }

  Result<void> close() {
    const zipFile zip = std::exchange(zip_, nullptr);
    return zip && zipClose(zip, nullptr) == ZIP_OK ? Result<void>() : unwritable();
  }

 private:
  Result<void> putBytes(std::string_view bytes) {
    constexpr std::size_t kPart = std::size_t{1} << 20;
    for (; !bytes.empty(); bytes.remove_prefix(std::min(kPart, bytes.size())))
      if (zipWriteInFileInZip(zip_, bytes.data(), static_cast<unsigned>(std::min(kPart, bytes.size()))) != ZIP_OK)
        return unwritable();
    return {};
  }

  Result<void> putSource(const ZipEntry& entry) {
    std::ifstream stream(entry.source, std::ios::binary);
    std::array<char, 65536> part;
    do {
      stream.read(part.data(), part.size());
      if (auto done = putBytes({part.data(), static_cast<std::size_t>(stream.gcount())}); !done) return done;
    } while (stream);
    return stream.eof() ? Result<void>() : unreadable(entry);
  }

  static Result<void> unreadable(const ZipEntry& entry) {
    return fail("The recording " + entry.source.string() + " cannot be read; check its permissions and try again.");
  }
  Result<void> unwritable() const {
    return fail("The file " + file_.string() +
                " could not be written: the disk is full or the folder cannot be written. Free space and try again.");
  }

  const std::filesystem::path file_;
  const zip_fileinfo info_;
  zipFile zip_;
};

}  // namespace

Result<void> writeZip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries, std::int64_t time_us,
                      const Progress& progress) {
  makePrivate(file);
  ZipWriter zip(file, time_us);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    if (!report(progress, "writing the data", static_cast<double>(i) / static_cast<double>(entries.size())))
      return fail(std::string(kCancelled));
    if (auto put = zip.put(entries[i]); !put) return put;
  }
  return zip.close();
}

}  // namespace insonate::store
