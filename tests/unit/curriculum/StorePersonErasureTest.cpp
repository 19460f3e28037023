#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/ErasedAttempts.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/StoreCheck.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/VideoQueue.h>

#include <nlohmann/json.hpp>

#include <fstream>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Writes to the database past the program.
Result<void> writePast(const StoreRig& rig, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  return (*connection)->script(sql);
}

std::string pseudonymOf(const Person& person) {
  return "Erased person " + person.id.substr(0, 8);
}

/// Anna, with an attempt about which Ina has written.
class StorePersonErasure : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    school.emplace(rig->open());
    anna.emplace(school->as(school->anna)), ina.emplace(school->as(school->ina));
    facts = keepAttempt(*anna);
    fs::create_directories(rig->services.recordings);
    std::ofstream(recording()) << "the motion of her hands";
    valueOf(FormStore(*ina).add(
        {"", "global_rating", 1, school->anna.id, facts.id, "", 0, R"({"overall": 3, "remark": "Anna was late"})"}));
    comment = valueOf(CommentStore(*ina).add(facts.id, 5, "Hold the probe, Anna"));
  }
  fs::path recording() const { return rig->services.recordings / (facts.id + ".attempt"); }
  void erase(const Person& person) const { succeed(PersonData(school->admin).erase(person.id)); }
  Person now(const Person& person) const { return valueOf(PeopleStore(school->admin).person(person.id)); }
  void expectWholeStore() const {
    succeed(StoreUpkeep(school->admin).verify());
    EXPECT_TRUE(valueOf(StoreCheck(school->admin).againstLog()).empty());
    EXPECT_TRUE(valueOf(StoreCheck(school->admin).standings()).empty());
  }
  /// All rows of all tables, but for passwords.
  std::string everything() const {
    const fs::path file = rig->folder / "all.json";
    succeed(StoreUpkeep(school->admin).exportJson(file));
    return bytesOf(file);
  }

  std::optional<School> school;
  std::optional<SignedIn> anna, ina;
  AttemptFacts facts;
  std::string comment;
};
INSONATE_ON_BOTH(StorePersonErasure);

TEST_P(StorePersonErasure, AnErasedPersonHasAPseudonymAndCannotSignIn) {
  const BrowserSessions sessions(school->store);
  const std::string secret = valueOf(sessions.begin(*anna)), token = valueOf(PeopleStore(*anna).staySignedIn());
  erase(school->anna);
  const Person erased = now(school->anna);
  EXPECT_EQ(erased.fullName, pseudonymOf(school->anna));
  EXPECT_EQ(erased.name, "erased-" + school->anna.id.substr(0, 8));
  EXPECT_EQ(erased.email, "");
  EXPECT_TRUE(erased.disabled);
  EXPECT_FALSE(AttemptStore(*anna).history(school->anna.id)) << "the session that was open";
  EXPECT_FALSE(valueOf(sessions.resume(secret)));
  EXPECT_FALSE(school->store.signInByToken(token));
  EXPECT_FALSE(school->store.signIn("anna", kPassword));
  EXPECT_FALSE(school->store.signIn(erased.name, kPassword));
  valueOf(PeopleStore(school->admin).add({"anna", "Another Anna", "anna@example.org"}, "first password"));
  expectWholeStore();
}

TEST_P(StorePersonErasure, AnErasedAccountStaysDisabled) {
  erase(school->anna);
  Person enabled = now(school->anna);
  enabled.disabled = false;
  const PeopleStore people(school->admin);
  for (const std::string& refusal :
       {refusalOf(people.change(enabled)), refusalOf(people.resetPassword(school->anna.id, "another password")),
        refusalOf(CohortStore(school->admin).join(school->autumn.id, school->anna.id, false))})
    EXPECT_THAT(refusal, HasSubstr("This person was erased"));
}

