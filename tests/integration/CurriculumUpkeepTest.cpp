#include "integration/CurriculumCommands.h"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <set>

namespace insonate::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class CurriculumUpkeep : public CurriculumCommands {};

TEST_F(CurriculumUpkeep, ATraineeIsRefusedTheDataOfOthers) {
  makeClass();
  const std::string attempt = told("attempts add " + record("b", Ending::InVein, 1) + " --as bob")["attempt"]["id"];
  const std::string bob = idOf("bob");
  ASSERT_EQ(bob.size(), 36u);
  for (const std::string& whose : {std::string("bob"), bob})
    for (const char* command : {"levels ", "attempts list ", "statistics person ", "forms filled "})
      EXPECT_THAT(refused(std::string(command) + whose + " --as alice"), Not("")) << command << whose;
  std::ofstream(folder / "list.csv") << "Full name,Username\nDave,dave\n";
  for (const char* command :
       {"people list", "audit", "verify", "migrate", "classes members 'Year 1'", "statistics class 'Year 1'",
        "export csv 'Year 1' x.csv", "export json x.json", "backup x.sqlite", "people add eve --full-name Eve",
        "people disable bob", "people role alice administrator", "classes add Mine", "publish central_line"})
    EXPECT_THAT(refused(std::string(command) + " --as alice"), Not("")) << command;
  EXPECT_THAT(refused("attempts void " + attempt + " --reason spite --as alice"), Not(""));
  EXPECT_THAT(refused("people reset-password bob --as alice"), Not(""));
  EXPECT_THAT(refused("classes import 'Year 1' " + path("list.csv") + " --passwords " + path("p.csv") + " --as alice"),
              Not(""));
  EXPECT_EQ(told("attempts list bob --as miller")["attempts"][0]["state"], "completed");

  int refusals = 0;
  const json entries = told("audit --person alice --count 100 --as boss")["entries"];
  for (const json& entry : entries) refusals += entry["allowed"] == false && entry["actor_name"] == "alice";
  EXPECT_GE(refusals, 15) << "what was refused is written down";
}

TEST_F(CurriculumUpkeep, AClassListWithoutAnyValidLineFails) {
  makeClass();
  std::ofstream(folder / "list.csv") << "Full name,Username\n,dave\nEve,\n";
  const std::string import =
      "classes import 'Year 1' " + path("list.csv") + " --passwords " + path("p.csv") + " --as miller";
  const CommandResult result = run(import + " --json");
  EXPECT_EQ(result.status, 1);
  const json told = json::parse(result.output, nullptr, false);
  EXPECT_THAT(told["error"].get<std::string>(), HasSubstr("No person was imported: every line of"));
  EXPECT_EQ(told["troubles"].size(), 2u);
  EXPECT_THAT(told["troubles"][0].value("text", ""), HasSubstr("Line 2: The name is missing"));
  EXPECT_FALSE(std::filesystem::exists(folder / "p.csv"));
  std::ofstream(folder / "list.csv") << "Full name,Username\n";
  EXPECT_THAT(refused(import), HasSubstr("contains no people"));
}

TEST_F(CurriculumUpkeep, APartOfAClassListExitsWithAStatusOfItsOwn) {
  makeClass();
  std::ofstream(folder / "list.csv") << "sep=;\nFull name;Username\nFull alice;alice\nEve;eve\n;dave\n";
  const std::string import = "classes import 'Year 1' " + path("list.csv") + " --as miller --json --passwords ";
  const CommandResult first = run(import + path("p.csv"));
  EXPECT_EQ(first.status, 3) << first.errors;
  const json part = json::parse(first.output, nullptr, false);
  EXPECT_EQ(part["added"], json({"eve"}));
  EXPECT_EQ(part["already_there"], json::parse(R"([{"line": 3, "name": "alice", "full_name": "Full alice"}])"));
  EXPECT_EQ(part["troubles"][0]["line"], 5);
  EXPECT_FALSE(part.contains("error"));
  std::ofstream(folder / "list.csv") << "Full name,Username\nFull alice,alice\n";
  EXPECT_EQ(told("classes import 'Year 1' " + path("list.csv") + " --as miller")["already_there"].size(), 1u);
}

