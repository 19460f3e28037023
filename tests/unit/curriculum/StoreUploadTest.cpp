#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A server of either kind, and workstations with files.
class StoreUpload : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    rig->services.workstation = "server";
    school.emplace(rig->open());
    ward.services.now_us = [this] { return ward.now_us; };
    near.emplace(ward.open());
    valueOf(upload().exchange());
  }
  SiteUpload upload() const { return SiteUpload(*near, school->store); }
  SignedIn here(const Person& person) const { return valueOf(near->signIn(person.name, kPassword)); }

  StoreRig ward;
  std::optional<School> school;  ///< on the server
  std::optional<CurriculumStore> near;
};
INSONATE_ON_BOTH(StoreUpload);

/// Facts that a workstation would send once more if the line broke before the server's confirmation arrived.
void sendAllAgain(const StoreRig& rig) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  succeed((*connection)
              ->script("INSERT INTO outbox SELECT 1000 - arrival, 'attempt', id, 0 FROM attempts;"
                       "INSERT INTO outbox SELECT 2000 - arrival, 'form', id, 0 FROM forms"));
}

TEST_P(StoreUpload, PeopleSignInOnTheWorkstationAsOnTheServer) {
  EXPECT_EQ(here(school->anna).person(), school->anna);
  EXPECT_EQ(valueOf(CohortStore(here(school->ina)).members(school->spring.id)).size(), 3U);
  EXPECT_FALSE(near->signIn("anna", "wrong password"));
}

TEST_P(StoreUpload, AttemptsAndFormsArriveOnceHoweverOftenAndInWhateverOrderTheyAreSent) {
  const SignedIn anna = here(school->anna), ina = here(school->ina);
  std::vector<AttemptFacts> attempts;
  for (int i = 0; i < 5; ++i) attempts.push_back(keepAttempt(anna));
  valueOf(FormStore(anna).add({"", "feedback", 1, school->anna.id, attempts[2].id, "", 0, "{}"}));
  succeed(AttemptStore(ina).voidAttempt(attempts[2].id, "device failed"));
  EXPECT_EQ(valueOf(upload().pending()), 6);
  const UploadReport report = valueOf(upload().exchange());
  EXPECT_EQ(report.attempts, 5);
  EXPECT_EQ(report.forms, 1);
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_EQ(valueOf(upload().pending()), 0);

  const auto serverHas = [&] {
    std::vector<StoredAttempt> kept;
    for (const AttemptFacts& facts : attempts) kept.push_back(valueOf(AttemptStore(school->admin).attempt(facts.id)));
    return kept;
  };
  const auto first = serverHas();
  EXPECT_EQ(first[2].facts.state, AttemptState::Voided);
  EXPECT_EQ(first[2].voidReason, "device failed");
  EXPECT_EQ(first[0].facts.workstation, "ward 7");
  EXPECT_EQ(first[0].facts.metrics, attempts[0].metrics);

  sendAllAgain(ward);
  EXPECT_THAT(valueOf(upload().exchange()).errors, IsEmpty());
  EXPECT_EQ(serverHas(), first);
  const insonate::StoreFacts facts = valueOf(StoreUpkeep(school->admin).facts());
  EXPECT_EQ(facts.attempts, 5);
  EXPECT_EQ(facts.forms, 1);
  succeed(StoreUpkeep(school->admin).verify());
}

TEST_P(StoreUpload, AnAttemptThatGoesOnIsSentAgainAsItIsThen) {
  const SignedIn anna = here(school->anna);
  const AttemptFacts facts = begunFacts();
  const auto onServer = [&] { return valueOf(AttemptStore(school->admin).attempt(facts.id)).facts.state; };
  valueOf(AttemptStore(anna).begin(facts));
  valueOf(upload().exchange());
  EXPECT_EQ(onServer(), AttemptState::Open);
  (void)rig->open();
  EXPECT_EQ(onServer(), AttemptState::Open) << "a server does not tell what workstations do";
  succeed(AttemptStore(anna).end(endedFacts(facts)));
  valueOf(upload().exchange());
  EXPECT_EQ(onServer(), AttemptState::Completed);
}