TEST_P(StorePersonErasure, NoNewTextsAboutAnErasedPersonAreStored) {
  erase(school->anna);
  for (const std::string& refusal :
       {refusalOf(CommentStore(*ina).add(facts.id, 5, "Anna again")),
        refusalOf(FormStore(*ina).add({"", "debrief", 1, school->anna.id, facts.id, "", 0, "{}"})),
        refusalOf(AttemptStore(*ina).voidAttempt(facts.id, "Anna felt ill"))})
    EXPECT_THAT(refusal, HasSubstr("no texts about the person are stored any more"));
  EXPECT_THAT(everything(), Not(HasSubstr("Anna")));
}

TEST_P(StorePersonErasure, NumbersStayAndTextsAndRecordingsGo) {
  succeed(AttemptStore(*ina).voidAttempt(facts.id, "Anna felt ill"));
  erase(school->anna);
  const StoredAttempt kept = valueOf(AttemptStore(*ina).attempt(facts.id));
  EXPECT_EQ(kept.facts.metrics, facts.metrics);
  EXPECT_EQ(kept.facts.points, facts.points);
  EXPECT_EQ(kept.facts.recording, "");
  EXPECT_EQ(kept.voidReason, "(erased)");
  EXPECT_FALSE(fs::exists(recording()));
  EXPECT_TRUE(valueOf(CommentStore(*ina).listByAttempt(facts.id)).empty());
  const auto forms = valueOf(FormStore(*ina).listByAttempt(facts.id));
  ASSERT_EQ(forms.size(), 1U);
  const auto answers = nlohmann::json::parse(forms[0].filled.answers);
  EXPECT_EQ(answers.at("overall"), 3);
  EXPECT_EQ(answers.at("remark"), "(erased)");
  const auto members = valueOf(CohortStore(*ina).members(school->spring.id));
  EXPECT_TRUE(std::ranges::any_of(members, [&](const Member& one) { return one.person.id == school->anna.id; }))
      << "the class keeps its statistics";
  const std::string all = everything();
  for (const char* name : {"anna", "Anna"}) EXPECT_THAT(all, Not(HasSubstr(name)));
  expectWholeStore();
}

TEST_P(StorePersonErasure, ChoicesStayAndTextsOfUnknownFormsGo) {
  const auto add = [&](const std::string& form, const std::string& answers) {
    return valueOf(FormStore(*anna).add({"", form, 1, school->anna.id, "", "", 0, answers}));
  };
  const Form questionnaire = valueOf(loadForm("simulator_questionnaire"));
  const auto choice = std::ranges::find(questionnaire.sections[0].items, FormItem::Kind::Choice, &FormItem::kind);
  ASSERT_NE(choice, questionnaire.sections[0].items.end());
  add("simulator_questionnaire", answersText({{choice->name, choice->options[0].name}}));
  add("of_another_program", R"({"word": "my name is Anna", "number": 2})");
  erase(school->anna);
  std::vector<std::string> answers;
  for (const StoredForm& one : valueOf(FormStore(school->admin).listByPerson(school->anna.id)))
    if (one.filled.attempt.empty()) answers.push_back(one.filled.answers);
  EXPECT_THAT(answers, ::testing::UnorderedElementsAre(answersText({{choice->name, choice->options[0].name}}),
                                                       answersText({{"number", 2.0}, {"word", "(erased)"}})));
}

TEST_P(StorePersonErasure, WhatAnErasedInstructorWroteAboutOthersStays) {
  erase(school->ina);
  const auto comments = valueOf(CommentStore(*anna).listByAttempt(facts.id));
  ASSERT_EQ(comments.size(), 1U);
  EXPECT_EQ(comments[0].text, "Hold the probe, Anna");
  EXPECT_EQ(comments[0].author, pseudonymOf(school->ina));
  EXPECT_THAT(valueOf(FormStore(*anna).listByAttempt(facts.id))[0].filled.answers, HasSubstr("Anna was late"));
  EXPECT_EQ(valueOf(FormStore(*anna).listByAttempt(facts.id))[0].rater, pseudonymOf(school->ina));
  EXPECT_TRUE(valueOf(CohortStore(school->admin).listByPerson(school->ina.id)).empty()) << "she no longer teaches";
  EXPECT_TRUE(fs::exists(recording()));
}

