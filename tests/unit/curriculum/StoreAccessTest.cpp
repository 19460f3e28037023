#include "StoreRig.h"
#include "store/Access.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Retention.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/VideoQueue.h>
#include <insonate/curriculum/Workstations.h>

#include <functional>
#include <map>
#include <set>

namespace insonate::test {
namespace {

using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

template <class T>
std::string outcome(const Result<T>& result) {
  return result ? "" : result.error().message;
}

/// A call about anna, or about her cohort, and who may make it: g a guest, a anna herself, b ben of her cohort, i ina
/// who teaches it, o otto who teaches another, m the administrator.
struct Call {
  const char* name;
  std::string allowed;
  std::function<std::string(const SignedIn&)> make;
};

/// Objects of the calls.
struct Target {
  explicit Target(const School& of) : school(of) {
    const SignedIn anna = school.as(school.anna);
    attempt = keepAttempt(anna);
    form = {freshUuid(), "feedback", 1, school.anna.id, attempt.id, "", 0, R"({"secret": "of anna"})"};
    valueOf(FormStore(anna).add(form));
    valueOf(PublishedCurricula(school.admin).publish("central_line", 1, curriculumOf(1)));
    succeed(CohortStore(school.admin).setCurriculum(school.spring.id, "central_line", 1));
    succeed(PublishedCurricula(school.admin).saveDraft("draft", "{", ""));
    leaver = school.add("leaver", Role::Trainee, school.spring.id);
    erased = school.add("erased", Role::Trainee, school.spring.id);
  }

