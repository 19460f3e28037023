#include "integration/CurriculumCommands.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CurriculumStore.h>

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// Attempts of a trainee to pass without an attempt of their own.
class CurriculumTrust : public CurriculumCommands {
 protected:
  /// As the workstation begins an attempt of alice at the first level.
  struct Sealed {
    RecordedFor whose{};
    RecordKey key{};
  };
  Sealed seal() const {
    const auto store = CurriculumStore::open(database);
    const auto alice = store ? store->signIn("alice", kPassword) : fail(store.error().message);
    AttemptFacts facts;
    facts.id = "1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa";
    facts.curriculum = "two", facts.curriculumVersion = 1, facts.level = "first";
    const auto sealed = alice ? AttemptStore(*alice).issueSeal(facts) : fail(alice.error().message);
    if (!sealed) throw std::runtime_error(sealed.error().message);
    return {{facts.id, alice->person().id, "two", 1, "first", sealed->nonce}, sealed->key};
  }
  std::string changedAt(const std::string& name, double share) const {
    std::string bytes = bytesOf(folder / name);
    bytes[static_cast<std::size_t>(share * static_cast<double>(bytes.size() - 1))] ^= 4;
    std::ofstream(folder / "changed", std::ios::binary | std::ios::trunc) << bytes;
    return path("changed");
  }
  json replayed(const std::string& file, const std::string& more = "") const {
    const CommandResult result =
        runCommand("replay " + file + " --json" + more, folder / "errors.txt",
                   "env INSONATE_DATABASE=" + shellWord(database) + " INSONATE_PASSWORD=" + shellWord(kPassword) + " ");
    return json::parse(result.output, nullptr, false)["proof"];
  }
};

TEST_F(CurriculumTrust, ARecordingOfTheWorkstationIsProvenAndCounts) {
  makeClass();
  const Sealed sealed = seal();
  const std::string file = record("mine", Ending::InVein, 2, utc(0), sealed.whose, sealed.key);
  EXPECT_THAT(refused("attempts add " + file + " --as bob"), HasSubstr("was recorded for another person"));
  EXPECT_THAT(refused("attempts add " + file + " --level second --as alice"), HasSubstr("counts only for this level"));
  const json added = told("attempts add " + file + " --as alice");
  EXPECT_EQ(added["attempt"]["proof"], "proven");
  EXPECT_EQ(added["attempt"]["id"], sealed.whose.attempt);
  EXPECT_EQ(added["state"], "mastered");
  EXPECT_EQ(replayed(file, " --attempt " + sealed.whose.attempt + " --as alice")["state"], "proven");
  EXPECT_EQ(replayed(file)["state"], "not proven") << "without a store nobody knows";
  EXPECT_EQ(told("attempts list --as alice")["attempts"][0]["proof"], "proven");
}

TEST_F(CurriculumTrust, AChangedByteIsRefusedWhereverItIs) {
  makeClass();
  const Sealed sealed = seal();
  record("mine", Ending::InVein, 2, utc(0), sealed.whose, sealed.key);
  for (const double share : {0.0, 0.02, 0.2, 0.5, 0.8, 0.999, 1.0}) {
    const std::string changed = changedAt("mine", share);
    EXPECT_THAT(refused("attempts add " + changed + " --as alice"),
                testing::AnyOf(HasSubstr("changed"), HasSubstr("damaged"), HasSubstr("is not a recording")))
        << share;
  }
  EXPECT_EQ(replayed(changedAt("mine", 0.5))["state"], "changed");
  EXPECT_TRUE(told("attempts list --as alice")["attempts"].empty());
}

/// Each with digests that agree, since they need no key.
TEST_F(CurriculumTrust, ARewrittenHeaderIsRefused) {
  makeClass();
  const Sealed sealed = seal();
  record("mine", Ending::InVein, 2, utc(0), sealed.whose, sealed.key);
  EXPECT_THAT(refused("attempts add " + record("dated", Ending::InVein, 2, utc(-60), sealed.whose) + " --as alice"),
              HasSubstr("its codes are not those of the store"));
  RecordedFor other = sealed.whose;
  other.person = idOf("bob");
  EXPECT_THAT(refused("attempts add " + record("bobs", Ending::InVein, 2, utc(0), other) + " --as bob"),
              HasSubstr("was changed after it was recorded"));
  other = sealed.whose, other.level = "second";
  EXPECT_THAT(refused("attempts add " + record("second", Ending::InVein, 2, utc(0), other) + " --as alice"),
              HasSubstr("was changed after it was recorded"));
  other = sealed.whose, other.attempt = "2c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa";
  EXPECT_THAT(refused("attempts add " + record("again", Ending::InVein, 3, utc(0), other, sealed.key) + " --as alice"),
              HasSubstr("was changed after it was recorded"))
      << "a nonce is of one attempt";
  other = {};
  const json free =
      told("attempts add " + record("free", Ending::InVein, 4, utc(0), other) + " --level first --as alice");
  EXPECT_EQ(free["attempt"]["proof"], "not proven") << "without a nonce there is nothing to find, and nothing counts";
  EXPECT_EQ(free["counts"], false);
  EXPECT_EQ(free["state"], "open");
  EXPECT_THAT(refused("attempts accept " + free["attempt"]["id"].get<std::string>() + " --reason mine --as alice"),
              HasSubstr("You do not have the permission for this"));
}

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
              HasSubstr("does not count for any person"))
      << "not as free practice either";
  EXPECT_TRUE(told("attempts list --as alice")["attempts"].empty());
}

TEST_F(CurriculumTrust, ARecordingPassesForOnePersonOnce) {
  makeClass();
  told("attempts add " + record("mine", Ending::InVein, 2) + " --level first --as alice");
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
  EXPECT_THAT(refused("attempts add " + future + " --level first --as alice"), HasSubstr("is in the future"));
  EXPECT_THAT(refused("attempts add " + future + " --as alice"), HasSubstr("is in the future"));
  EXPECT_TRUE(told("attempts list --as alice")["attempts"].empty());
  told("attempts add " + before + " --as alice");
}

}  // namespace
}  // namespace insonate::test