TEST_P(StorePersonErasure, TheLogHasNoNamesAndStillVerifies) {
  succeed(AttemptStore(*ina).voidAttempt(facts.id, "Anna felt ill"));
  const AuditAnchor before = valueOf(AuditLog(school->admin).anchor());
  erase(school->anna);
  succeed(AuditLog(school->admin).verify({before}));
  std::vector<std::string> details;
  bool isErased = false;
  for (const AuditEntry& entry : valueOf(AuditLog(school->admin).page(1000))) {
    EXPECT_THAT(entry.detail, Not(HasSubstr("nna")));
    if (entry.act == "void attempt") details.push_back(entry.detail);
    isErased |= entry.act == "erase person" && entry.person == school->anna.id;
  }
  EXPECT_THAT(details, ElementsAre("(erased), attempt " + facts.id));
  EXPECT_TRUE(isErased);
}

TEST_P(StorePersonErasure, AnErasedEntryThatIsChangedLaterIsFound) {
  succeed(AttemptStore(*ina).voidAttempt(facts.id, "Anna felt ill"));
  erase(school->anna);
  const std::string unguarded =
      GetParam() == Place::Server ? "ALTER TABLE audit DISABLE TRIGGER USER; " : "DROP TRIGGER audit_fixed; ";
  succeed(writePast(*rig, unguarded + "UPDATE audit SET actor = '' WHERE act = 'void attempt'"));
  EXPECT_THAT(refusalOf(AuditLog(school->admin).verify()), HasSubstr("it was changed"));
}

TEST_P(StorePersonErasure, ADetailThatTheProgramDidNotEraseIsFound) {
  succeed(writePast(*rig, "UPDATE audit SET detail = '(erased)' WHERE number = 5"));
  EXPECT_THAT(refusalOf(AuditLog(school->admin).verify()), HasSubstr("entry 5: it was changed"));
  succeed(AttemptStore(*ina).voidAttempt(facts.id, "Anna felt ill"));
  const std::string unguarded =
      GetParam() == Place::Server ? "ALTER TABLE audit DISABLE TRIGGER USER; " : "DROP TRIGGER audit_fixed; ";
  succeed(writePast(*rig, unguarded + "UPDATE audit SET actor = '' WHERE act = 'void attempt'"));
  EXPECT_THAT(refusalOf(PersonData(school->admin).erase(school->anna.id)), HasSubstr("was changed by another program"));
  EXPECT_EQ(now(school->anna), school->anna) << "nothing is erased in part";
  EXPECT_TRUE(fs::exists(recording()));
}

TEST_P(StorePersonErasure, OnlyAdministratorsErase) {
  const std::string admin = school->admin.person().id;
  EXPECT_THAT(refusalOf(PersonData(school->admin).erase(admin)), StartsWith("You do not have the permission"));
  EXPECT_THAT(refusalOf(PersonData(*anna).erase(school->anna.id)), StartsWith("You do not have the permission"));
  EXPECT_THAT(refusalOf(PersonData(*ina).erase(school->anna.id)), StartsWith("You do not have the permission"));
  EXPECT_THAT(refusalOf(PersonData(school->admin).erase(freshUuid())), HasSubstr("no such person"));
  EXPECT_EQ(now(school->anna), school->anna);
}

TEST_P(StorePersonErasure, ThePreviewCountsWhatIsLost) {
  const PersonExtent extent = valueOf(PersonData(school->admin).previewErasure(school->anna.id));
  EXPECT_EQ(extent.attempts, 1);
  EXPECT_EQ(extent.recordings, 1);
  EXPECT_EQ(extent.comments, 1);
  EXPECT_EQ(extent.forms, 1);
  EXPECT_FALSE(extent.isErased);
  erase(school->anna);
  EXPECT_EQ(valueOf(PersonData(school->admin).previewErasure(school->anna.id)).recordings, 0);
  EXPECT_TRUE(valueOf(PersonData(school->admin).previewErasure(school->anna.id)).isErased);
  std::ofstream(recording()) << "a file that could not be deleted before";
  erase(school->anna);
  EXPECT_FALSE(fs::exists(recording())) << "an erasure can be repeated";
}