TEST_P(StoreUpload, WhatIsVoidedOnTheServerIsVoidedHere) {
  const SignedIn anna = here(school->anna);
  const AttemptFacts facts = keepAttempt(anna);
  valueOf(upload().exchange());
  succeed(AttemptStore(school->as(school->ina)).voidAttempt(facts.id, "wrong case"));
  valueOf(upload().exchange());
  EXPECT_EQ(valueOf(AttemptStore(anna).attempt(facts.id)).voidReason, "wrong case");
}

TEST_P(StoreUpload, TheServerDecidesRolesAndCohorts) {
  const SignedIn ina = here(school->ina);
  EXPECT_TRUE(AttemptStore(ina).history(school->anna.id));
  Person changed = school->ina;
  changed.role = Role::Trainee;
  succeed(PeopleStore(school->admin).change(changed));
  const UploadReport report = valueOf(upload().exchange());
  EXPECT_EQ(report.people, 1);
  EXPECT_FALSE(AttemptStore(ina).history(school->anna.id));

  const SignedIn admin = here(school->admin.person());
  EXPECT_THAT(refusalOf(PeopleStore(admin).add({"new"}, kPassword)), HasSubstr("change them there"));
  EXPECT_THAT(refusalOf(PeopleStore(admin).change(school->anna)), HasSubstr("change them there"));
  EXPECT_THAT(refusalOf(PublishedCurricula(admin).publish("central_line", 1, curriculumOf(1))),
              HasSubstr("change them there"));
}

TEST_P(StoreUpload, AnArchivedCohortIsArchivedHereAndADeletedOneIsGone) {
  valueOf(upload().exchange());
  succeed(CohortStore(school->admin).join(school->autumn.id, school->anna.id, false));
  succeed(CohortStore(school->admin).archive(school->spring.id, true));
  valueOf(upload().exchange());
  const auto cohorts = [&] { return valueOf(CohortStore(here(school->anna)).cohorts()); };
  ASSERT_EQ(cohorts().size(), 2U);
  EXPECT_EQ(cohorts()[0].name, "Autumn");
  EXPECT_TRUE(cohorts()[1].archived);
  succeed(CohortStore(school->admin).remove(school->spring.id, "Spring"));
  valueOf(upload().exchange());
  ASSERT_EQ(cohorts().size(), 1U);
  EXPECT_EQ(cohorts().front().name, "Autumn");
}

TEST_P(StoreUpload, NamesThatChangePlacesArrive) {
  const PeopleStore people(school->admin);
  Person anna = school->anna, ben = school->ben;
  anna.name = "away";
  succeed(people.change(anna));
  ben.name = "anna";
  succeed(people.change(ben));
  anna.name = "ben";
  succeed(people.change(anna));
  valueOf(upload().exchange());
  EXPECT_EQ(valueOf(near->signIn("ben", kPassword)).person().id, school->anna.id);
  EXPECT_EQ(valueOf(near->signIn("anna", kPassword)).person().id, school->ben.id);
}

TEST_P(StoreUpload, APasswordChangedHereGoesUpAndOneSetOnTheServerWins) {
  succeed(PeopleStore(here(school->anna)).changeOwnPassword(kPassword, "changed in the ward"));
  valueOf(upload().exchange());
  EXPECT_TRUE(school->store.signIn("anna", "changed in the ward"));
  EXPECT_TRUE(near->signIn("anna", "changed in the ward"));

  succeed(PeopleStore(here(school->ben)).changeOwnPassword(kPassword, "changed in the ward"));
  succeed(PeopleStore(school->admin).resetPassword(school->ben.id, "set on the server"));
  valueOf(upload().exchange());
  EXPECT_TRUE(school->store.signIn("ben", "set on the server"));
  EXPECT_TRUE(near->signIn("ben", "set on the server"));
  EXPECT_FALSE(near->signIn("ben", "changed in the ward"));
}

TEST_P(StoreUpload, CurriculaComeDownAndADifferentOneOfTheSameNumberIsTold) {
  valueOf(PublishedCurricula(school->admin).publish("central_line", 1, curriculumOf(1, "server")));
  succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "central_line", 1));
  EXPECT_EQ(valueOf(upload().exchange()).curricula, 1);
  EXPECT_EQ(valueOf(PublishedCurricula(near->guest()).text("central_line", 1)), curriculumOf(1, "server"));
  EXPECT_EQ(valueOf(CohortStore(here(school->anna)).cohorts()).front().curriculumVersion, 1);
}

