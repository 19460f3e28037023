#include "integration/CurriculumCommands.h"

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// What a trainee may try, to pass without an attempt of their own.
class CurriculumTrust : public CurriculumCommands {};

TEST_F(CurriculumTrust, ASessionsScriptPassesNoLevel) {
  makeClass();
  const CommandResult made = runCommand("phantom " + path("neck") + " --variant textbook", folder / "errors.txt");
  ASSERT_EQ(made.status, 0) << made.errors;
  const CommandResult session =
      runCommand("session " + path("neck") + " --script clean-success --record " + path("scripted.attempt"),
                 folder / "errors.txt");
  ASSERT_EQ(session.status, 0) << session.errors;
  EXPECT_THAT(refused("attempts add " + path("scripted.attempt") + " --level first --as alice"),
              HasSubstr("was recorded from a script"));
  EXPECT_THAT(refused("attempts add " + path("scripted.attempt") + " --as alice"),
              HasSubstr("counts as nobody's attempt"))
      << "not as free practice either";
  EXPECT_TRUE(told("attempts list --as alice")["attempts"].empty());
}

TEST_F(CurriculumTrust, ARecordingPassesForOnePersonOnce) {
  makeClass();
  EXPECT_EQ(told("attempts add " + record("mine", Ending::InVein, 2) + " --level first --as alice")["passed"], true);
  std::filesystem::copy_file(folder / "mine", folder / "copied");
  EXPECT_THAT(refused("attempts add " + path("copied") + " --level first --as bob"),
              HasSubstr("was added already, on"));
  const std::string dated = record("dated", Ending::InVein, 2, utc(-60));
  for (const std::string who : {"alice", "bob"})
    EXPECT_THAT(refused("attempts add " + dated + " --level first --as " + who), HasSubstr("was added already, on"));
  EXPECT_TRUE(told("attempts list --as bob")["attempts"].empty());
}

TEST_F(CurriculumTrust, ADateThatCannotBeIsRefused) {
  makeClass();
  const std::string before = record("before", Ending::InVein, 1, "2026-01-02T03:04:05Z");
  EXPECT_THAT(refused("attempts add " + before + " --level first --as alice"), HasSubstr("level was published later"));
  const std::string future = record("future", Ending::InVein, 2, utc(86'400));
  EXPECT_THAT(refused("attempts add " + future + " --level first --as alice"), HasSubstr("lies in the future"));
  EXPECT_THAT(refused("attempts add " + future + " --as alice"), HasSubstr("lies in the future"));
  EXPECT_TRUE(told("attempts list --as alice")["attempts"].empty());
  told("attempts add " + before + " --as alice");
}

}  // namespace
}  // namespace insonate::test
