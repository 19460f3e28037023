#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace insonate::store {

/// One file of a ZIP file: `bytes`, which are compressed, or the content of `source`, which is stored as it is.
struct ZipEntry {
  std::string name{};  ///< path within the ZIP file, in ASCII
  std::string bytes{};
  std::filesystem::path source{};
};

/// Writes a ZIP file, readable by its owner alone; `time_us` is the date of its entries. Fails if a source cannot be
/// read or the file cannot be written; the file is then incomplete.
Result<void> writeZip(const std::filesystem::path& file, const std::vector<ZipEntry>& entries, std::int64_t time_us,
                      const Progress& progress);

}  // namespace insonate::store
