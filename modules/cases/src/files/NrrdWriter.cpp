#include "NrrdWriter.h"

#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <charconv>

namespace insonate {
namespace {

static_assert(std::endian::native == std::endian::little, "the header says little endian");

std::string vectorOf(Vec3 v) {
  return "(" + exactDecimal(v.x) + "," + exactDecimal(v.y) + "," + exactDecimal(v.z) + ")";
}

std::string headerText(const VolumeGeometry& g, const std::string& type,
                       const std::vector<std::pair<std::string, std::string>>& fields) {
  std::string text = "NRRD0005\ntype: " + type + "\ndimension: 3\nspace: left-posterior-superior\nsizes:";
  for (int n : g.size) text += " " + std::to_string(n);
  text += "\nspace directions:";
  for (int a = 0; a < 3; ++a) text += " " + vectorOf(g.direction.column[a] * g.spacing_mm[a]);
  text +=
      "\nkinds: domain domain domain\nendian: little\nencoding: gzip\nspace origin: " + vectorOf(g.origin_mm) + "\n";
  for (const auto& [key, value] : fields) text += key + ":=" + value + "\n";
  return text + "\n";
}

bool writeAll(int fd, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t n = ::write(fd, text.data() + done, text.size() - done);
    if (n <= 0) return false;
    done += static_cast<std::size_t>(n);
  }
  return true;
}

enum class Deflated { kDone, kCancelled, kFailed };

// Level 1 is twice as fast on CT as the default, with files a few percent larger. Takes ownership of fd.
Deflated deflateAll(int fd, std::span<const std::byte> voxels, const Progress& progress) {
  gzFile gz = ::gzdopen(fd, "wb1");
  if (!gz) {
    ::close(fd);
    return Deflated::kFailed;
  }
  constexpr std::size_t kChunk = 1U << 24;  // compressed in a fraction of a second, after which cancellation is checked
  bool ok = true, goOn = true;
  for (std::size_t done = 0; ok && done < voxels.size(); done += kChunk) {
    goOn = report(progress, "Writing the case", static_cast<double>(done) / static_cast<double>(voxels.size()));
    if (!goOn) break;
    const auto part = voxels.subspan(done, std::min(kChunk, voxels.size() - done));
    ok = ::gzwrite(gz, part.data(), static_cast<unsigned>(part.size())) == static_cast<int>(part.size());
  }
  ok = ::gzclose(gz) == Z_OK && ok;
  return !goOn ? Deflated::kCancelled : ok ? Deflated::kDone : Deflated::kFailed;
}

}  // namespace

std::string exactDecimal(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

Result<void> writeNrrd(const std::filesystem::path& file, const VolumeGeometry& geometry, const std::string& type,
                       std::span<const std::byte> voxels,
                       const std::vector<std::pair<std::string, std::string>>& fields, const Progress& progress) {
  const auto refuse = [&] {
    return fail("Could not write " + file.string() +
                ": the disk is full or the folder cannot be written. Free space or choose another folder.");
  };
  const int fd = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (fd < 0) return refuse();
  if (!writeAll(fd, headerText(geometry, type, fields))) {
    ::close(fd);
    return refuse();
  }
  switch (deflateAll(fd, voxels, progress)) {
    case Deflated::kDone:
      return {};
    case Deflated::kCancelled:
      return fail(std::string(kCancelled));
    case Deflated::kFailed:
      break;
  }
  return refuse();
}

}  // namespace insonate
