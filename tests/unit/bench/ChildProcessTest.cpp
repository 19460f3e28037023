#include "server/ChildProcess.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <vector>

namespace insonate::test {
namespace {

TEST(ChildProcess, ACommandInheritsNoFilesAndSockets) {
  std::vector<int> files;
  for (int i = 0; i < 100; ++i) files.push_back(::open("/dev/null", O_RDONLY));
  const auto done = bench::runInShell("test $(ls /proc/self/fd | wc -l) -lt 10");
  for (const int file : files) ::close(file);
  EXPECT_TRUE(done) << done.error().message;
}

TEST(ChildProcess, ACommandThatFailsIsNamed) {
  EXPECT_TRUE(bench::runInShell("true"));
  const auto failed = bench::runInShell("exit 3");
  ASSERT_FALSE(failed);
  EXPECT_EQ(failed.error().message, "The command failed: exit 3");
  EXPECT_FALSE(bench::runInShell("kill -9 $$"));
}

}  // namespace
}  // namespace insonate::test
