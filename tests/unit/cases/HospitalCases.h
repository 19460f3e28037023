#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::test {

/// A folder as hospitals send them.
struct HospitalCase {
  std::string name;
  void (*write)(const std::filesystem::path& folder);
};

const std::vector<HospitalCase>& hospitalCases();

}  // namespace insonate::test
