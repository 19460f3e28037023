#include "WholeFile.h"

#include <zlib.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace insonate {
namespace fs = std::filesystem;

struct GzipReader::File {
  gzFile gz = nullptr;  ///< zlib also reads uncompressed files
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

HeldBytes inflatedBytes(const fs::path& file, std::uint64_t offset) {
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(offset));
  z_stream stream{};
  constexpr int kZlibOrGzip = 47;
  HeldBytes held{0, true};
  if (::inflateInit2(&stream, kZlibOrGzip) != Z_OK) return held;
  std::vector<char> input(1U << 16), output(1U << 16);
  int state = Z_OK;
  while (state == Z_OK) {
    if (stream.avail_in == 0) {
      in.read(input.data(), static_cast<std::streamsize>(input.size()));
      stream.next_in = reinterpret_cast<Bytef*>(input.data());
      stream.avail_in = static_cast<uInt>(in.gcount());
      if (stream.avail_in == 0) break;
    }
    stream.next_out = reinterpret_cast<Bytef*>(output.data());
    stream.avail_out = static_cast<uInt>(output.size());
    state = ::inflate(&stream, Z_NO_FLUSH);
    held.count += static_cast<double>(output.size() - stream.avail_out);
  }
  ::inflateEnd(&stream);
  held.streamBreaks = state != Z_STREAM_END;
  return held;
}

double bytesFrom(const fs::path& file, std::uint64_t offset) {
  std::error_code error;
  const auto size = fs::file_size(file, error);
  return error || size < offset ? 0 : static_cast<double>(size - offset);
}

Result<void> checkHeld(const fs::path& file, double promised_bytes, HeldBytes held) {
  if (held.count >= promised_bytes && !held.streamBreaks) return {};
  const auto amount = [](double bytes) { return std::to_string(static_cast<unsigned long long>(bytes)) + " bytes"; };
  return fail("Could not read " + file.string() + ": it is cut off or damaged; " +
              (held.count < promised_bytes
                   ? "its header states " + amount(promised_bytes) + ", but it contains " + amount(held.count)
                   : std::string("its compressed data end too early")) +
              ". Copy or export it again.");
}

}  // namespace insonate
