#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/ClassImport.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PublishedCurricula.h>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Curricula, cohorts and forms.
class StoreFacts : public OnBoth {};
INSONATE_ON_BOTH(StoreFacts);

TEST_P(StoreFacts, AStatementIsKnownByItsTextAndNotByWhereThatLies) {
  rig->open();
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address)));
  ASSERT_TRUE(connection);
  std::string sql = "SELECT 1";
  EXPECT_EQ(valueOf((*connection)->rows(sql, {})).at(0).number(0), 1);
  sql.back() = '2';
  EXPECT_EQ(valueOf((*connection)->rows(sql, {})).at(0).number(0), 2);
}

TEST_P(StoreFacts, WhatIsKeptIsOnTheDiskOfItsTypeAndPointsSomewhere) {
  rig->open();
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address)));
  ASSERT_TRUE(connection);
  const auto told = [&](const std::string& sql) { return valueOf((*connection)->rows(sql, {})).at(0).text(0); };
  if (GetParam() == Place::Server) {
    EXPECT_EQ(told("SELECT current_setting('synchronous_commit')"), "on");
  } else {
    EXPECT_EQ(told("PRAGMA journal_mode"), "wal");
    EXPECT_EQ(told("PRAGMA synchronous"), "2") << "full";
    EXPECT_EQ(told("PRAGMA foreign_keys"), "1");
    EXPECT_EQ(told("SELECT COUNT(*) FROM pragma_table_list WHERE schema = 'main' AND type = 'table' AND strict = 0 "
                   "AND name NOT LIKE 'sqlite%'"),
              "0")
        << "every table is STRICT";
    EXPECT_GT(std::stoi(told("SELECT COUNT(*) FROM pragma_table_list WHERE strict = 1")), 10);
  }
  EXPECT_FALSE((*connection)->run("INSERT INTO memberships (cohort, person, teaches) VALUES ('x', 'y', 0)", {}))
      << "of nobody";
}

TEST_P(StoreFacts, APublishedVersionIsFixedAndLaterOnesGrow) {
  const School school(rig->open());
  const PublishedCurricula ina(school.as(school.ina));
  const CurriculumEntry first = valueOf(ina.publish("central_line", 1, curriculumOf(1)));
  EXPECT_EQ(first.hash.size(), 64U);
  EXPECT_EQ(first.publishedBy, "Dr ina");
  rig->now_us += kDay_us;
  EXPECT_EQ(valueOf(ina.publish("central_line", 1, curriculumOf(1))), first) << "the same text once more";
  EXPECT_THAT(refusalOf(ina.publish("central_line", 1, curriculumOf(1, "Easier"))), HasSubstr("cannot be changed"));
  valueOf(ina.publish("central_line", 3, curriculumOf(3)));
  EXPECT_THAT(refusalOf(ina.publish("central_line", 2, curriculumOf(2))),
              HasSubstr("Version 3 of 'central_line' is published"));
  EXPECT_EQ(valueOf(PublishedCurricula(school.store.guest()).text("central_line", 1)), curriculumOf(1));
  std::vector<int> versions;
  for (const CurriculumEntry& entry : valueOf(ina.list())) versions.push_back(entry.version);
  EXPECT_THAT(versions, ElementsAre(3, 1));
}

TEST_P(StoreFacts, WhatIsNoCurriculumIsNotPublished) {
  const School school(rig->open());
  const PublishedCurricula admin(school.admin);
  EXPECT_FALSE(admin.publish("central_line", 1, "{}"));
  EXPECT_FALSE(admin.publish("central_line", 1, "no JSON"));
  EXPECT_THAT(refusalOf(admin.publish("central_line", 2, curriculumOf(1))), HasSubstr("not version 2"));
  EXPECT_THAT(refusalOf(admin.publish("other", 1, curriculumOf(1))), HasSubstr("of 'other'"));
  EXPECT_THAT(refusalOf(admin.publish("central_line", 1, std::string(1'000'001, ' '))), HasSubstr("Shorten"));
  EXPECT_THAT(valueOf(admin.list()), IsEmpty());
}

TEST_P(StoreFacts, ADraftIsSharedReplacedAndDiscarded) {
  const School school(rig->open());
  const PublishedCurricula ina(school.as(school.ina)), otto(school.as(school.otto));
  const std::string half = "{ half of a curriculum";
  succeed(ina.saveDraft("next year", half, ""));
  succeed(otto.saveDraft("next year", curriculumOf(4), half));
  EXPECT_EQ(valueOf(ina.draft("next year")), curriculumOf(4));
  EXPECT_THAT(valueOf(ina.drafts()), ElementsAre("next year"));
  succeed(ina.discardDraft("next year", curriculumOf(4)));
  EXPECT_THAT(refusalOf(otto.draft("next year")), HasSubstr("no draft named"));
  EXPECT_THAT(refusalOf(otto.discardDraft("next year", "")), HasSubstr("no draft named"));
}

