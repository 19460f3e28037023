#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace insonate {

/// Returns the text of a field in an NRRD header; empty if the field is missing.
inline std::string nrrdField(const std::filesystem::path& file, const std::string& name) {
  std::ifstream in(file, std::ios::binary);
  for (std::string line; std::getline(in, line) && !line.empty() && line != "\r";) {
    if (!line.starts_with(name + ":")) continue;
    const std::size_t first = line.find_first_not_of(" \t", name.size() + 1);
    const std::size_t last = line.find_last_not_of(" \t\r");
    return first == std::string::npos ? std::string{} : line.substr(first, last - first + 1);
  }
  return {};
}

}  // namespace insonate
