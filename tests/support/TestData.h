#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace insonate::test {

/// A folder of real data outside the repository: INSONATE_TEST_DATA, by default ../shared/data beside the checkout.
inline std::filesystem::path testData(const std::string& name) {
  const char* root = std::getenv("INSONATE_TEST_DATA");
  return (root ? std::filesystem::path(root) : std::filesystem::path(INSONATE_SOURCE_DIR) / "../shared/data") / name;
}

/// A fresh folder that is removed with its contents when the object goes.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "insonate-test-XXXXXX").string();
    if (!::mkdtemp(name.data())) ADD_FAILURE() << "no temporary folder";
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace insonate::test

/// Skips the test, visibly, where the real data is not there.
#define INSONATE_NEEDS_DATA(name)                               \
  if (!std::filesystem::exists(insonate::test::testData(name))) \
  GTEST_SKIP() << "no test data " << insonate::test::testData(name)