TEST_F(CurriculumUpkeep, AnInstructorIsRefusedTheLogAndOtherClasses) {
  makeClass();
  told("classes add 'Year 2' --as boss");
  add("carol", "--class 'Year 2'");
  const std::string carol = idOf("carol");
  std::ofstream(folder / "list.csv") << "Full name,Username\nDave,dave\n";
  const std::string list = path("list.csv") + " --passwords " + path("p.csv");
  for (const std::string& command :
       {std::string("audit"), "audit --person " + carol, std::string("verify"), "backup " + path("x.sqlite"),
        "export json " + path("x.json"), std::string("classes members 'Year 2'"),
        std::string("statistics class 'Year 2'"), "export csv 'Year 2' " + path("x.csv"), "levels " + carol,
        "attempts list " + carol, "forms filled " + carol, std::string("forms agreement jugular_checklist 'Year 2'"),
        "classes import 'Year 2' " + list})
    EXPECT_THAT(refused(command + " --as miller"), AnyOf(HasSubstr("You do not have the permission for this"),
                                                         HasSubstr("among the classes that miller can see")))
        << command;
  told("statistics class 'Year 1' --as miller");
  int refusals = 0;
  const json entries = told("audit --count 100 --as boss")["entries"];
  for (const json& entry : entries) refusals += entry["allowed"] == false && entry["actor_name"] == "miller";
  EXPECT_GE(refusals, 7) << "what was refused is written down";
  EXPECT_FALSE(std::filesystem::exists(folder / "p.csv") || std::filesystem::exists(folder / "x.json"));
}

TEST_F(CurriculumUpkeep, APersonAndAnAdministratorExportThePersonsData) {
  makeClass();
  told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice");
  const json own = told("people export alice " + path("own.zip") + " --as alice");
  EXPECT_EQ(own["attempts"], 1);
  EXPECT_EQ(own["recordings"], 1);
  EXPECT_GT(std::filesystem::file_size(folder / "own.zip"), 1000u);
  EXPECT_EQ(told("people export --name alice --out " + path("boss.zip") + " --as boss")["person"]["name"], "alice");
  for (const char* who : {"bob", "miller"})
    EXPECT_THAT(refused("people export alice " + path("x.zip") + " --as " + who), HasSubstr("permission")) << who;
  EXPECT_FALSE(std::filesystem::exists(folder / "x.zip"));
}

TEST_F(CurriculumUpkeep, AnErasedPersonIsAPseudonymAndTheStoreIsWhole) {
  makeClass();
  const std::string attempt =
      told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice").at("attempt").at("id");
  told("attempts void " + attempt + " --reason 'Alice fell ill' --as miller");
  const std::string anchor = told("verify --as boss")["anchor"];
  EXPECT_THAT(refused("people erase alice --as boss"), HasSubstr("Nothing was erased."));
  EXPECT_THAT(refused("people erase alice --yes --as miller"), HasSubstr("permission"));
  EXPECT_THAT(refused("people erase boss --yes --as boss"), HasSubstr("permission"));
  const json erased = told("people erase --name alice --yes --as boss");
  EXPECT_EQ(erased["recordings"], 1);
  EXPECT_THAT(erased["person"]["full_name"].get<std::string>(), HasSubstr("Erased person "));
  EXPECT_THAT(refused("levels --as alice"), HasSubstr("wrong"));
  EXPECT_EQ(told("verify --anchor " + anchor + " --as boss")["differences"], json::array());
  EXPECT_FALSE(std::filesystem::exists(database + ".recordings/" + attempt + ".attempt"));
  told("export json " + path("all.json") + " --as boss");
  const std::string all = bytesOf(folder / "all.json");
  for (const char* name : {"alice", "Alice"}) EXPECT_THAT(all, Not(HasSubstr(name)));
}

TEST_F(CurriculumUpkeep, ARuleOfRetentionIsSetShownAndApplied) {
  makeClass();
  EXPECT_EQ(told("retention show --as boss")["erase_months"], nullptr);
  told("retention set --erase-trainees 24 --delete-recordings 12 --as boss");
  EXPECT_EQ(told("retention show --as boss")["recording_months"], 12);
  EXPECT_EQ(told("retention apply --dry-run --as boss")["trainees"], json::array());
  EXPECT_EQ(told("retention apply --as boss")["recordings"], json::array());
  for (const char* command : {"show", "set --erase-trainees 1", "apply", "apply --dry-run"})
    EXPECT_THAT(refused("retention " + std::string(command) + " --as miller"), HasSubstr("permission")) << command;
  EXPECT_EQ(run("retention set --erase-trainees -1 --as boss").status, 2);
  told("retention set --as boss");
  EXPECT_EQ(told("retention show --as boss")["erase_months"], nullptr);
}