TEST_P(StoreFacts, TwoWhoEditADraftDoNotOverwriteEachOther) {
  const School school(rig->open());
  const PublishedCurricula ina(school.as(school.ina)), otto(school.as(school.otto));
  succeed(ina.saveDraft("shared", "one", ""));
  EXPECT_THAT(refusalOf(otto.saveDraft("shared", "two", "")), HasSubstr("Another user has saved"));
  succeed(otto.saveDraft("shared", "two", "one"));
  EXPECT_THAT(refusalOf(ina.saveDraft("shared", "three", "one")), HasSubstr("reload it"));
  EXPECT_THAT(refusalOf(ina.discardDraft("shared", "one")), HasSubstr("Another user has saved"));
  EXPECT_EQ(valueOf(ina.draft("shared")), "two");
  succeed(otto.discardDraft("shared", "two"));
  EXPECT_THAT(refusalOf(ina.saveDraft("shared", "four", "two")), HasSubstr("discarded or published"));
}

TEST_P(StoreFacts, ACohortIsTaughtByAPublishedVersion) {
  const School school(rig->open());
  const CohortStore ina(school.as(school.ina));
  EXPECT_THAT(refusalOf(ina.setCurriculum(school.spring.id, "central_line", 1)), HasSubstr("is not published"));
  valueOf(PublishedCurricula(school.admin).publish("central_line", 1, curriculumOf(1)));
  succeed(ina.setCurriculum(school.spring.id, "central_line", 1));
  EXPECT_THAT(valueOf(ina.cohorts()), ElementsAre(Cohort{school.spring.id, "Spring", "central_line", 1}));
  EXPECT_EQ(valueOf(CohortStore(school.admin).cohorts()).size(), 2U);
  EXPECT_THAT(valueOf(CohortStore(school.as(school.carl)).cohorts()), ElementsAre(school.autumn));
}

TEST_P(StoreFacts, NamesOfCohortsAreTold) {
  const School school(rig->open());
  const CohortStore admin(school.admin);
  EXPECT_THAT(refusalOf(admin.add("SPRING")), HasSubstr("already"));
  EXPECT_THAT(refusalOf(admin.rename(school.autumn.id, "spring")), HasSubstr("already"));
  EXPECT_THAT(refusalOf(admin.add("")), HasSubstr("no name"));
  EXPECT_THAT(refusalOf(admin.add("a\nb")), HasSubstr("line break"));
  succeed(admin.rename(school.spring.id, "SPRING"));
  EXPECT_EQ(valueOf(admin.add("'; DROP TABLE cohorts; --")).name, "'; DROP TABLE cohorts; --");
  for (const std::string& id : {std::string("nosuch"), freshUuid(), std::string(1 << 20, 'x')}) {
    EXPECT_THAT(refusalOf(admin.rename(id, "Other")), HasSubstr("no such class"));
    EXPECT_THAT(refusalOf(admin.join(id, school.anna.id, false)), HasSubstr("no such class"));
    EXPECT_THAT(refusalOf(admin.join(school.spring.id, id, false)), HasSubstr("no such person"));
    EXPECT_THAT(refusalOf(PeopleStore(school.admin).add({"new"}, kPassword, id)), HasSubstr("no such class"));
  }
}

TEST_P(StoreFacts, MembersAreTeachersFirst) {
  const School school(rig->open());
  std::vector<std::string> names;
  for (const Member& member : valueOf(CohortStore(school.as(school.ina)).members(school.spring.id)))
    names.push_back(member.person.name + (member.teaches ? " teaches" : ""));
  EXPECT_THAT(names, ElementsAre("ina teaches", "anna", "ben"));
}

TEST_P(StoreFacts, FormsAreKeptByteForByteOnceAndInTheirOrder) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna), ina = school.as(school.ina);
  const AttemptFacts attempt = keepAttempt(anna);
  const std::string answers = "{ \"comment\": \"it's \\\"fine\\\" 💉\",\n \"realism\": 4 }";
  FilledForm own{freshUuid(), "feedback", 2, school.anna.id, "", "", 0, answers};
  EXPECT_EQ(valueOf(FormStore(anna).add(own)), own.id);
  rig->now_us -= kDay_us;
  EXPECT_EQ(valueOf(FormStore(anna).add(own)), own.id) << "the same once more";
  valueOf(FormStore(ina).add({"", "checklist", 1, school.anna.id, attempt.id, "", 0, "{}"}));
  const auto forms = valueOf(FormStore(anna).listByPerson(school.anna.id));
  ASSERT_EQ(forms.size(), 2U);
  own.by = school.anna.id;
  own.filled_us = rig->now_us + kDay_us;
  EXPECT_EQ(forms[0], (StoredForm{own, "Dr anna"}));
  EXPECT_EQ(forms[1].filled.by, school.ina.id);
  EXPECT_EQ(valueOf(FormStore(ina).listByAttempt(attempt.id)).size(), 1U);
  EXPECT_EQ(valueOf(FormStore(ina).listByCohort(school.spring.id, "feedback")).size(), 1U);
  own.answers = "{}";
  EXPECT_THAT(refusalOf(FormStore(anna).add(own)), HasSubstr("cannot be changed"));
}