TEST_P(StoreUpload, WhoWasOnlyHereGoesUpAsADisabledTraineeWithAllTheyDid) {
  StoreRig lone;
  lone.services.workstation = "ward 9";
  const CurriculumStore alone = lone.open();
  const SignedIn boss = valueOf(alone.createFirstAdministrator({"anna", "Another Anna"}, kPassword));
  valueOf(PublishedCurricula(boss).publish("central_line", 1, curriculumOf(1, "ward 9")));
  valueOf(PublishedCurricula(school->admin).publish("central_line", 1, curriculumOf(1, "server")));
  const AttemptFacts facts = keepAttempt(boss);

  const UploadReport report = valueOf(SiteUpload(alone, school->store).exchange());
  EXPECT_EQ(report.attempts, 1);
  EXPECT_THAT(report.errors, ElementsAre(HasSubstr("already has another person 'anna'"), HasSubstr("disabled trainee"),
                                         HasSubstr("differs")));
  EXPECT_EQ(valueOf(AttemptStore(school->admin).attempt(facts.id)).facts.person, boss.person().id);
  Person there = valueOf(PeopleStore(school->admin).person(boss.person().id));
  EXPECT_EQ(there.name, "anna-2");
  EXPECT_TRUE(there.disabled);
  EXPECT_FALSE(AttemptStore(boss).history(boss.person().id)) << "here, too";
  EXPECT_TRUE(alone.signIn("admin", kPassword)) << "the server's administrator looks after this workstation";
  there.disabled = false;
  succeed(PeopleStore(school->admin).change(there));
  valueOf(SiteUpload(alone, school->store).exchange());
  EXPECT_TRUE(alone.signIn("anna-2", kPassword));
}

TEST_P(StoreUpload, AnInterruptedUploadGoesOnWhereItStopped) {
  const SignedIn anna = here(school->anna);
  for (int i = 0; i < 450; ++i) valueOf(AttemptStore(anna).begin(begunFacts()));
  int asked = 0;
  const auto stopped = upload().exchange([&](std::string_view, double) { return ++asked < 3; });
  EXPECT_EQ(refusalOf(stopped), kCancelled);
  EXPECT_EQ(valueOf(upload().pending()), 50) << "two batches are there";
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).attempts, 400);
  valueOf(upload().exchange());
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).attempts, 450);
  EXPECT_EQ(valueOf(AttemptStore(anna).history(school->anna.id)).size(), 450U) << "what was sent stays here";

  std::vector<std::string> orderHere, orderThere;
  for (const AttemptFacts& facts : valueOf(AttemptStore(anna).history(school->anna.id))) orderHere.push_back(facts.id);
  for (const AttemptFacts& facts : valueOf(AttemptStore(school->admin).history(school->anna.id)))
    orderThere.push_back(facts.id);
  EXPECT_EQ(orderThere, orderHere);
}

TEST_P(StoreUpload, WithoutItsServerAWorkstationGoesOn) {
  keepAttempt(here(school->anna));
  if (GetParam() == Place::Server) {
    PostgresServer::shared()->crash();
    EXPECT_THAT(refusalOf(upload().exchange()), HasSubstr("cannot be reached"));
    EXPECT_THAT(refusalOf(CurriculumStore::open(rig->address)), HasSubstr("cannot be reached"));
    PostgresServer::shared()->start();
  }
  EXPECT_EQ(valueOf(upload().pending()), 1);
  EXPECT_EQ(valueOf(upload().exchange()).attempts, 1);
}

TEST_P(StoreUpload, WrongServersAreRefused) {
  StoreRig empty;
  EXPECT_THAT(refusalOf(SiteUpload(*near, empty.open()).exchange()), HasSubstr("has no people yet"));
  EXPECT_THAT(refusalOf(SiteUpload(*near, *near).exchange()), HasSubstr("its own server"));
  const School other(empty.open());
  EXPECT_THAT(refusalOf(SiteUpload(*near, other.store).exchange()), HasSubstr("belongs to"));
}

TEST_P(StoreUpload, TheServersLogHoldsWhereTheWorkstationsEnded) {
  keepAttempt(here(school->anna));
  valueOf(upload().exchange());
  const AuditEntry entry = valueOf(AuditLog(school->admin).page(2)).back();
  EXPECT_EQ(entry.act, "upload");
  EXPECT_THAT(entry.detail, HasSubstr("whose log ends at"));
}

}  // namespace
}  // namespace insonate::test
