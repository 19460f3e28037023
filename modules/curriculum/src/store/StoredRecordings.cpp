#include "store/StoredRecordings.h"

#include "store/sql/PrivateFile.h"

#include <insonate/core/AtomicFile.h>

#include <sodium/crypto_hash_sha256.h>
#include <sodium/utils.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <functional>
#include <string_view>
#include <vector>

namespace insonate::store {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = ".attempt";

using TakePart = std::function<void(const char* bytes, std::size_t count)>;

/// Passes the bytes of a file on, part by part. False if it cannot be read.
bool readParts(const fs::path& file, const TakePart& take) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 65536> part;
  do {
    stream.read(part.data(), part.size());
    take(part.data(), static_cast<std::size_t>(stream.gcount()));
  } while (stream);
  return stream.eof();
}

class Sha256 {
 public:
  Sha256() { crypto_hash_sha256_init(&state_); }
  void take(const char* bytes, std::size_t count) {
    crypto_hash_sha256_update(&state_, reinterpret_cast<const unsigned char*>(bytes), count);
  }
  std::string digits() {
    std::array<unsigned char, crypto_hash_sha256_BYTES> hash;
    crypto_hash_sha256_final(&state_, hash.data());
    std::array<char, 2 * crypto_hash_sha256_BYTES + 1> digits;
    return sodium_bin2hex(digits.data(), digits.size(), hash.data(), hash.size());
  }

 private:
  crypto_hash_sha256_state state_;
};

/// The recording while it arrives in parts.
fs::path partOf(const fs::path& whole) {
  return whole.string() + ".part";
}

/// Empty if the file cannot be read.
std::string hashOfFile(const fs::path& file) {
  Sha256 hash;
  return readParts(file, [&](const char* bytes, std::size_t count) { hash.take(bytes, count); }) ? hash.digits() : "";
}

/// Hashes the parts while it copies them, so that the file cannot change in between.
Result<void> copyHashed(const fs::path& from, const fs::path& to, const std::string& hash) {
  makePrivate(to);
  std::ofstream out(to, std::ios::binary | std::ios::trunc);
  Sha256 copied;
  const bool isRead = readParts(from, [&](const char* bytes, std::size_t count) {
    copied.take(bytes, count);
    out.write(bytes, static_cast<std::streamsize>(count));
  });
  out.close();
  if (!isRead) return fail("The recording " + from.string() + " cannot be read; check its permissions.");
  if (!out)
    return fail("The recording " + from.string() + " could not be copied to " + to.string() +
                ": the disk is full or the folder cannot be written. Free space and try again.");
  if (!hash.empty() && copied.digits() != hash)
    return fail("The recording " + from.string() + " was changed while it was read; try again.");
  return {};
}

Result<void> makeFolder(const fs::path& folder) {
  struct stat status {};
  if (::mkdir(folder.c_str(), S_IRWXU) == 0) return {};
  if (::stat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode))
    return fail("The folder " + folder.string() +
                " for recordings cannot be made; check that its parent folder exists and can be written.");
  if ((status.st_mode & 0077) != 0 && status.st_uid == ::geteuid()) (void)::chmod(folder.c_str(), S_IRWXU);
  return {};
}

}  // namespace

fs::path recordingsBeside(const fs::path& database) {
  return database.string() + ".recordings";
}

fs::path recordingsFolder(const Address& address, const fs::path& wanted) {
  if (!wanted.empty() || address.isServer) return wanted;
  return recordingsBeside(address.place());
}

fs::path storedRecording(const fs::path& folder, const std::string& attempt) {
  return folder / (attempt + std::string(kSuffix));
}

bool isRecordingKept(const fs::path& folder, const std::string& attempt) {
  std::error_code ignored;
  return !folder.empty() && fs::is_regular_file(storedRecording(folder, attempt), ignored);
}

void findRecording(StoredAttempt& kept, const fs::path& folder) {
  if (isRecordingKept(folder, kept.facts.id)) kept.recordingFile = storedRecording(folder, kept.facts.id);
}

std::int64_t sizeOfRecordings(const fs::path& folder, const std::vector<std::string>& attempts) {
  std::int64_t all_bytes = 0;
  for (const std::string& attempt : attempts)
    for (const fs::path& file : {storedRecording(folder, attempt), partOf(storedRecording(folder, attempt))}) {
      std::error_code isMissing;
      const std::uintmax_t size_bytes = fs::file_size(file, isMissing);
      if (!isMissing) all_bytes += static_cast<std::int64_t>(size_bytes);
    }
  return all_bytes;
}