TEST_P(StorePersonErasure, AVideoThatWaitsIsNotMade) {
  succeed(AttemptVideos(*anna).request(facts.id));
  const VideoQueue queue(school->store, "server");
  ASSERT_TRUE(valueOf(queue.takeNext()));
  erase(school->anna);
  EXPECT_FALSE(valueOf(queue.reportProgress(facts.id, 0.5))) << "the server stops";
  EXPECT_EQ(valueOf(queue.waiting()), 0);
}

TEST_P(StorePersonErasure, AServerDeletesTheFilesOfPeopleWhomAnotherProgramErased) {
  ErasedAttempts erased(school->store);
  EXPECT_TRUE(valueOf(erased.removeRecordings()).attempts.empty());
  StoreServices elsewhere = rig->services;
  elsewhere.recordings = rig->folder / "recordings of another computer";
  const CurriculumStore other = valueOf(CurriculumStore::open(rig->address, elsewhere));
  succeed(PersonData(valueOf(other.signIn("admin", kPassword))).erase(school->anna.id));
  EXPECT_TRUE(fs::exists(recording()));
  EXPECT_THAT(valueOf(erased.removeRecordings()).attempts, ElementsAre(facts.id));
  EXPECT_FALSE(fs::exists(recording()));
  EXPECT_TRUE(valueOf(erased.removeRecordings()).attempts.empty()) << "they are deleted";
}

TEST_P(StorePersonErasure, OthersAndNumbersStayGuarded) {
  const AttemptFacts bens = keepAttempt(school->as(school->ben));
  valueOf(FormStore(school->as(school->ben)).add({"", "debrief", 1, school->ben.id, "", "", 0, R"({"a": "b"})"}));
  erase(school->anna);
  const std::string bensForm = " WHERE person = '" + school->ben.id + "'", annas = " WHERE id = '" + facts.id + "'";
  for (const std::string& sql :
       {"UPDATE forms SET answers = '{}'" + bensForm, "UPDATE attempts SET recording = '' WHERE id = '" + bens.id + "'",
        "UPDATE attempts SET recording = 'x'" + annas, "UPDATE attempts SET points = 1" + annas,
        "UPDATE forms SET filled_us = 1 WHERE person = '" + school->anna.id + "'", std::string("DELETE FROM erasures"),
        std::string("UPDATE erasures SET erased_by = ''")})
    EXPECT_FALSE(writePast(*rig, sql)) << sql;
}

/// Stores of earlier programs have names in their logs.
TEST(StorePersonErasureOfEarlier, TheNamesThatEarlierProgramsWroteAreErased) {
  const StoreRig rig;
  {
    const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
    succeed((*connection)->script(bytesOf(fs::path(INSONATE_SOURCE_DIR) / "tests/unit/curriculum/schemas/12.sql")));
  }
  const SignedIn admin = valueOf(rig.open().signIn("admin", kPassword));
  const auto details = [&] {
    std::string all;
    for (const AuditEntry& entry : valueOf(AuditLog(admin).page(1000))) all += entry.detail + "\n";
    return all;
  };
  ASSERT_THAT(details(), HasSubstr("anna, trainee"));
  const AuditAnchor before = valueOf(AuditLog(admin).anchor());
  const auto people = valueOf(PeopleStore(admin).all());
  const auto anna = std::ranges::find(people, "anna", &Person::name);
  ASSERT_NE(anna, people.end());
  succeed(PersonData(admin).erase(anna->id));
  EXPECT_THAT(details(), Not(HasSubstr("anna")));
  EXPECT_THAT(details(), HasSubstr("(erased), trainee"));
  EXPECT_THAT(details(), HasSubstr("ben, trainee")) << "of others, nothing is erased";
  succeed(AuditLog(admin).verify({before}));
  succeed(StoreUpkeep(admin).verify());
  EXPECT_TRUE(valueOf(StoreCheck(admin).againstLog()).empty());
}

}  // namespace
}  // namespace insonate::test
