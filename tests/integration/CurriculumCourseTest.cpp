#include "integration/CurriculumCommands.h"

#include <insonate/curriculum/Csv.h>

#include <algorithm>
#include <map>

namespace insonate::test {
namespace {

using testing::HasSubstr;
using testing::Not;

class CurriculumCourse : public CurriculumCommands {
 protected:
  /// By the file that an import wrote.
  void choosePasswords(const std::filesystem::path& file) const {
    const auto rows = parseCsv(bytesOf(file));
    ASSERT_TRUE(rows);
    for (std::size_t i = 1; i < rows->size(); ++i)
      EXPECT_EQ(run("people password --as " + (*rows)[i].fields[0], (*rows)[i].fields[3], kPassword).status, 0);
  }
  json levelOf(const std::string& name, std::size_t level) const {
    return told("levels " + name + " --as " + name)["paths"][0]["levels"][level];
  }
};

TEST_F(CurriculumCourse, AClassIsTaughtByCommandsAlone) {
  setUp();
  EXPECT_THAT(run("setup other --full-name Other", "", kPassword).errors, HasSubstr("has people already"));
  add("miller", "--role instructor");
  told("classes add 'Year 1' --as boss");
  told("classes join 'Year 1' miller --teaches --as boss");

  std::ofstream(folder / "list.csv") << "First name,Surname,Email address,Username\r\n"
                                        "Alice,\"A., the first\",alice@example.org,alice\r\n"
                                        "Bob,B,not-an-address,bob\r\n"
                                        "=cmd(),C,carol@example.org,carol\r\n";
  const CommandResult import =
      run("classes import 'Year 1' " + path("list.csv") + " --passwords " + path("first.csv") + " --as miller --json");
  EXPECT_EQ(import.status, 3) << "a part was imported: " << import.errors;
  const json imported = json::parse(import.output, nullptr, false);
  EXPECT_EQ(imported["added"], json({"alice", "carol"}));
  EXPECT_EQ(imported["troubles"][0]["line"], 3);
  EXPECT_EQ(std::filesystem::status(folder / "first.csv").permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
  EXPECT_THAT(bytesOf(folder / "first.csv"), HasSubstr("'=cmd()")) << "which a spreadsheet would run";
  choosePasswords(folder / "first.csv");

  EXPECT_THAT(run("check central_line").output, HasSubstr("can be taught here"));
  publishTwoLevels();
  told("classes curriculum 'year 1' two --as miller");

  EXPECT_EQ(levelOf("alice", 0)["state"], "open");
  EXPECT_EQ(levelOf("alice", 1)["state"], "locked");
  EXPECT_THAT(levelOf("alice", 1)["why"].get<std::string>(), HasSubstr("First line"));
  const json failed = told("attempts add " + record("harm", Ending::InArtery, 1) + " --level first --as alice");
  EXPECT_EQ(failed["passed"], false);
  EXPECT_THAT(failed["why"].get<std::string>(), HasSubstr("artery was punctured"));
  const json broken = told("attempts add " + record("broken", Ending::Abandoned, 1) + " --as alice");
  EXPECT_EQ(broken["attempt"]["points"], nullptr) << "as in the window";
  told("attempts void " + broken["attempt"]["id"].get<std::string>() + " --reason broken --as miller");
  const json passed = told("attempts add " + record("good", Ending::InVein, 2) + " --level first --as alice");
  EXPECT_EQ(passed["passed"], true);
  EXPECT_EQ(passed["attempt"]["proof"], "not proven");
  EXPECT_EQ(passed["state"], "open") << "on nobody's word but their own";
  accept(passed);
  EXPECT_EQ(levelOf("alice", 0)["state"], "mastered");
  EXPECT_EQ(levelOf("alice", 1)["state"], "open");
  told("attempts add " + path("good") + " --level first --as alice");
  EXPECT_EQ(told("attempts list --as alice")["attempts"].size(), 3u) << "what is added twice is there once";

  const std::string attempt = passed["attempt"]["id"];
  EXPECT_THAT(refused("attempts void " + attempt + " --reason mine --as alice"), Not(""));
  told("attempts void " + attempt + " --reason 'made by someone else' --as miller");
  EXPECT_EQ(levelOf("alice", 0)["state"], "open");
  EXPECT_EQ(levelOf("alice", 1)["state"], "locked") << "it counts no more";
  EXPECT_EQ(told("attempts list alice --as miller")["attempts"][0]["void_reason"], "made by someone else");
  const json members = told("classes members 'Year 1' --as miller")["members"];
  EXPECT_EQ(members[0]["teaches"], true);
  EXPECT_EQ(members[2]["name"], "alice") << "by full name";
  EXPECT_EQ(members[2]["level"], "first");
  EXPECT_EQ(members[2]["attempts"], 1);
}

TEST_F(CurriculumCourse, ATestCountsWhileItsInstructorHasOpenedIt) {
  makeClass();
  const auto atTest = [&](const std::string& name, double seconds) {
    return told("attempts add " + record(name, Ending::InVein, seconds, utc(1)) + " --level second --as alice");
  };
  const json practice = atTest("practice", 1);
  EXPECT_EQ(practice["sitting"], "practice");
  EXPECT_EQ(practice["counts"], false);
  EXPECT_THAT(refused("attempts accept " + practice["attempt"]["id"].get<std::string>() + " --reason seen --as miller"),
              HasSubstr("stays practice"));
  EXPECT_THAT(run("tests list --as miller").output, HasSubstr("attempts at tests are practice"));
  EXPECT_THAT(refused("tests open second --class 'Year 1' --until 12:30 --as miller"), HasSubstr("is not a time"));
  EXPECT_THAT(refused("tests open first --class 'Year 1' --code venus --as miller"), HasSubstr("is not a test"));
  EXPECT_THAT(refused("tests open second --code venus --as miller"), HasSubstr("--class"));
  EXPECT_THAT(refused("tests enter second venus --as alice"), HasSubstr("is not open for you"));
  const json opening = told("tests open second --class 'Year 1' --until " + utc(3600) + " --code venus --as miller");
  EXPECT_EQ(opening["opening"]["state"], "open");
  EXPECT_EQ(opening["opening"]["class"], "Year 1");
  EXPECT_EQ(opening["opening"]["opened_by"], "Full miller");
  EXPECT_EQ(opening["opening"]["code"], true);
  EXPECT_THAT(refused("tests enter second Saturn --as alice"), HasSubstr("The code is wrong"));
  EXPECT_EQ(told("tests enter second Venus --as alice")["state"], "open");
  const json counted = atTest("counted", 2);
  EXPECT_EQ(counted["sitting"], "opened");
  accept(counted);
  const json listed = told("attempts list alice --as miller")["attempts"];
  EXPECT_EQ(listed[0]["sitting"], "opened");
  EXPECT_EQ(listed[0]["passed"], true);
  EXPECT_EQ(listed[1]["sitting"], "practice");
  EXPECT_EQ(listed[1]["passed"], nullptr);
  told("tests close " + opening["opening"]["id"].get<std::string>() + " --as miller");
  EXPECT_EQ(told("tests list 'Year 1' --as miller")["openings"][0]["state"], "closed");
  EXPECT_THAT(refused("tests list --as alice"), HasSubstr("permission"));
  EXPECT_EQ(atTest("late", 3)["sitting"], "practice");
}

TEST_F(CurriculumCourse, CommentsAreWrittenReadAndRemoved) {
  makeClass();
  const std::string attempt =
      told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice")["attempt"]["id"];
  const std::string comments = "attempts comments ";
  EXPECT_THAT(refused(comments + "add " + attempt + " mine --at 0 --as alice"), HasSubstr("permission"));
  EXPECT_THAT(refused(comments + "add " + attempt + " late --at 9999 --as miller"), HasSubstr("outside the attempt"));
  const std::string id =
      told(comments + "add " + attempt + " 'Withdraw first' --at 0.5 --as miller")["id"].get<std::string>();
  EXPECT_EQ(told("attempts list --as alice")["attempts"][0]["unread_comments"], 1);
  EXPECT_THAT(run("attempts list alice --as miller").output, HasSubstr("1, 1 unread"));
  const json read = told(comments + "list " + attempt + " --csv " + path("comments.csv") + " --as alice")["comments"];
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(read[0]["at_s"], 0.5);
  EXPECT_EQ(read[0]["text"], "Withdraw first");
  EXPECT_EQ(read[0]["author"], "Full miller");
  EXPECT_EQ(read[0]["read"], false);
  EXPECT_EQ((*parseCsv(bytesOf(folder / "comments.csv")))[1].fields[2], "0.5");
  EXPECT_EQ(told("attempts list --as alice")["attempts"][0]["unread_comments"], 0) << "alice has read it";
  EXPECT_EQ(told("export json " + path("all.json") + " --as boss").is_object(), true);
  EXPECT_THAT(bytesOf(folder / "all.json"), HasSubstr("Withdraw first"));
  EXPECT_THAT(refused(comments + "remove " + attempt + " " + id + " --as alice"), HasSubstr("permission"));
  told(comments + "remove " + attempt + " " + id + " --as miller");
  EXPECT_TRUE(told(comments + "list " + attempt + " --as alice")["comments"].empty());
}

TEST_F(CurriculumCourse, StatisticsSayWhatTheyCannotTell) {
  makeClass();
  const json success = told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice");
  told("attempts add " + record("b", Ending::InArtery, 1) + " --level first --as alice");
  const json waiting = told("statistics person --as alice");
  EXPECT_EQ(waiting["procedures"][0]["attempts"], 1) << "a success without proof may be another person's";
  EXPECT_EQ(waiting["waiting_for_acceptance"], 1);
  EXPECT_THAT(run("statistics person --as alice").output, HasSubstr("until an instructor accepts them: 1 unproven"));
  accept(success);
  accept(told("attempts add " + record("c", Ending::InVein, 3) + " --level first --as bob"));
  EXPECT_EQ(told("statistics person --as alice")["waiting_for_acceptance"], 0);
  const json alice = told("statistics person --as alice")["procedures"][0];
  EXPECT_EQ(alice["attempts"], 2);
  EXPECT_EQ(alice["succeeded"]["value"], 0.5);
  // Wilson: (1/2 + z^2/4 -+ z sqrt(1/8 + z^2/16)) / (1 + z^2/2), z = 1.96, so (1.460 -+ 1.185) / 2.921.
  EXPECT_NEAR(alice["succeeded"]["low"], 0.0945, 0.0005);
  EXPECT_EQ(alice["success"], alice["succeeded"]) << "which scripts know by this name";
  const auto& metrics = alice["metrics"];
  const auto artery =
      std::ranges::find_if(metrics, [](const json& row) { return row["metric"] == "artery_punctures"; });
  EXPECT_EQ((*artery)["mean"]["value"], 0.5);
  EXPECT_EQ((*artery)["interval_by"], "Poisson");
  EXPECT_GT((*artery)["low"], 0) << "a count is never below 0";
  const auto time = std::ranges::find_if(metrics, [](const json& row) { return row["metric"] == "attempt_time_s"; });
  EXPECT_TRUE((*time)["low"].is_null());
  EXPECT_EQ((*time)["interval_by"], "fewer than 5 values") << "of two";
  EXPECT_TRUE((*artery)["curve"].is_null()) << "two attempts are no curve";
  const auto force =
      std::ranges::find_if(metrics, [](const json& row) { return row["metric"] == "nearest_artery_mm"; });
  EXPECT_TRUE((*force)["median"].is_null());
  EXPECT_THAT(run("statistics person --as alice").output, HasSubstr("n/a"));
  EXPECT_EQ(told("statistics person --metric passes --as alice")["procedures"][0]["metrics"].size(), 1u);
  EXPECT_EQ(told("statistics person --as alice")["last"], 10);
  EXPECT_EQ((*artery)["mean_of_last"], 0.5);
  EXPECT_EQ((*artery)["last_5"], 0.5);
  EXPECT_EQ(run("statistics person --metric none --as alice").status, 2);

  accept(told("attempts add " + record("practice", Ending::InVein, 4) + " --as alice"));
  const json practised = told("statistics person --metric artery_punctures --as alice")["procedures"][0];
  EXPECT_EQ(practised["attempts"], 3) << "with free practice";
  EXPECT_EQ(practised["metrics"][0]["mean_of_last"], 0.5) << "as the class counts";
  EXPECT_NEAR(practised["metrics"][0]["mean_value"], 1 / 3.0, 1e-9);

  const json all = told("statistics class 'Year 1' --as miller")["procedures"][0];
  EXPECT_EQ(all["people"][0]["n"], 2) << "without free practice";
  EXPECT_EQ(all["people"].size(), 2u);
  EXPECT_EQ(all["people"][0]["succeeded_share"], 0.5);
  EXPECT_EQ(all["people"][0]["success_share"], 0.5);
  told("classes add Empty --as boss");
  EXPECT_THAT(run("statistics class Empty --as boss").output, HasSubstr("no attempts that count yet"));
  EXPECT_TRUE(told("statistics compare Empty 'Year 1' --as boss")["procedures"].empty());
  const json compared = told("statistics compare 'Year 1' 'Year 1' --as miller");
  EXPECT_EQ(compared["people_in_both"], 2);
  const json same = compared["procedures"][0]["metrics"][0];
  EXPECT_TRUE(same["effect"].is_null()) << "two people are too few to compare";
  EXPECT_EQ(same["n_first"], 2);
  EXPECT_THAT(compared["note"].get<std::string>(), HasSubstr("and 4 people or more in each class"));
}

TEST_F(CurriculumCourse, FormsAreFilledInOnce) {
  makeClass();
  const json forms = told("forms list");
  EXPECT_EQ(run("forms show " + forms["forms"][0]["form"].get<std::string>()).status, 0);
  json answers = json::object();
  const json items = told("forms show global_rating")["items"];
  for (const json& item : items) {
    const std::string choices = item["answers"];
    if (item["needed"] == true) answers[item["item"]] = choices.substr(0, choices.find(" | "));
  }
  std::ofstream(folder / "answers.json") << answers;
  told("forms fill global_rating " + path("answers.json") + " --about alice --as miller");
  std::ofstream(folder / "wrong.json") << R"({"nothing": "known"})";
  EXPECT_THAT(refused("forms fill global_rating " + path("wrong.json") + " --about alice --as miller"),
              HasSubstr("nothing"));
  const json filled = told("forms filled --as alice")["forms"];
  ASSERT_EQ(filled.size(), 1u);
  EXPECT_EQ(filled[0]["answers"], answers);
  EXPECT_THAT(refused("forms filled alice --as bob"), Not(""));
}

TEST_F(CurriculumCourse, ExportsAreForOtherPrograms) {
  makeClass();
  const json attempt = told("attempts add " + record("a", Ending::InVein, 1) + " --level first --as alice");
  accept(attempt);
  told("export csv 'Year 1' " + path("attempts.csv") + " --as miller");
  const auto rows = parseCsv(bytesOf(folder / "attempts.csv"));
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->size(), 2u);
  const auto field = [&](const std::string& column) {
    const auto& columns = (*rows)[0].fields;
    return (*rows)[1].fields.at(static_cast<std::size_t>(std::ranges::find(columns, column) - columns.begin()));
  };
  EXPECT_EQ(field("id"), attempt["attempt"]["id"]);
  EXPECT_EQ(field("name"), "alice");
  EXPECT_EQ(field("succeeded"), "yes");
  EXPECT_EQ(field("passed"), "yes");
  EXPECT_EQ(field("voided"), "no");
  EXPECT_EQ(field("assistance"), "guided");
  EXPECT_EQ(field("vein_punctures"), "1");
  const json listed = told("attempts list --as alice")["attempts"][0];
  EXPECT_EQ(listed["passed"], true);
  EXPECT_EQ(listed["assistance"], "guided");
  EXPECT_EQ(listed["voided"], false);
  const json graded = told("export grades 'Year 1' " + path("grades.csv") + " --by name --as miller");
  EXPECT_THAT(bytesOf(folder / "grades.csv"), HasSubstr("50")) << "one of two levels";
  EXPECT_THAT(bytesOf(folder / "grades.csv"), Not(HasSubstr("bob"))) << "who has no attempt yet";
  EXPECT_EQ(graded["left_out"].size(), 1u);
  EXPECT_EQ(graded["left_out_because"], json({"no grade yet"}));
  EXPECT_THAT(run("export grades 'Year 1' " + path("grades.csv") + " --by name --as miller").output,
              HasSubstr("(no grade yet)"));
  const std::string exporting = "export xapi 'Year 1' " + path("x.json") + " --home https://training.example.org";
  EXPECT_TRUE(told(exporting + " --as miller")["left_out"].empty());
  EXPECT_EQ(json::parse(bytesOf(folder / "x.json")).size(), 1u);
  EXPECT_THAT(refused("export xapi 'Year 1' " + path("y.json") + " --home training --as miller"), HasSubstr("http"));
  told("export json " + path("all.json") + " --as boss");
  const std::string all = bytesOf(folder / "all.json");
  EXPECT_TRUE(json::accept(all));
  EXPECT_THAT(all, Not(HasSubstr("argon2")));
  EXPECT_THAT(refused("export json " + path("mine.json") + " --as alice"), Not(""));
  EXPECT_FALSE(std::filesystem::exists(folder / "mine.json"));
}

}  // namespace
}  // namespace insonate::test
