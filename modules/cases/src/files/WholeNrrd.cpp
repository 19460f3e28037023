#include "NrrdField.h"
#include "WholeFile.h"

#include <fstream>

namespace insonate {
namespace fs = std::filesystem;
namespace {

/// Offset of the voxels, after the first empty line.
std::uint64_t headerSizeOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line);)
    if (line.empty() || line == "\r") return static_cast<std::uint64_t>(in.tellg());
  return bytesFrom(file, 0);
}

}  // namespace

Result<void> checkWholeNrrd(const fs::path& file, double promised) {
  std::string other = nrrdField(file, "data file");
  if (other.empty()) other = nrrdField(file, "datafile");
  const bool severalFiles = other.starts_with("LIST") || other.find('%') != std::string::npos;
  if (severalFiles) return {};  // the reader states which of them is too short
  const fs::path data = other.empty() ? file : file.parent_path() / other;
  const std::uint64_t from = other.empty() ? headerSizeOf(file) : 0;
  const std::string encoding = nrrdField(file, "encoding");
  if (encoding == "gzip" || encoding == "gz") return checkHeld(file, promised, inflatedBytes(data, from));
  if (encoding == "raw") return checkHeld(file, promised, {bytesFrom(data, from), false});
  constexpr double kWidest = 8;  // bytes of the largest number type
  return checkHeld(file, promised, {kWidest * bytesFrom(data, from), false});
}

}  // namespace insonate