TEST_F(CurriculumUpkeep, ABackupIsPutBackAndVerified) {
  makeClass();
  told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice");
  told("backup " + path("backup.sqlite") + " --as boss");
  told("attempts add " + record("b", Ending::InVein, 2) + " --level first --as alice");
  const json whole = told("verify --as boss");
  EXPECT_EQ(whole["attempts"], 2);
  const std::string anchor = whole["anchor"];
  EXPECT_EQ(run("verify --anchor " + anchor + " --as boss").status, 0);
  EXPECT_THAT(refused("verify --anchor 3 --as boss"), HasSubstr("is not an anchor"));
  std::ofstream(folder / "anchors") << "2026-11-29T07:00:00Z " << anchor << "\n";
  EXPECT_EQ(run("verify --anchors " + path("anchors") + " --as boss").status, 0);
  EXPECT_THAT(refused("verify --anchors " + path("none") + " --as boss"), HasSubstr("cannot be read"));

  EXPECT_THAT(refused("restore " + path("backup.sqlite") + " --as boss", "wrong"), Not(""));
  EXPECT_THAT(refused("restore " + path("none.sqlite") + " --as boss"), Not(""));
  EXPECT_EQ(told("migrate --as boss")["attempts"], 2) << "as it was";
  told("restore " + path("backup.sqlite") + " --as boss");
  EXPECT_EQ(told("migrate --as boss")["attempts"], 1);
  EXPECT_EQ(run("verify --as boss").status, 0);
  EXPECT_THAT(refused("verify --anchor " + anchor + " --as boss"), Not("")) << "the log is shorter than it was";
  EXPECT_THAT(refused("verify --anchors " + path("anchors") + " --as boss"), HasSubstr("is inconsistent"));
}

TEST_F(CurriculumUpkeep, AFileThatWasTamperedWithIsTold) {
  makeClass();
  told("attempts add " + record("a", Ending::InArtery, 1) + " --level first --as alice");
  told("classes leave 'Year 1' bob --as boss");
  ASSERT_EQ(run("verify --as boss").status, 0);
  std::string bytes = bytesOf(database);
  const std::size_t at = bytes.find("create first administrator");
  ASSERT_NE(at, std::string::npos) << "of the audit log";
  bytes[at] = 'C';
  std::ofstream(database, std::ios::binary) << bytes;
  const auto verified = run("verify --as boss --json");
  EXPECT_EQ(verified.status, 1);
  EXPECT_THAT(json::parse(verified.output)["error"].get<std::string>(), HasSubstr("audit"));
}

TEST_F(CurriculumUpkeep, UploadedTwiceIsThereOnce) {
  makeClass();
  const std::string server = database;
  database = folder / "workstation.sqlite";
  told("upload " + shellWord(server));
  const json added = told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice");
  EXPECT_EQ(told("upload " + shellWord(server))["attempts"], 1);
  const json again = told("upload " + shellWord(server));
  EXPECT_EQ(again["attempts"], 0);
  EXPECT_EQ(again["pending"], 0);
  EXPECT_THAT(refused("upload " + path("none.sqlite")), HasSubstr("There is no store"));
  EXPECT_FALSE(std::filesystem::exists(folder / "none.sqlite"));
  database = server;
  EXPECT_EQ(told("attempts list alice --as miller")["attempts"].size(), 1u);
  accept(added);
  EXPECT_EQ(told("levels alice --as miller")["paths"][0]["levels"][0]["state"], "mastered");
}

TEST_F(CurriculumUpkeep, AnImportThatIsKilledIsBegunAgain) {
  setUp();
  told("classes add Large --as boss");
  constexpr int kPeople = 12;
  std::ofstream list(folder / "list.csv");
  list << "Full name,Username\n";
  for (int i = 0; i < kPeople; ++i) list << "Person " << i << ",person" << i << "\n";
  list.close();
  const auto import = [&](int attempt, const std::string& prefix) {
    return runCommand("curriculum classes import Large " + path("list.csv") + " --passwords " +
                          path("passwords" + std::to_string(attempt) + ".csv") + " --as boss --json --database " +
                          shellWord(database),
                      folder / "errors.txt", "env INSONATE_PASSWORD=" + shellWord(kPassword) + " " + prefix);
  };
  const auto learners = [&] { return told("classes members Large --as boss")["members"].size(); };
  for (int kill = 0; kill < 3; ++kill) {
    import(kill, "timeout -s KILL " + std::to_string(0.3 + 0.2 * kill) + " ");
    EXPECT_THAT(learners(), testing::AnyOf(0u, std::size_t{kPeople})) << "all or nothing";
  }
  const auto last = import(3, "");
  EXPECT_EQ(last.status, 0) << last.errors;
  const json members = told("classes members Large --as boss")["members"];
  std::set<std::string> names;
  for (const json& member : members) names.insert(member["name"]);
  EXPECT_EQ(members.size(), std::size_t{kPeople});
  EXPECT_EQ(names.size(), std::size_t{kPeople});
  EXPECT_EQ(run("verify --as boss").status, 0);
  EXPECT_EQ(import(4, "").status, 0) << "nobody is added: no passwords are needed";
  EXPECT_FALSE(std::filesystem::exists(folder / "passwords4.csv"));
}