  const School& school;
  const TemporaryFolder folder;
  AttemptFacts attempt;
  FilledForm form;
  Person leaver, erased;
};

std::vector<Call> peopleCalls(const Target& target) {
  const std::string anna = target.school.anna.id, spring = target.school.spring.id;
  return {
      {"see person", "aim", [=](const SignedIn& by) { return outcome(PeopleStore(by).person(anna)); }},
      {"see all people", "m", [=](const SignedIn& by) { return outcome(PeopleStore(by).all()); }},
      {"add trainee", "im",
       [=](const SignedIn& by) { return outcome(PeopleStore(by).add({"new1"}, kPassword, spring)); }},
      {"add person", "m", [=](const SignedIn& by) { return outcome(PeopleStore(by).add({"new2"}, kPassword)); }},
      {"add instructor", "m",
       [=](const SignedIn& by) {
         return outcome(PeopleStore(by).add({"new3", "", "", Role::Instructor}, kPassword, spring));
       }},
      {"change person", "m",
       [=](const SignedIn& by) {
         return outcome(PeopleStore(by).change({anna, "anna", "Anna", "", Role::Trainee, false}));
       }},
      {"change own details", "abiom",
       [=](const SignedIn& by) { return outcome(PeopleStore(by).changeOwnDetails("Someone", "")); }},
      {"stay signed in", "abiom", [=](const SignedIn& by) { return outcome(PeopleStore(by).staySignedIn()); }},
      {"reset password", "im",
       [=, id = target.leaver.id](const SignedIn& by) {
         return outcome(PeopleStore(by).resetPassword(id, "temporary one"));
       }},
      {"export person", "am",
       [=, file = target.folder / "anna.zip"](const SignedIn& by) {
         return outcome(PersonData(by).exportTo(anna, file));
       }},
      {"see extent of erasure", "m",
       [=, id = target.erased.id](const SignedIn& by) { return outcome(PersonData(by).previewErasure(id)); }},
      {"erase person", "m",
       [=, id = target.erased.id](const SignedIn& by) { return outcome(PersonData(by).erase(id)); }},
      {"see cohorts of person", "aim", [=](const SignedIn& by) { return outcome(CohortStore(by).listByPerson(anna)); }},
      {"see own cohorts", "abiom", [=](const SignedIn& by) { return outcome(CohortStore(by).cohorts()); }},
      {"see members", "im", [=](const SignedIn& by) { return outcome(CohortStore(by).members(spring)); }},
      {"see standings", "im", [=](const SignedIn& by) { return outcome(CohortStore(by).standings(spring, {{anna}})); }},
      {"add cohort", "m", [=](const SignedIn& by) { return outcome(CohortStore(by).add("Winter")); }},
      {"rename cohort", "m",
       [=](const SignedIn& by) { return outcome(CohortStore(by).rename(spring, "Early spring")); }},
      {"archive cohort", "m", [=](const SignedIn& by) { return outcome(CohortStore(by).archive(spring, false)); }},
      {"delete cohort", "m",
       [=](const SignedIn& by) {
         const std::string said = outcome(CohortStore(by).remove(spring, "another name"));
         return said.find("is not the name of this class") == std::string::npos ? said : "";
       }},
      {"join cohort", "m",
       [=, id = target.school.carl.id](const SignedIn& by) {
         return outcome(CohortStore(by).join(spring, id, false));
       }},
      {"remove member", "im",
       [=, id = target.leaver.id](const SignedIn& by) { return outcome(CohortStore(by).leave(spring, id)); }},
      {"set curriculum", "im",
       [=](const SignedIn& by) { return outcome(CohortStore(by).setCurriculum(spring, "central_line", 1)); }},
      {"plan class list", "im", [=](const SignedIn& by) { return outcome(ClassImport(by).plan(spring, ClassList{})); }},
      {"add class list", "im", [=](const SignedIn& by) { return outcome(ClassImport(by).apply(spring, {}, {})); }},
      {"put class list's known", "m", [=, id = target.school.carl.id](const SignedIn& by) {
         const ClassImportRow carl{.step = ClassImportRow::Step::Join, .id = id};
         return outcome(ClassImport(by).apply(spring, {&carl, 1}, {}));
       }}};
}

std::vector<Call> attemptCalls(const Target& target) {
  const std::string anna = target.school.anna.id, spring = target.school.spring.id, attempt = target.attempt.id;
  return {
      {"begin attempt", "abiom", [=](const SignedIn& by) { return outcome(AttemptStore(by).begin(begunFacts())); }},
      {"end attempt", "a",
       [=, facts = target.attempt](const SignedIn& by) { return outcome(AttemptStore(by).end(facts)); }},
      {"seal attempt", "abiom", [=](const SignedIn& by) { return outcome(AttemptStore(by).issueSeal(begunFacts())); }},
      {"find origin", "aim",
       [=, facts = target.attempt](const SignedIn& by) mutable {
         facts.person = anna;
         return outcome(AttemptStore(by).originOf(facts, std::string(128, '0')));
       }},
      {"see attempt", "aim", [=](const SignedIn& by) { return outcome(AttemptStore(by).attempt(attempt)); }},
      {"see page", "aim", [=](const SignedIn& by) { return outcome(AttemptStore(by).page(anna, 10)); }},
      {"see history", "aim", [=](const SignedIn& by) { return outcome(AttemptStore(by).history(anna)); }},
      {"see changes", "aim", [=](const SignedIn& by) { return outcome(AttemptStore(by).changes(anna)); }},
      {"see last of cohort", "im",
       [=](const SignedIn& by) { return outcome(AttemptStore(by).recentOfCohort(spring, 3)); }},
      {"find recording", "abiom",
       [=](const SignedIn& by) {
         return outcome(AttemptStore(by).findByRecording("a.attempt", std::string(64, 'a')));
       }},
      {"see agreement", "im",
       [=](const SignedIn& by) {
         return outcome(FormStore(by).agreement(spring, valueOf(loadForm("jugular_checklist"))));
       }},
      {"see forms", "aim", [=](const SignedIn& by) { return outcome(FormStore(by).listByPerson(anna)); }},
      {"see forms of attempt", "aim",
       [=](const SignedIn& by) { return outcome(FormStore(by).listByAttempt(attempt)); }},
      {"see forms of cohort", "im",
       [=](const SignedIn& by) { return outcome(FormStore(by).listByCohort(spring, "feedback")); }},
      {"fill in form", "aim",
       [=](const SignedIn& by) {
         return outcome(FormStore(by).add({"", "rating", 1, anna, attempt, "", 0, "{}"}));
       }},
      {"write comment", "im",
       [=](const SignedIn& by) { return outcome(CommentStore(by).add(attempt, 0, "look here")); }},
      {"remove comment", "im",
       [=](const SignedIn& by) {
         const std::string said = outcome(CommentStore(by).remove(attempt, freshUuid()));
         return said.find("no such comment") == std::string::npos ? said : "";
       }},
      {"see comments", "aim", [=](const SignedIn& by) { return outcome(CommentStore(by).listByAttempt(attempt)); }},
      {"see counts of comments", "aim", [=](const SignedIn& by) { return outcome(CommentStore(by).countsOf(anna)); }},
      {"mark comments as read", "a", [=](const SignedIn& by) { return outcome(CommentStore(by).markRead(attempt)); }},
      {"request video", "aim", [=](const SignedIn& by) { return outcome(AttemptVideos(by).request(attempt)); }},
      {"see state of video", "aim", [=](const SignedIn& by) { return outcome(AttemptVideos(by).state(attempt)); }},
      {"accept attempt", "im",
       [=](const SignedIn& by) {
         // A person's own attempt is refused; for those of others the answer is that acceptance is not needed.
         const std::string said = outcome(AttemptStore(by).accept(attempt, "I was there"));
         return said.find("does not need to be accepted") == std::string::npos ? said : "";
       }},
      {"void attempt", "im",
       [=](const SignedIn& by) { return outcome(AttemptStore(by).voidAttempt(attempt, "device failed")); }}};
}

std::vector<Call> openingCalls(const Target& target) {
  const std::string spring = target.school.spring.id;
  return {{"open test", "im",
           [=](const SignedIn& by) {
             return outcome(OpeningStore(by).open({.cohort = spring, .level = "jugular_test", .code = "venus"}));
           }},
          {"open test for everyone", "m",
           [=](const SignedIn& by) {
             return outcome(
                 OpeningStore(by).open({.curriculum = "central_line", .level = "jugular_test", .code = "venus"}));
           }},
          {"close test", "im",
           [=](const SignedIn& by) {
             const std::string said = outcome(OpeningStore(by).close(spring, freshUuid()));
             return said.find("no such opening") == std::string::npos ? said : "";
           }},
          {"close test for everyone", "m",
           [=](const SignedIn& by) {
             const std::string said = outcome(OpeningStore(by).close("", freshUuid()));
             return said.find("no such opening") == std::string::npos ? said : "";
           }},
          {"see openings", "im", [=](const SignedIn& by) { return outcome(OpeningStore(by).listByCohort(spring)); }},
          {"see all openings", "m", [=](const SignedIn& by) { return outcome(OpeningStore(by).all()); }},
          {"see admission", "abiom",
           [=](const SignedIn& by) { return outcome(OpeningStore(by).admission("central_line", "jugular_test")); }}};
}

std::vector<Call> storeCalls(const Target& target) {
  const std::string anna = target.school.anna.id;
  return {
      {"list curricula", "gabiom", [=](const SignedIn& by) { return outcome(PublishedCurricula(by).list()); }},
      {"read curriculum", "gabiom",
       [=](const SignedIn& by) { return outcome(PublishedCurricula(by).text("central_line", 1)); }},
      {"publish", "iom",
       [=](const SignedIn& by) { return outcome(PublishedCurricula(by).publish("central_line", 2, curriculumOf(2))); }},
      {"list drafts", "iom", [=](const SignedIn& by) { return outcome(PublishedCurricula(by).drafts()); }},
      {"read draft", "iom", [=](const SignedIn& by) { return outcome(PublishedCurricula(by).draft("draft")); }},
      {"save draft", "iom",
       [=](const SignedIn& by) { return outcome(PublishedCurricula(by).saveDraft("draft", "}", "{")); }},
      {"discard draft", "iom",
       [=](const SignedIn& by) { return outcome(PublishedCurricula(by).discardDraft("draft", "}")); }},
      {"see audit log", "m", [=](const SignedIn& by) { return outcome(AuditLog(by).page(10)); }},
      {"see audit log of person", "m", [=](const SignedIn& by) { return outcome(AuditLog(by).page(10, 0, anna)); }},
      {"see anchor", "m", [=](const SignedIn& by) { return outcome(AuditLog(by).anchor()); }},
      {"verify audit log", "m", [=](const SignedIn& by) { return outcome(AuditLog(by).verify()); }},
      {"see uploads", "iom", [=](const SignedIn& by) { return outcome(pendingUploads(by, 10)); }},
      {"add workstation", "m",
       [=](const SignedIn& by) {
         (void)Workstations(by).revoke("ward 9");
         return outcome(Workstations(by).add("ward 9"));
       }},
      {"list workstations", "m", [=](const SignedIn& by) { return outcome(Workstations(by).list()); }},
      {"revoke workstation", "m", [=](const SignedIn& by) { return outcome(Workstations(by).revoke("ward 9")); }},
      {"see rule of retention", "m", [=](const SignedIn& by) { return outcome(Retention(by).rule()); }},
      {"set rule of retention", "m",
       [=](const SignedIn& by) { return outcome(Retention(by).setRule({.erase_months = 12})); }},
      {"preview retention", "m",
       [=](const SignedIn& by) { return outcome(Retention(by).preview({.erase_months = 12})); }},
      {"apply retention", "m", [=](const SignedIn& by) { return outcome(Retention(by).deleteExpired()); }},
      {"facts of store", "m", [=](const SignedIn& by) { return outcome(StoreUpkeep(by).facts()); }},
      {"grant", "m",
       [=](const SignedIn& by) {
         // An administrator of a file is told that it has no roles.
         const auto granted = StoreUpkeep(by).grantServerRole("pg_monitor");
         return granted || granted.error().message.find("has no roles") == std::string::npos ? outcome(granted)
                                                                                             : outcome(Result<void>());
       }},
      {"verify store", "m", [=](const SignedIn& by) { return outcome(StoreUpkeep(by).verify()); }}};
}

std::vector<Call> allCalls(const Target& target) {
  std::vector<Call> calls = peopleCalls(target);
  for (const auto& more : {attemptCalls(target), openingCalls(target), storeCalls(target)})
    calls.insert(calls.end(), more.begin(), more.end());
  return calls;
}

class StoreAccess : public OnBoth {};
INSONATE_ON_BOTH(StoreAccess);

TEST_P(StoreAccess, EveryCallIsAllowedToWhomItIsMeantForAndNoOther) {
  for (const char who : std::string("gabiom")) {
    StoreRig own(GetParam());
    const School school(own.open());
    const Target target(school);
    const std::map<char, SignedIn> people{{'g', school.store.guest()},   {'a', school.as(school.anna)},
                                          {'b', school.as(school.ben)},  {'i', school.as(school.ina)},
                                          {'o', school.as(school.otto)}, {'m', school.admin}};
    for (const Call& call : allCalls(target)) {
      SCOPED_TRACE(std::string(call.name) + " by " + who);
      const std::string refusal = call.make(people.at(who));
      if (call.allowed.find(who) != std::string::npos)
        EXPECT_EQ(refusal, "");
      else
        EXPECT_THAT(refusal, AnyOf(StartsWith("You do not have the permission for this"), StartsWith("Sign in first")));
    }
    EXPECT_TRUE(AuditLog(school.admin).verify());
  }
}

TEST_P(StoreAccess, AllThatCanBeAskedIsAmongTheseCallsAndRefusalsAreLogged) {
  const School school(rig->open());
  const Target target(school);
  for (const Call& call : allCalls(target)) (void)call.make(school.store.guest());
  (void)PeopleStore(school.store.guest()).changeOwnPassword(kPassword, "another one");
  for (const std::string folder = rig->folder.path();
       const auto& refused : {StoreUpkeep(school.store.guest()).backup(folder + "/backup.db"),
                              StoreUpkeep(school.store.guest()).exportJson(folder + "/all.json")})
    EXPECT_THAT(refusalOf(refused), StartsWith("Sign in first"));
  EXPECT_FALSE(std::filesystem::exists(rig->folder / "backup.db"));
  EXPECT_FALSE(std::filesystem::exists(rig->folder / "all.json"));

  std::set<std::string> refused, all;
  for (const AuditEntry& entry : valueOf(AuditLog(school.admin).page(1000)))
    if (!entry.allowed && entry.actor.empty()) refused.insert(entry.act);
  for (const store::Rule& rule : store::rules())
    if (rule.guest == store::Reach::None && rule.act != store::Act::ChangeOwnPassword)
      all.insert(std::string(rule.words));
  EXPECT_EQ(refused, all) << "a call that is not in this test, or is not logged when it is refused";
}

TEST_P(StoreAccess, WhatIsDoneToOthersDataIsLoggedAndALookAtOnesOwnIsNot) {
  const School school(rig->open());
  const Target target(school);
  const SignedIn anna = school.as(school.anna), ina = school.as(school.ina);
  const std::int64_t before = valueOf(AuditLog(school.admin).anchor()).number;
  (void)AttemptStore(anna).history(school.anna.id);
  keepAttempt(anna);
  (void)AttemptStore(ina).history(school.anna.id);
  const auto log = valueOf(AuditLog(school.admin).page(2));
  EXPECT_EQ(log[1].number, before + 3) << "after the beginning and the end of the attempt";
  EXPECT_EQ(log[1].act, "see attempts");
  EXPECT_EQ(log[1].actor, school.ina.id);
  EXPECT_EQ(log[1].person, school.anna.id);
  EXPECT_EQ(log[1].workstation, "ward 7");
  EXPECT_EQ(log[1].time_us, rig->now_us);
}

TEST_P(StoreAccess, ALookAtAClassIsOneEntryThatTellsWhoseDataWasSeen) {
  const School school(rig->open());
  keepAttempt(school.as(school.anna));
  const SignedIn ina = school.as(school.ina);
  valueOf(PublishedCurricula(school.admin).publish("central_line", 1, curriculumOf(1)));
  succeed(CohortStore(school.admin).setCurriculum(school.spring.id, "central_line", 1));
  std::vector<std::string> people{school.anna.id, school.carl.id};
  for (int i = 0; i < 30; ++i)
    people.push_back(
        valueOf(PeopleStore(school.admin).add({"more" + std::to_string(i)}, kPassword, school.spring.id)).id);
  people.push_back(school.ben.id);
  const std::int64_t before = valueOf(AuditLog(school.admin).anchor()).number;
  valueOf(CohortStore(ina).members(school.spring.id));
  const auto standings = valueOf(CohortStore(ina).standings(school.spring.id, people));
  EXPECT_EQ(standings.size(), 32U);
  EXPECT_FALSE(standings.contains(school.carl.id)) << "carl learns elsewhere";

  const auto log = valueOf(AuditLog(school.admin).page(3));
  EXPECT_EQ(log[2].number, before + 1) << "an entry for each look, not for each person";
  EXPECT_EQ(log[2].act, "see members");
  EXPECT_EQ(log[2].detail, "cohort " + school.spring.id + ", learners 32");
  EXPECT_EQ(log[1].act, "see standings");
  EXPECT_EQ(log[1].actor, school.ina.id);
  for (const std::string& part : {school.spring.id, school.anna.id, school.ben.id})
    EXPECT_THAT(log[1].detail, HasSubstr(part));
  EXPECT_EQ(valueOf(AuditLog(school.admin).page(2, 0, school.ben.id))[1].number, before + 2)
      << "who looks for ben finds the looks at his class";
  EXPECT_TRUE(AuditLog(school.admin).verify());
}

TEST_P(StoreAccess, ALongReasonDoesNotHideFromTheLogWhatWasDone) {
  const School school(rig->open());
  const std::string attempt = keepAttempt(school.as(school.anna)).id;
  succeed(AttemptStore(school.as(school.ina)).voidAttempt(attempt, std::string(900, 'x')));
  EXPECT_THAT(valueOf(AuditLog(school.admin).page(2))[1].detail, HasSubstr("attempt " + attempt));
  EXPECT_TRUE(AuditLog(school.admin).verify());
}

TEST_P(StoreAccess, AnInstructorGainsNothingByACohort) {
  const School school(rig->open());
  const SignedIn ina = school.as(school.ina), otto = school.as(school.otto);
  succeed(CohortStore(school.admin).join(school.autumn.id, school.ina.id, false));
  EXPECT_FALSE(AttemptStore(ina).history(school.carl.id)) << "who learns beside her is not hers";
  EXPECT_TRUE(AttemptStore(otto).history(school.ina.id)) << "she learns in his";
  EXPECT_THAT(refusalOf(PeopleStore(otto).resetPassword(school.ina.id, "temporary one")),
              StartsWith("You do not have the permission"))
      << "or he could sign in as an instructor of another cohort";
  succeed(CohortStore(school.admin).join(school.autumn.id, school.admin.person().id, false));
  EXPECT_FALSE(PeopleStore(otto).resetPassword(school.admin.person().id, "temporary one"));
  EXPECT_THAT(refusalOf(PeopleStore(ina).resetPassword(school.ina.id, "temporary one")),
              StartsWith("You do not have the permission"));
  EXPECT_FALSE(CohortStore(ina).leave(school.spring.id, school.ina.id)) << "teachers are removed by administrators";
  EXPECT_THAT(refusalOf(CohortStore(school.admin).join(school.spring.id, school.anna.id, true)),
              HasSubstr("cannot teach"));
  const AttemptFacts own = keepAttempt(ina);
  EXPECT_THAT(refusalOf(AttemptStore(ina).voidAttempt(own.id, "bad day")),
              StartsWith("You do not have the permission"));
  EXPECT_TRUE(AttemptStore(otto).voidAttempt(own.id, "device failed"));
}

TEST_P(StoreAccess, ThePersonsCohortsAreThoseThatTheUserMaySee) {
  const School school(rig->open());
  succeed(CohortStore(school.admin).join(school.autumn.id, school.anna.id, false));
  const auto names = [&](const SignedIn& by, const Person& person) {
    std::string all;
    for (const auto& [cohort, teaches] : valueOf(CohortStore(by).listByPerson(person.id)))
      all += cohort.name + (teaches ? " teaches;" : ";");
    return all;
  };
  EXPECT_EQ(names(school.admin, school.anna), "Autumn;Spring;");
  EXPECT_EQ(names(school.as(school.anna), school.anna), "Autumn;Spring;");
  EXPECT_EQ(names(school.as(school.ina), school.anna), "Spring;") << "not a class of another instructor";
  EXPECT_EQ(names(school.as(school.ina), school.ina), "Spring teaches;");
  EXPECT_EQ(names(school.admin, school.admin.person()), "");
}

TEST_P(StoreAccess, AnEmailAddressBelongsToOneAccount) {
  const School school(rig->open());
  const PeopleStore people(school.admin);
  const std::string refusal = "belongs to another account. Use that account, or enter another address.";
  EXPECT_EQ(refusalOf(people.add({"anna2", "Anna Two", "ANNA@example.org", Role::Trainee}, "first password")),
            "The e-mail address ANNA@example.org " + refusal);
  EXPECT_THAT(
      refusalOf(PeopleStore(school.as(school.ina))
                    .add({"carl2", "Carl Two", "carl@example.org", Role::Trainee}, "first password", school.spring.id)),
      HasSubstr(refusal))
      << "also of an account that the instructor cannot see";
  Person ben = school.ben;
  ben.email = school.anna.email;
  EXPECT_THAT(refusalOf(people.change(ben)), HasSubstr(refusal));
  const PeopleStore own(school.as(school.ben));
  EXPECT_THAT(refusalOf(own.changeOwnDetails("Ben", school.anna.email)), HasSubstr(refusal));
  EXPECT_EQ(valueOf(people.all()).size(), 6U);
  EXPECT_TRUE(own.changeOwnDetails("Ben", "BEN@example.org")) << "the own address";
  EXPECT_TRUE(people.add({"nomail1", "A", "", Role::Trainee}, "first password"));
  EXPECT_TRUE(people.add({"nomail2", "B", "", Role::Trainee}, "first password")) << "no address is no address";
}

TEST_P(StoreAccess, AFormIsAboutAnAttemptOfItsPerson) {
  const School school(rig->open());
  const Target target(school);
  const SignedIn ben = school.as(school.ben);
  EXPECT_THAT(refusalOf(FormStore(ben).add({"", "rating", 1, school.ben.id, target.attempt.id, "", 0, "{}"})),
              HasSubstr("not one of the person"));
  FilledForm forged{"", "rating", 1, school.ben.id, "", school.ina.id, 5, "{}"};
  valueOf(FormStore(ben).add(forged));
  EXPECT_EQ(valueOf(FormStore(ben).listByPerson(school.ben.id)).front().filled.by, school.ben.id)
      << "whoever else was named";
}

TEST_P(StoreAccess, WhoLeavesACohortIsNoLongerSeen) {
  const School school(rig->open());
  const AttemptStore ina(school.as(school.ina));
  EXPECT_TRUE(ina.history(school.anna.id));
  succeed(CohortStore(school.admin).leave(school.spring.id, school.anna.id));
  EXPECT_FALSE(ina.history(school.anna.id));
}

}  // namespace
}  // namespace insonate::test
