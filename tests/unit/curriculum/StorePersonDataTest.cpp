#include "StoreRig.h"
#include "support/ZipContent.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/Csv.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/VideoQueue.h>

#include <nlohmann/json.hpp>

#include <fstream>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

/// Anna, with a row in each table that holds data on a trainee.
class StorePersonData : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    school.emplace(rig->open());
    valueOf(PublishedCurricula(school->admin).publish("central_line", 2, curriculumOf(2)));
    succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "central_line", 2));
    const SignedIn anna = school->as(school->anna), ina = school->as(school->ina);
    facts = keepAttempt(anna);
    fs::create_directories(rig->services.recordings);
    std::ofstream(rig->services.recordings / (facts.id + ".attempt")) << "the motion of her hands";
    valueOf(FormStore(anna).add({"", "questionnaire", 1, school->anna.id, "", "", 0, R"({"says": "my \"words\""})"}));
    valueOf(FormStore(ina).add({"", "rating", 1, school->anna.id, facts.id, "", 0, R"({"tip": 3})"}));
    valueOf(CommentStore(ina).add(facts.id, 5, "Hold the probe, anna"));
    succeed(AttemptVideos(anna).request(facts.id));
    secret = valueOf(BrowserSessions(school->store).begin(anna));
    token = valueOf(PeopleStore(anna).staySignedIn());
  }
  std::map<std::string, std::string> exported(const SignedIn& by, const Person& person) const {
    const fs::path file = rig->folder / "data.zip";
    counts = valueOf(PersonData(by).exportTo(person.id, file));
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    return zipContent(file);
  }
  nlohmann::json personJson(const SignedIn& by, const Person& person) const {
    return nlohmann::json::parse(exported(by, person).at("person.json"));
  }

  std::optional<School> school;
  AttemptFacts facts;
  std::string secret, token;
  mutable PersonExport counts;
};
INSONATE_ON_BOTH(StorePersonData);

TEST_P(StorePersonData, AnExportHasAllThatTheStoreHoldsOnThePerson) {
  const auto content = exported(school->as(school->anna), school->anna);
  ASSERT_EQ(content.size(), 3U);
  EXPECT_EQ(content.at("recordings/" + facts.id + ".attempt"), "the motion of her hands");
  const auto json = nlohmann::json::parse(content.at("person.json"));
  EXPECT_EQ(json.at("account").at(0).at("full_name"), "Dr anna");
  EXPECT_EQ(json.at("account").at(0).at("email"), "anna@example.org");
  EXPECT_EQ(json.at("classes").at(0).at("name"), "Spring");
  EXPECT_EQ(json.at("attempts").at(0).at("metrics").at(1).at(2), 0.1 + 0.2);
  EXPECT_EQ(json.at("attempts").at(0).at("proof"), "proven");
  EXPECT_EQ(json.at("standings").size(), 1U);
  EXPECT_EQ(json.at("comments").at(0).at("text"), "Hold the probe, anna");
  EXPECT_EQ(json.at("comments").at(0).at("author_name"), "Dr ina");
  EXPECT_EQ(json.at("forms").at(0).at("answers").at("says"), "my \"words\"");
  EXPECT_EQ(json.at("forms").at(1).at("rater_name"), "Dr ina");
  EXPECT_EQ(json.at("browser_sessions").size(), 1U);
  EXPECT_EQ(json.at("sign_in_tokens").size(), 1U);
  EXPECT_EQ(json.at("videos").at(0).at("attempt"), facts.id);
  EXPECT_EQ(counts.attempts, 1);
  EXPECT_EQ(counts.recordings, 1);

  const auto rows = valueOf(parseCsv(content.at("attempts.csv")));
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[1].fields[0], facts.id);
  const auto column = std::ranges::find(rows[0].fields, "time_to_vein_s, version 2");
  ASSERT_NE(column, rows[0].fields.end());
  EXPECT_EQ(rows[1].fields[static_cast<std::size_t>(column - rows[0].fields.begin())], "0.30000000000000004");
}