TEST_P(StoreFacts, WhatIsNoFormIsRefused) {
  const School school(rig->open());
  const FormStore anna(school.as(school.anna));
  const auto refusal = [&](auto change) {
    FilledForm form{"", "feedback", 1, school.anna.id, "", "", 0, "{}"};
    change(form);
    return refusalOf(anna.add(form));
  };
  EXPECT_THAT(refusal([](auto& f) { f.answers = "[]"; }), HasSubstr("not a JSON object"));
  EXPECT_THAT(refusal([](auto& f) { f.answers = "{"; }), HasSubstr("not a JSON object"));
  EXPECT_THAT(refusal([](auto& f) { f.answers = "{\"a\": \"" + std::string(1'000'000, 'x') + "\"}"; }),
              HasSubstr("Shorten"));
  EXPECT_THAT(refusal([](auto& f) { f.answers = "{\"a\": \"\xff\"}"; }), HasSubstr("UTF-8"));
  EXPECT_THAT(refusal([](auto& f) { f.answers = std::string("{}\0", 3); }), HasSubstr("zero byte"));
  EXPECT_THAT(refusal([](auto& f) { f.form = ""; }), HasSubstr("no name"));
  EXPECT_THAT(refusal([](auto& f) { f.attempt = freshUuid(); }), HasSubstr("not one of the person"));
  EXPECT_THAT(refusal([](auto& f) { f.id = "7"; }), HasSubstr("UUID"));
  EXPECT_THAT(valueOf(anna.listByPerson(school.anna.id)), IsEmpty());
}

TEST_P(StoreFacts, AZeroByteIsRefusedOrKeptOutWhereverATextIsTaken) {
  const School school(rig->open());
  const std::string zero("a\0b", 3), mail("a@b\0", 4), password("12345678\0", 9);
  const PeopleStore people(school.admin);
  const CohortStore cohorts(school.admin);
  const SignedIn anna = school.as(school.anna);
  const AttemptFacts kept = keepAttempt(anna);
  const auto expectRefused = [](const auto& result, const char* what) {
    EXPECT_THAT(refusalOf(result), HasSubstr("zero byte")) << what;
  };
  expectRefused(people.add({zero, "X"}, kPassword), "name");
  expectRefused(people.add({"x", zero}, kPassword), "full name");
  expectRefused(people.add({"x", "X", mail}, kPassword), "e-mail");
  expectRefused(people.add({"x", "X"}, password), "password");
  expectRefused(PeopleStore(anna).changeOwnDetails(zero, ""), "own name");
  expectRefused(PeopleStore(anna).changeOwnPassword(kPassword, password), "own password");
  expectRefused(cohorts.add(zero), "class");
  expectRefused(cohorts.rename(school.spring.id, zero), "class's name");
  AttemptFacts attempt = begunFacts();
  attempt.caseName = zero;
  expectRefused(AttemptStore(anna).begin(attempt), "case");
  attempt.caseName = "neck";
  valueOf(AttemptStore(anna).begin(attempt));
  attempt = endedFacts(attempt);
  attempt.recording = zero;
  expectRefused(AttemptStore(anna).end(attempt), "recording");
  attempt.recording = "a.rec", attempt.metrics.front().id = zero;
  expectRefused(AttemptStore(anna).end(attempt), "metric");
  expectRefused(AttemptStore(school.admin).voidAttempt(kept.id, zero), "reason");
  expectRefused(FormStore(anna).add({"", "feedback", 1, school.anna.id, "", "", 0, R"({"a": "x\u0000y"})"}), "answer");
  expectRefused(FormStore(anna).add({"", "feedback", 1, school.anna.id, "", "", 0, R"({"a\u0000": "x"})"}), "key");
  const PublishedCurricula curricula(school.admin);
  expectRefused(curricula.publish("central_line", 1, curriculumOf(1) + zero), "curriculum");
  expectRefused(curricula.publish("central_line", 1, curriculumOf(1, zero)), "its title");
  expectRefused(curricula.saveDraft("next", zero, ""), "draft");
  const std::vector<ClassImportRow> plan{{2, {"zoe", zero}, ClassImportRow::Step::Add}};
  expectRefused(ClassImport(school.admin).apply(school.spring.id, plan, ClassImport::passwordsFor(plan)), "class list");
  // A search text reaches a server without a zero.
  EXPECT_FALSE(people.person(zero));
  EXPECT_EQ(valueOf(AuditLog(school.admin).page(10, 0, zero)).size(), 1U) << "that somebody looked";
  succeed(AuditLog(school.admin).verify());
}

}  // namespace
}  // namespace insonate::test
