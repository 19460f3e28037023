#pragma once

#include <minizip/unzip.h>

#include <array>
#include <filesystem>
#include <map>
#include <string>

namespace insonate::test {

/// The files in a ZIP file, by name; empty if the file cannot be read. Programs that include this header link minizip.
inline std::map<std::string, std::string> zipContent(const std::filesystem::path& file) {
  std::map<std::string, std::string> content;
  const unzFile zip = unzOpen64(file.c_str());
  if (!zip) return content;
  for (int found = unzGoToFirstFile(zip); found == UNZ_OK; found = unzGoToNextFile(zip)) {
    std::array<char, 256> name{};
    unzGetCurrentFileInfo64(zip, nullptr, name.data(), name.size() - 1, nullptr, 0, nullptr, 0);
    std::string& bytes = content[name.data()];
    if (unzOpenCurrentFile(zip) != UNZ_OK) continue;
    std::array<char, 4096> part{};
    for (int count = 0; (count = unzReadCurrentFile(zip, part.data(), part.size())) > 0;)
      bytes.append(part.data(), static_cast<std::size_t>(count));
    if (unzCloseCurrentFile(zip) != UNZ_OK) bytes = "(wrong checksum)";
  }
  unzClose(zip);
  return content;
}

}  // namespace insonate::test
