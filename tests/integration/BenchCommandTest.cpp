#include "integration/CommandLine.h"
#include "support/TestData.h"

#include <gmock/gmock.h>

#include <fstream>

namespace insonate::test {
namespace {

using testing::HasSubstr;

TEST(BenchCommand, RefusesFoldersThatCannotBeBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt";
  const std::string missing = folder.path() / "none" / "bench";
  const CommandResult noParent = runCommand("bench ultrasound --json --out " + shellWord(missing), errors);
  EXPECT_EQ(noParent.status, 1);
  EXPECT_THAT(noParent.errors, HasSubstr("does not exist"));
  EXPECT_THAT(noParent.output, HasSubstr("\"error\": "));
  EXPECT_FALSE(std::filesystem::exists(folder / "none"));

  std::ofstream(folder / "file") << "text";
  const CommandResult aFile = runCommand("bench ultrasound --out " + shellWord(folder / "file"), errors);
  EXPECT_EQ(aFile.status, 1);
  EXPECT_THAT(aFile.errors, HasSubstr("is a file"));
  EXPECT_EQ(runCommand("bench deformation --out " + shellWord(folder / "file"), errors).status, 1);
}

TEST(BenchCommand, WrongUsage) {
  const TemporaryFolder folder;
  const std::string errors = folder / "errors.txt";
  EXPECT_EQ(runCommand("bench", errors).status, 2);
  EXPECT_EQ(runCommand("bench ultrasound", errors).status, 2);
  EXPECT_EQ(runCommand("bench ultrasound --out x --fast", errors).status, 2);
}

}  // namespace
}  // namespace insonate::test