Result<void> removeRecordings(const fs::path& folder, const std::vector<std::string>& attempts) {
  Result<void> done;
  if (folder.empty()) return done;
  for (const std::string& attempt : attempts)
    for (const fs::path& file : {storedRecording(folder, attempt), partOf(storedRecording(folder, attempt))}) {
      std::error_code error;
      fs::remove(file, error);
      if (error) done = fail("The recording " + file.string() + " could not be deleted: " + error.message() + ".");
    }
  return done;
}

Result<bool> storeRecording(const fs::path& folder, const std::string& attempt, const fs::path& file,
                            const std::string& hash) {
  if (auto made = makeFolder(folder); !made) return tl::unexpected(made.error());
  const fs::path kept = storedRecording(folder, attempt);
  std::error_code error;
  const bool isNew = !fs::exists(kept, error);
  if (!isNew && hashOfFile(kept) == hash) return false;
  auto copied = writeAtomically(kept, [&](const fs::path& beside) { return copyHashed(file, beside, hash); });
  if (!copied) return tl::unexpected(copied.error());
  return isNew;
}

namespace {

/// Makes a complete part the recording of the attempt, or removes one that has another content.
Result<ReceivedPart> takeWhole(const fs::path& part, const fs::path& whole, const std::string& attempt,
                               const std::string& hash, std::int64_t total_bytes) {
  std::error_code error;
  const bool isRight = static_cast<std::int64_t>(fs::file_size(part, error)) == total_bytes && hashOfFile(part) == hash;
  Result<void> kept =
      isRight ? writeAtomically(whole, [&](const fs::path& beside) { return copyHashed(part, beside, hash); })
              : Result<void>(fail("The recording of the attempt " + attempt +
                                  " did not arrive as it was sent, or was changed; it is sent again later."));
  if (kept || !isRight) fs::remove(part, error);
  if (!kept) return tl::unexpected(kept.error());
  return ReceivedPart{total_bytes, true};
}

}  // namespace

Result<ReceivedPart> receiveRecording(const fs::path& folder, const std::string& attempt, const std::string& hash,
                                      std::int64_t offset_bytes, std::int64_t total_bytes, std::string_view bytes) {
  constexpr std::int64_t kLargest_bytes = std::int64_t{256} << 20;
  if (folder.empty())
    return fail(
        "The server has no folder for recordings. An administrator must name such a folder and restart the server.");
  if (auto made = makeFolder(folder); !made) return tl::unexpected(made.error());
  const fs::path whole = storedRecording(folder, attempt), part = partOf(whole);
  std::error_code error;
  if (fs::exists(whole, error) && hashOfFile(whole) == hash)
    return ReceivedPart{static_cast<std::int64_t>(fs::file_size(whole, error)), true};
  makePrivate(part);
  const auto size = [&] { return static_cast<std::int64_t>(fs::file_size(part, error)); };
  const std::int64_t before = size();
  if (error) return fail("The server cannot store recordings: " + error.message() + ".");
  if (total_bytes > kLargest_bytes || before > total_bytes) {
    fs::remove(part, error);
    return fail("The recording of the attempt " + attempt +
                " is larger than stated, or than 256 MB, and was not stored.");
  }
  // A file that is complete was not yet taken when the server ended.
  if (before < total_bytes) {
    if (bytes.empty() || offset_bytes != before) return ReceivedPart{before, false};
    std::ofstream out(part, std::ios::binary | std::ios::app);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out) {
      fs::resize_file(part, static_cast<std::uintmax_t>(before), error);
      return fail(
          "The server's disk for recordings is full. Tell its administrator; the recording is sent again later.");
    }
    if (size() < total_bytes) return ReceivedPart{size(), false};
  }
  return takeWhole(part, whole, attempt, hash, total_bytes);
}

Result<void> copyRecordings(const fs::path& from, const fs::path& to, const Progress& progress) {
  std::error_code error;
  if (!fs::exists(from, error)) return {};
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(from, error))
    if (entry.path().extension() == kSuffix && entry.is_regular_file(error)) files.push_back(entry.path());
  if (error) return fail("The recordings in " + from.string() + " cannot be read: " + error.message() + ".");
  if (auto made = makeFolder(to); !made) return made;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (!report(progress, "copying recordings", static_cast<double>(i) / static_cast<double>(files.size())))
      return fail(std::string(kCancelled));
    const fs::path target = to / files[i].filename();
    if (fs::exists(target, error) && hashOfFile(target) == hashOfFile(files[i])) continue;
    auto copied = writeAtomically(target, [&](const fs::path& beside) { return copyHashed(files[i], beside, ""); });
    if (!copied) return copied;
  }
  return {};
}

}  // namespace insonate::store
