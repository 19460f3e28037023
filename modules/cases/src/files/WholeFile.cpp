#include "WholeFile.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace insonate {
namespace fs = std::filesystem;
namespace {

struct GzipCloser {
  void operator()(gzFile file) const { ::gzclose(file); }
};
using Gzip = std::unique_ptr<std::remove_pointer_t<gzFile>, GzipCloser>;

/// zlib passes files through that are not compressed.
Gzip openGzip(const fs::path& file) {
  Gzip gz(::gzopen(file.c_str(), "rb"));
  if (gz) ::gzbuffer(gz.get(), 1U << 18);
  return gz;
}

/// Reads to the end, where the check sum stands.
HeldBytes decompressedBytes(const fs::path& file) {
  const Gzip gz = openGzip(file);
  if (!gz) return {};
  std::vector<char> buffer(1U << 18);
  HeldBytes held;
  int n = 0;
  while ((n = ::gzread(gz.get(), buffer.data(), static_cast<unsigned>(buffer.size()))) > 0) held.count += n;
  int error = Z_OK;
  ::gzerror(gz.get(), &error);
  held.streamBreaks = error != Z_OK;
  return held;
}

template <class T>
T numberAt(const std::string& header, std::size_t offset, bool swapped) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), header.data() + offset, sizeof(T));
  if (swapped) std::ranges::reverse(bytes);
  return std::bit_cast<T>(bytes);
}

}  // namespace

std::optional<NiftiHeader> readNiftiHeader(const fs::path& file) {
  constexpr std::int32_t kSize1 = 348, kSize2 = 540;
  const Gzip gz = openGzip(file);
  std::string header(kSize2, '\0');
  if (!gz || ::gzread(gz.get(), header.data(), kSize2) < kSize1) return std::nullopt;
  const auto isSize = [](std::int32_t size) { return size == kSize1 || size == kSize2; };
  const bool swapped = !isSize(numberAt<std::int32_t>(header, 0, false));
  const std::int32_t size = numberAt<std::int32_t>(header, 0, swapped);
  if (!isSize(size)) return std::nullopt;
  const bool second = size == kSize2;
  // NIfTI-1 and -2 hold the same fields at other offsets and in other widths (nifti.nimh.nih.gov, nifti1.h, nifti2.h).
  const auto dimension = [&](int n) -> double {
    return second ? static_cast<double>(numberAt<std::int64_t>(header, 16 + 8 * n, swapped))
                  : numberAt<std::int16_t>(header, 40 + 2 * n, swapped);
  };
  double voxels = 1;
  for (int n = 1; n <= std::min(dimension(0), 7.0); ++n) voxels *= std::max(dimension(n), 1.0);
  const double bits = numberAt<std::int16_t>(header, second ? 14 : 72, swapped);
  const double offset = second ? static_cast<double>(numberAt<std::int64_t>(header, 168, swapped))
                               : numberAt<float>(header, 108, swapped);
  const int qform =
      second ? numberAt<std::int32_t>(header, 344, swapped) : numberAt<std::int16_t>(header, 252, swapped);
  const int sform =
      second ? numberAt<std::int32_t>(header, 348, swapped) : numberAt<std::int16_t>(header, 254, swapped);
  return NiftiHeader{std::max(offset, double(size)) + voxels * bits / 8, qform > 0 || sform > 0};
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

Result<void> checkWholeNifti(const fs::path& file, const NiftiHeader& header) {
  return checkHeld(file, header.promised_bytes, decompressedBytes(file));
}

}  // namespace insonate
