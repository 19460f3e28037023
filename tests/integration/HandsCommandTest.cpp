#include "integration/CommandLine.h"
#include "support/TestData.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate::test {
namespace {

using testing::HasSubstr;

TEST(HandsCommand, WritesTheSheetsAsPdf) {
  const TemporaryFolder folder;
  for (const std::string paper : {"a4", "letter"}) {
    const std::string file = folder / (paper + ".pdf");
    const auto result =
        runCommand("hands print " + shellWord(file) + " --json --paper " + paper, folder / "errors.txt");
    ASSERT_EQ(result.status, 0) << result.errors;
    EXPECT_EQ(nlohmann::json::parse(result.output)["pages"], 4);
    EXPECT_TRUE(bytesOf(file).starts_with("%PDF-"));
  }
}

TEST(HandsCommand, RefusesUnknownPaperAndMissingFolders) {
  const TemporaryFolder folder;
  EXPECT_EQ(runCommand("hands print x.pdf --paper a5", folder / "errors.txt").status, 2);
  EXPECT_EQ(runCommand("hands print", folder / "errors.txt").status, 2);
  const auto missing = runCommand("hands print " + shellWord(folder / "none" / "x.pdf"), folder / "errors.txt");
  EXPECT_EQ(missing.status, 1);
  EXPECT_THAT(missing.errors, HasSubstr("none"));
}

}  // namespace
}  // namespace insonate::test