TEST_P(StorePersonData, AnExportNeedsRoomOnTheDisk) {
  const fs::path file = rig->folder / "data.zip";
  const auto stop = [](std::string_view, double) { return false; };
  const auto refusal = [&](int roomFactor) {
    return refusalOf(PersonData(school->admin).exportTo(school->anna.id, file, stop, roomFactor));
  };
  EXPECT_EQ(refusal(2), kCancelled);
  // The file has a size, but occupies no blocks.
  fs::resize_file(rig->services.recordings / (facts.id + ".attempt"), fs::space(rig->folder.path()).available / 5 * 3);
  EXPECT_EQ(refusal(1), kCancelled);
  EXPECT_THAT(refusal(2), HasSubstr("The disk has no room for " + file.string() + ": free "));
  EXPECT_FALSE(fs::exists(file));
}

TEST_P(StorePersonData, AnExportHasNoSecretsAndNoDataOfOthers) {
  std::string all;
  for (const Person& person : {school->anna, school->ina})
    for (const auto& [name, bytes] : exported(school->admin, person)) all += bytes;
  for (const std::string& hidden : {secret, token, std::string("argon2"), std::string("ben@"), std::string("Dr ben")})
    EXPECT_THAT(all, Not(HasSubstr(hidden)));
  const auto ina = personJson(school->admin, school->ina);
  EXPECT_EQ(ina.at("comments_written").at(0).at("attempt"), facts.id);
  EXPECT_EQ(ina.at("forms_about_others").at(0).at("person"), school->anna.id);
  EXPECT_TRUE(ina.at("attempts").empty());
  EXPECT_THAT(ina.dump(), Not(HasSubstr("anna@example.org")));
  EXPECT_THAT(ina.dump(), Not(HasSubstr("Dr anna")));
  bool wroteComment = false;
  for (const auto& entry : ina.at("audit")) {
    wroteComment |= entry.at("act") == "write comment";
    EXPECT_TRUE(entry.at("person") == school->ina.id || entry.at("detail") == "") << entry;
  }
  EXPECT_TRUE(wroteComment);
}

TEST_P(StorePersonData, EachExportIsInTheLogAlsoOfOnesOwnData) {
  (void)exported(school->as(school->anna), school->anna);
  const auto entry = valueOf(AuditLog(school->admin).page(2))[1];
  EXPECT_EQ(entry.act, "export person");
  EXPECT_EQ(entry.actor, school->anna.id);
  EXPECT_EQ(entry.person, school->anna.id);
}

TEST_P(StorePersonData, ARefusedOrFailedExportLeavesNoFile) {
  const fs::path file = rig->folder / "data.zip";
  EXPECT_THAT(refusalOf(PersonData(school->as(school->ina)).exportTo(school->anna.id, file)),
              HasSubstr("do not have the permission"))
      << "an instructor sees results, but not sessions and log entries";
  EXPECT_THAT(refusalOf(PersonData(school->admin).exportTo("' OR 1=1 --", file)), HasSubstr("no such person"));
  const auto stop = [](std::string_view, double) { return false; };
  EXPECT_EQ(refusalOf(PersonData(school->admin).exportTo(school->anna.id, file, stop)), kCancelled);
  EXPECT_FALSE(fs::exists(file));
  EXPECT_THAT(refusalOf(PersonData(school->admin).exportTo(school->anna.id, rig->folder / "nowhere/data.zip")),
              HasSubstr("does not exist"));
}

TEST_P(StorePersonData, ANameThatLooksLikeAFormulaOrMarkupIsOnlyAText) {
  Person anna = school->anna;
  anna.fullName = "=HYPERLINK(\"x\") '; DROP TABLE people; -- <b>";
  succeed(PeopleStore(school->admin).change(anna));
  EXPECT_EQ(personJson(school->admin, school->anna).at("account").at(0).at("full_name"), anna.fullName);
}

}  // namespace
}  // namespace insonate::test