TEST_F(CurriculumUpkeep, WrongUsageAndWhatIsMissing) {
  EXPECT_EQ(run("").status, 2);
  EXPECT_EQ(run("people").status, 2);
  EXPECT_EQ(run("people list").status, 2) << "nobody signs in";
  EXPECT_EQ(run("people add eve --full-name Eve --role king --as boss").status, 2);
  EXPECT_EQ(run("people list --as boss --password " + std::string(kPassword)).status, 2) << "others would see it";
  EXPECT_THAT(refused("people list --as boss"), HasSubstr("There is no store of people and attempts at"));
  EXPECT_FALSE(std::filesystem::exists(database)) << "asking makes none";
  setUp();
  EXPECT_THAT(refused("people list --as boss", "wrong"), Not(""));
  EXPECT_THAT(refused("classes members None --as boss"), HasSubstr("There is no class 'None'"));
  EXPECT_THAT(refused("levels eve --as boss"), HasSubstr("There is no 'eve'"));
  EXPECT_THAT(refused("publish none.json --as boss"), Not(""));
  EXPECT_EQ(run("people add eve --full-name Eve --as boss").status, 0);
  EXPECT_THAT(refused("levels --as eve", kFirst), HasSubstr("curriculum people password --as eve"));
  std::ofstream(folder / "password") << kPassword << "\n";
  EXPECT_EQ(run("people list --as boss --password-file " + path("password"), "wrong").status, 0);
  EXPECT_EQ(run("people list --as boss --password-file /dev/fd/3 3<" + path("password"), "wrong").status, 0);
  EXPECT_THAT(refused("people list --as boss --password-file " + path("none")), HasSubstr("No password can be read"));
}

/// Terminal output while a user types a password, and the exit status.
CommandResult typing(const std::string& database, const std::string& password) {
  int terminal = -1;
  const pid_t child = ::forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child == 0) {
    ::unsetenv("INSONATE_PASSWORD");
    ::execl(INSONATE_CLI, INSONATE_CLI, "curriculum", "people", "list", "--as", "boss", "--database", database.c_str(),
            nullptr);
    ::_exit(127);
  }
  CommandResult result;
  std::array<char, 256> part;
  bool asked = false;
  for (ssize_t n; (n = ::read(terminal, part.data(), part.size())) > 0;) {
    result.output.append(part.data(), static_cast<std::size_t>(n));
    if (asked || result.output.find("Password of boss: ") == std::string::npos) continue;
    asked = true;
    const std::string line = password + "\n";
    EXPECT_EQ(::write(terminal, line.data(), line.size()), static_cast<ssize_t>(line.size()));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(terminal);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return result;
}

TEST_F(CurriculumUpkeep, APasswordThatIsTypedIsNotShown) {
  setUp();
  const CommandResult typed = typing(database, kPassword);
  EXPECT_EQ(typed.status, 0) << typed.output;
  EXPECT_THAT(typed.output, HasSubstr("The boss"));
  EXPECT_THAT(typed.output, Not(HasSubstr(kPassword)));
  EXPECT_EQ(typing(database, "\x03").status, 130) << "Ctrl-C";
}

TEST_F(CurriculumUpkeep, ADemonstrationHasAnAttemptToReplay) {
  const CommandResult demo =
      run("demo " + path("demo.sqlite") + " --trainees 2 --attempts 3 --recorded 1 --json", {}, kPassword);
  ASSERT_EQ(demo.status, 0) << demo.errors;
  const json made = json::parse(demo.output);
  ASSERT_EQ(made["recordings"].size(), 1u);
  const std::string file = made["recordings"][0];
  EXPECT_EQ(file, folder / "attempts/demo clean-success.attempt");
  const json newest =
      told("attempts list made-up-001 --as made-up-teacher --database " + path("demo.sqlite"))["attempts"][0];
  const CommandResult replay = runCommand("replay " + shellWord(file) + " --metrics --json", folder / "errors.txt");
  ASSERT_EQ(replay.status, 0) << replay.errors;
  EXPECT_EQ(newest["metrics"], json::parse(replay.output)["metrics"]);
  EXPECT_EQ(newest["succeeded"], true);
}

}  // namespace
}  // namespace insonate::test
