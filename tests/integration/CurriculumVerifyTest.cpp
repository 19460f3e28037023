#include "integration/CurriculumCommands.h"

#include <sqlite3.h>

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// Attacks of someone who may write the store's file, past the program and its triggers.
class CurriculumVerify : public CurriculumCommands {
 protected:
  /// Takes the trigger that fixes attempts away, writes, and puts it back, so that nothing looks as if it was gone.
  void writePast(const std::string& sql) const {
    sqlite3* file = nullptr;
    ASSERT_EQ(sqlite3_open(database.c_str(), &file), SQLITE_OK);
    std::string trigger;
    const auto take = [](void* into, int, char** values, char**) {
      *static_cast<std::string*>(into) = values[0];
      return 0;
    };
    ASSERT_EQ(
        sqlite3_exec(file, "SELECT sql FROM sqlite_master WHERE name = 'attempts_fixed'", take, &trigger, nullptr),
        SQLITE_OK);
    const std::string all = "DROP TRIGGER attempts_fixed;" + sql + ";" + trigger;
    EXPECT_EQ(sqlite3_exec(file, all.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(file);
    sqlite3_close(file);
  }
  /// The differences that verify tells as it refuses.
  json found() const {
    const CommandResult verified = run("verify --as boss --json");
    EXPECT_EQ(verified.status, 1) << verified.output;
    const json object = json::parse(verified.output, nullptr, false);
    EXPECT_EQ(object["whole"], false);
    EXPECT_TRUE(object["anchor"].is_null()) << "nothing is vouched for";
    EXPECT_THAT(object.value("error", ""), HasSubstr("no anchor is given"));
    return object["differences"];
  }
  std::string attempt(const std::string& name, Ending ending, double seconds) const {
    return told("attempts add " + record(name, ending, seconds) + " --level first --as alice")["attempt"]["id"];
  }
};

TEST_F(CurriculumVerify, AnAddedRecordingIsKeptAndReplayedByTheAttemptsId) {
  makeClass();
  const std::string id = attempt("mine.attempt", Ending::InVein, 12);
  std::filesystem::remove(folder / "mine.attempt");
  const std::string kept = database + ".recordings/" + id + ".attempt";
  EXPECT_EQ(told("attempts list alice --as miller")["attempts"][0]["recording_file"], kept);
  const auto replay = [&](const std::string& who) {
    return runCommand("replay --metrics --json --attempt " + id + " --as " + who, folder / "errors.txt",
                      "env INSONATE_DATABASE=" + shellWord(database) + " INSONATE_PASSWORD='" + kPassword + "' ");
  };
  const CommandResult replayed = replay("miller");
  ASSERT_EQ(replayed.status, 0) << replayed.errors;
  EXPECT_EQ(json::parse(replayed.output)["metrics"], told("attempts list --as alice")["attempts"][0]["metrics"]);
  EXPECT_EQ(replay("bob").status, 1) << "who may not see the attempt";
  EXPECT_EQ(runCommand("replay", folder / "errors.txt").status, 2) << "neither a file nor an attempt";
  std::filesystem::remove(kept);
  const CommandResult gone = replay("miller");
  EXPECT_EQ(gone.status, 1);
  EXPECT_THAT(gone.errors,
              HasSubstr("The store keeps no recording of the attempt " + id + ". Look for 'mine.attempt'"));
}

TEST_F(CurriculumVerify, AnEditedRowIsNamedWithItsFields) {
  makeClass();
  const std::string id = attempt("bad", Ending::InArtery, 12);
  const json whole = told("verify --as boss");
  EXPECT_EQ(whole["recomputed"], 1);
  EXPECT_EQ(whole["whole"], true);
  EXPECT_TRUE(whole["anchor"].is_string());
  writePast(
      "UPDATE attempts SET succeeded = 1, critical_errors = 0, points = 95, metrics = "
      "replace(metrics, '[\"artery_punctures\",1,1.0]', '[\"artery_punctures\",1,0.0]')");
  const json differences = found();
  std::vector<std::string> fields;
  for (const json& one : differences) {
    EXPECT_EQ(one["person_name"], "alice");
    // Nor does the standing follow from the row any more: it was kept before.
    if (one["attempt"] == id) fields.push_back(one["field"]);
  }
  EXPECT_THAT(fields, testing::ElementsAre("succeeded", "critical errors", "points", "metric artery_punctures"));
  EXPECT_EQ(differences[1]["stored"], "0");
  EXPECT_EQ(differences[1]["expected"], "1");
  const CommandResult text = run("verify --as boss");
  EXPECT_EQ(text.status, 1);
  EXPECT_THAT(text.output, HasSubstr("metric artery_punctures"));
  EXPECT_THAT(text.output, testing::Not(HasSubstr("--anchor")));
}

TEST_F(CurriculumVerify, AnEditedRecordingLevelOrStandingIsNamed) {
  makeClass();
  const std::string id = attempt("good", Ending::InVein, 12);
  told("classes members 'Year 1' --as miller");
  writePast("UPDATE standings SET mastered = 2, level = ''");
  EXPECT_EQ(found()[0]["field"], "standing in two 1: level");
  writePast("DELETE FROM standings");
  EXPECT_EQ(told("verify --as boss")["whole"], true) << "they are worked out anew";
  writePast("UPDATE attempts SET level = 'second'");
  EXPECT_EQ(found()[0]["field"], "level");
  writePast("UPDATE attempts SET level = 'first'");
  std::ofstream(database + ".recordings/" + id + ".attempt", std::ios::app) << "more";
  EXPECT_EQ(found()[0]["field"], "recording hash");
}

TEST_F(CurriculumVerify, WhatCannotBeRecomputedAndWhatIsImplausibleIsNamed) {
  makeClass();
  const std::string fast = attempt("fast", Ending::InVein, 1), other = attempt("other", Ending::InVein, 12);
  std::filesystem::remove(database + ".recordings/" + other + ".attempt");
  const json whole = told("verify --as boss");
  EXPECT_EQ(whole["recomputed"], 1);
  ASSERT_EQ(whole["not_recomputed"].size(), 1U);
  EXPECT_EQ(whole["not_recomputed"][0]["attempt"], other);
  EXPECT_THAT(whole["not_recomputed"][0]["why"].get<std::string>(), HasSubstr("is not kept by this store"));
  const json flags = told("attempts list alice --as miller")["attempts"][1]["flags"];
  EXPECT_EQ(flags, (json{"fast_to_vein", "short"})) << "20 mm at 10 mm/s; 4 s in all";
  EXPECT_FALSE(told("attempts list --as alice")["attempts"][1].contains("flags")) << "for who teaches";
  const CommandResult text = run("attempts list alice --as miller");
  EXPECT_THAT(text.output, HasSubstr("time to vein 2.0"));
  EXPECT_EQ(whole["implausible"][0]["attempt"], fast);
}

TEST_F(CurriculumVerify, ABackupTakesTheRecordingsAlong) {
  makeClass();
  const std::string id = attempt("good", Ending::InVein, 12);
  told("backup " + path("backup.sqlite") + " --as boss");
  std::filesystem::remove_all(database + ".recordings");
  EXPECT_EQ(told("verify --as boss")["recomputed"], 0);
  told("restore " + path("backup.sqlite") + " --as boss");
  EXPECT_EQ(told("verify --as boss")["recomputed"], 1);
}

}  // namespace
}  // namespace insonate::test
