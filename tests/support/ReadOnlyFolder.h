#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace insonate::test {

/// Makes a folder and the files in it readable but not writable, until the object is destroyed. A test that root runs
/// goes on as another user, since root may write everything.
class ReadOnlyFolder {
 public:
  explicit ReadOnlyFolder(const std::filesystem::path& folder) : folder_(folder) {
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file()) std::filesystem::permissions(entry, std::filesystem::perms(0444));
    std::filesystem::permissions(folder, std::filesystem::perms(0555));
    if (isRoot_) {
      EXPECT_EQ(::seteuid(kAnotherUser), 0);
    }
  }
  ~ReadOnlyFolder() {
    if (isRoot_) {
      EXPECT_EQ(::seteuid(0), 0);
    }
    std::error_code ignored;
    std::filesystem::permissions(folder_, std::filesystem::perms(0755), ignored);
  }
  ReadOnlyFolder(const ReadOnlyFolder&) = delete;
  ReadOnlyFolder& operator=(const ReadOnlyFolder&) = delete;

 private:
  static constexpr uid_t kAnotherUser = 65534;
  const std::filesystem::path folder_;
  const bool isRoot_ = ::geteuid() == 0;
};

}  // namespace insonate::test
