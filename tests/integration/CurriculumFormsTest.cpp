#include "CurriculumCommands.h"

#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/Form.h>

namespace insonate::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Two who teach a class, and attempts of alice that both judge.
class CurriculumForms : public CurriculumCommands {
 protected:
  void SetUp() override {
    makeClass();
    add("otto", "--role instructor --class 'Year 1'");
  }
  std::string attempt(double seconds) {
    recording = record("attempt" + std::to_string(seconds), Ending::InVein, seconds);
    return told("attempts add " + recording + " --level first --as alice")["attempt"]["id"];
  }
  /// A checklist on which all is done but the first item, which is as it is said.
  std::string sheet(const std::string& first, const std::string& note = "") const {
    const auto form = loadForm("jugular_checklist");
    std::vector<std::vector<std::string>> rows{{"item", "answer", "note"}};
    for (const FormSection& section : form->sections)
      for (const FormItem& item : section.items) rows.push_back({item.name, "done", ""});
    rows[1][1] = first, rows[1][2] = note;
    std::ofstream(folder / "sheet.csv", std::ios::binary) << csvText(rows);
    return path("sheet.csv");
  }
  void judge(const std::string& who, const std::string& attempt, const std::string& first,
             const std::string& note = "") const {
    told("forms fill jugular_checklist " + sheet(first, note) + " --about alice --attempt " + attempt + " --as " + who);
  }
  std::string refusedSheet(const std::string& text) const {
    std::ofstream(folder / "bad.csv", std::ios::binary) << text;
    return refused("forms fill jugular_checklist " + path("bad.csv") + " --about alice --as miller");
  }

  std::string recording;
};

TEST_F(CurriculumForms, AClassesRatersAreComparedInAllAndItemByItem) {
  const std::string first = attempt(1), second = attempt(2);
  judge("miller", first, "done"), judge("otto", first, "done");
  judge("miller", second, "not_done"), judge("otto", second, "done");
  const json all = told("forms agreement jugular_checklist 'Year 1' --csv " + path("raters.csv") + " --as boss");
  EXPECT_EQ(all["judged_twice"], 2);
  ASSERT_EQ(all["rows"].size(), 23u) << "the total and 22 items";
  EXPECT_EQ(all["rows"][0]["item"], "total");
  EXPECT_EQ(all["rows"][0]["raters"], "Full miller, Full otto");
  EXPECT_NEAR(all["rows"][0]["agreement"].get<double>(), 43.0 / 44, 1e-12);
  EXPECT_EQ(all["rows"][1]["agreement"], 0.5);
  EXPECT_EQ(all["rows"][2]["kappa"], nullptr) << "both always said done";
  const auto rows = parseCsv(bytesOf(folder / "raters.csv"));
  ASSERT_TRUE(rows);
  EXPECT_EQ(rows->size(), 24u);
  EXPECT_EQ((*rows)[1].fields[4], "total");
  EXPECT_EQ((*rows)[3].fields[9], "") << "what there is not is left empty";
  EXPECT_THAT(refused("forms agreement jugular_checklist 'Year 1' --as alice"), Not(IsEmpty()));
  EXPECT_THAT(refused("forms agreement simulator 'Year 1' --as boss"), HasSubstr("simulator"));
  EXPECT_THAT(run("forms agreement global_rating 'Year 1' --as boss").output, HasSubstr("nothing to compare"));
}

TEST_F(CurriculumForms, RatersReadEachOthersNotesAfterTheirOwn) {
  const std::string id = attempt(1), note = "=HYPERLINK(\"http://x\"), <b>%1</b>";
  judge("miller", id, "not_done", note);
  const CommandResult before = run("forms compare jugular_checklist " + id + " --as otto");
  EXPECT_THAT(before.output, HasSubstr("after you have handed in yours: 1"));
  EXPECT_THAT(before.output, Not(HasSubstr("HYPERLINK")));
  const json withheld = told("forms filled alice --as otto")["forms"];
  ASSERT_EQ(withheld.size(), 1u);
  EXPECT_EQ(withheld[0]["withheld"], true);
  EXPECT_EQ(withheld[0]["answers"], nullptr);
  judge("otto", id, "done");
  const json after = told("forms compare jugular_checklist " + id + " --as otto")["items"];
  EXPECT_EQ(after[0]["differs"], true);
  EXPECT_EQ(after[0]["said"][0]["note"], "'" + note) << "as the table that was filled in has it";
  EXPECT_EQ(after[1]["differs"], false);
  EXPECT_THAT(
      refused("forms fill jugular_checklist " + sheet("not_done") + " --about alice --attempt " + id + " --as otto"),
      HasSubstr("a form can be handed in only once"))
      << "who knows what others said";
  EXPECT_EQ(told("forms filled --as alice")["forms"][0]["withheld"], false) << "whom it is about reads it";
  EXPECT_THAT(refused("forms compare jugular_checklist " + id + " --as bob"), Not(IsEmpty()));
}

TEST_F(CurriculumForms, BadTablesAreToldWithTheirLine) {
  EXPECT_THAT(refusedSheet(""), HasSubstr("item,answer"));
  EXPECT_THAT(refusedSheet("question,answer\n"), HasSubstr("item,answer"));
  EXPECT_THAT(refusedSheet("item,answer\nnothing,done\n"), HasSubstr("Line 2: 'nothing' is not an item"));
  EXPECT_THAT(refusedSheet("item,answer\nindication,done\nindication,done\n"), HasSubstr("Line 3: 'indication' is"));
  EXPECT_THAT(refusedSheet("item,answer\nindication,done,\"a note\"\n"), HasSubstr("more fields than columns"));
  EXPECT_THAT(refusedSheet("item,answer\nindication,\"done\n"), HasSubstr("quote"));
  EXPECT_THAT(refusedSheet("item,answer\nindication,perhaps\n"), HasSubstr("needs one of"));
  EXPECT_THAT(refusedSheet("item,answer\nindication,done\n"), HasSubstr("consent"));
  EXPECT_THAT(refusedSheet("item,answer\n\xff,done\n"), HasSubstr("UTF-8"));
}

TEST_F(CurriculumForms, ARecordingIsReplayedAsAnAttemptOnlyIfItIsTheOne) {
  const std::string id = attempt(1), right = recording;
  const auto replay = [&](const std::string& file, const std::string& who) {
    return runCommand("replay " + file + " --json --attempt " + id + " --as " + who, folder / "errors.txt",
                      "env INSONATE_DATABASE=" + shellWord(database) + " INSONATE_PASSWORD='" + kPassword + "' ");
  };
  EXPECT_EQ(replay(right, "miller").status, 0);
  const CommandResult other = replay(record("another", Ending::InVein, 3), "miller");
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.output, HasSubstr("is not the recording of the attempt " + id));
  EXPECT_EQ(replay(right, "bob").status, 1) << "who may not see the attempt";
  EXPECT_EQ(runCommand("replay " + right + " --attempt " + id, folder / "errors.txt").status, 2) << "by whom?";
}

TEST_F(CurriculumForms, AListOfTheClassIsOneLookInTheLog) {
  attempt(1);
  told("classes members 'Year 1' --as miller");
  const json log = told("audit --as boss");
  std::vector<std::string> actions;
  for (const json& entry : log["entries"]) actions.push_back(entry["act"]);
  EXPECT_EQ(std::ranges::count(actions, "see standings"), 1);
  EXPECT_EQ(std::ranges::count(actions, "see attempts"), 0) << "no entry for each person";
}

}  // namespace
}  // namespace insonate::test
