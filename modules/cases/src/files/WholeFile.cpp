#include "WholeFile.h"

#include <zlib.h>

#include <algorithm>
#include <string>
#include <vector>

namespace insonate {
namespace fs = std::filesystem;

struct GzipReader::File {
  gzFile gz = nullptr;  ///< zlib passes files through that are not compressed
  ~File() {
    if (gz) ::gzclose(gz);
  }
};

GzipReader::GzipReader(const fs::path& file) : file_(new File{::gzopen(file.c_str(), "rb")}) {
  if (file_->gz) ::gzbuffer(file_->gz, 1U << 18);
}

GzipReader::~GzipReader() = default;

std::size_t GzipReader::read(std::span<char> bytes) {
  constexpr std::size_t kMost = 1U << 30;
  std::size_t done = 0;
  while (file_->gz && done < bytes.size()) {
    const int n = ::gzread(file_->gz, bytes.data() + done, static_cast<unsigned>(std::min(bytes.size() - done, kMost)));
    if (n <= 0) break;
    done += static_cast<std::size_t>(n);
  }
  return done;
}

bool GzipReader::skip(std::size_t count) {
  std::vector<char> buffer(std::min<std::size_t>(count, 1U << 18));
  while (count > 0) {
    const std::size_t n = read({buffer.data(), std::min(count, buffer.size())});
    if (n == 0) return false;
    count -= n;
  }
  return true;
}

bool GzipReader::broken() const {
  int error = Z_OK;
  if (file_->gz) ::gzerror(file_->gz, &error);
  return error != Z_OK;
}

HeldBytes decompressedBytes(const fs::path& file) {
  GzipReader in(file);
  std::vector<char> buffer(1U << 18);
  HeldBytes held;
  while (const std::size_t n = in.read(buffer)) held.count += static_cast<double>(n);
  held.streamBreaks = in.broken();
  return held;
}

Result<void> checkHeld(const fs::path& file, double promised_bytes, HeldBytes held) {
  if (held.count >= promised_bytes && !held.streamBreaks) return {};
  const auto amount = [](double bytes) { return std::to_string(static_cast<unsigned long long>(bytes)) + " bytes"; };
  return fail("Could not read " + file.string() + ": it is cut off or damaged; " +
              (held.count < promised_bytes
                   ? "its header promises " + amount(promised_bytes) + ", it holds " + amount(held.count)
                   : std::string("its compressed stream breaks off")) +
              ". Copy or export it again.");
}

}  // namespace insonate
