#include "StoreRig.h"
#include "store/sql/Address.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using enum TestConditions;

constexpr std::int64_t kMinute_us = 60 * kSecond_us, kHour_us = 60 * kMinute_us;

Curriculum examCourse(int version = 1) {
  Level exam = levelNamed("exam", 1);
  exam.assistance = Assistance::Test;
  Curriculum course = courseOf({levelNamed("a", 1), exam});
  course.version = version;
  return course;
}

/// Spring and autumn learn a course with the test "exam", which one pass masters.
struct ExamSchool : School {
  explicit ExamSchool(const CurriculumStore& in) : School(in) {
    valueOf(PublishedCurricula(admin).publish("course", 1, curriculumText(examCourse())));
    for (const Cohort& cohort : {spring, autumn}) succeed(CohortStore(admin).setCurriculum(cohort.id, "course", 1));
  }
  TestOpening opened(const NewOpening& opening) const { return valueOf(OpeningStore(as(ina)).open(opening)); }
  int masteredBy(const Person& person) const {
    for (const Member& row : valueOf(CohortStore(as(ina)).members(spring.id)))
      if (row.person.id == person.id) return row.standing ? row.standing->mastered : -1;
    throw std::runtime_error("not in the cohort");
  }
};

AttemptFacts passAt(std::int64_t begun_us, const std::string& level = "exam") {
  AttemptFacts facts = passedAttempt(level, begun_us);
  facts.id = freshUuid(), facts.person = {}, facts.caseName = "textbook";
  return facts;
}

TestConditions sittingOf(const SignedIn& by, const std::string& id) {
  return valueOf(AttemptStore(by).attempt(id)).facts.testConditions;
}

class StoreOpenings : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!IsSkipped()) school.emplace(rig->open());
  }
  NewOpening hourFrom(std::int64_t start_us, const std::string& code = {}) const {
    return {.cohort = school->spring.id,
            .level = "exam",
            .start_us = start_us,
            .end_us = start_us + kHour_us,
            .code = code};
  }
  /// Begins, ends and passes now.
  TestConditions sittingNow(const SignedIn& by, const std::string& level = "exam") const {
    const AttemptFacts facts = passAt(rig->now_us, level);
    valueOf(AttemptStore(by).begin(facts));
    succeed(AttemptStore(by).end(facts));
    return sittingOf(by, facts.id);
  }
  TestAdmission::Kind kindFor(const SignedIn& by) const {
    return valueOf(OpeningStore(by).admission("course", "exam")).kind;
  }

  std::optional<ExamSchool> school;
};
INSONATE_ON_BOTH(StoreOpenings);

TEST_P(StoreOpenings, ATestThatWasNeverOpenedIsPracticeAndOtherLevelsCountAsBefore) {
  const SignedIn anna = school->as(school->anna);
  EXPECT_EQ(kindFor(anna), TestAdmission::Kind::Closed);
  EXPECT_EQ(sittingNow(anna), Practice);
  EXPECT_EQ(school->masteredBy(school->anna), 0);
  EXPECT_THAT(valueOf(AttemptStore(school->as(school->ina)).recentOfCohort(school->spring.id, 5)), IsEmpty())
      << "figures of the class leave practice out";
  EXPECT_EQ(sittingNow(anna, "a"), None);
  EXPECT_EQ(school->masteredBy(school->anna), 1);
  EXPECT_EQ(valueOf(AttemptStore(school->as(school->ina)).recentOfCohort(school->spring.id, 5)).size(), 1U);
}

TEST_P(StoreOpenings, AnAttemptThatBeginsWhileTheTestIsOpenCounts) {
  const SignedIn anna = school->as(school->anna), carl = school->as(school->carl);
  const TestOpening opening = school->opened(hourFrom(rig->now_us + kHour_us));
  EXPECT_EQ(stateAt(opening, rig->now_us), OpeningState::Waiting);
  EXPECT_EQ(valueOf(OpeningStore(anna).admission("course", "exam")),
            (TestAdmission{.kind = TestAdmission::Kind::Closed, .next_us = opening.start_us}));
  EXPECT_EQ(sittingNow(anna), Practice) << "before its start";
  rig->pass(kHour_us);
  EXPECT_EQ(valueOf(OpeningStore(anna).admission("course", "exam")),
            (TestAdmission{.kind = TestAdmission::Kind::Open, .end_us = opening.end_us}));
  EXPECT_EQ(sittingNow(carl), Practice) << "of another class";
  rig->pass(kHour_us - kSecond_us);
  const AttemptFacts late = passAt(rig->now_us);
  valueOf(AttemptStore(anna).begin(late));
  EXPECT_EQ(school->masteredBy(school->anna), 0);
  rig->pass(kMinute_us);
  succeed(AttemptStore(anna).end(late));
  EXPECT_EQ(sittingOf(anna, late.id), Opened) << "it began inside and ended after the end";
  EXPECT_EQ(school->masteredBy(school->anna), 1);
  EXPECT_EQ(sittingNow(anna), Practice) << "after its end";
  EXPECT_EQ(stateAt(opening, rig->now_us), OpeningState::Ended);
}

TEST_P(StoreOpenings, ClosingEndsAnOpeningButNoAttempt) {
  const SignedIn anna = school->as(school->anna), ina = school->as(school->ina);
  const TestOpening opening = school->opened(hourFrom(rig->now_us));
  const AttemptFacts running = passAt(rig->now_us);
  valueOf(AttemptStore(anna).begin(running));
  rig->pass(kMinute_us);
  succeed(OpeningStore(ina).close(school->spring.id, opening.id));
  succeed(AttemptStore(anna).end(running));
  EXPECT_EQ(sittingOf(anna, running.id), Opened);
  EXPECT_EQ(sittingNow(anna), Practice);
  const auto listed = valueOf(OpeningStore(ina).listByCohort(school->spring.id));
  ASSERT_EQ(listed.size(), 1U);
  EXPECT_EQ(listed[0].closed_us, rig->now_us);
  EXPECT_EQ(listed[0].closedBy, "Dr ina");
  EXPECT_EQ(listed[0].openedBy, "Dr ina");
  rig->pass(kMinute_us);
  succeed(OpeningStore(ina).close(school->spring.id, opening.id));
  EXPECT_EQ(valueOf(OpeningStore(ina).listByCohort(school->spring.id)), listed) << "closed once";
  EXPECT_THAT(refusalOf(OpeningStore(school->as(school->otto)).close(school->autumn.id, opening.id)),
              HasSubstr("no such opening"));
}

TEST_P(StoreOpenings, TheCodeIsAskedForOncePerOpening) {
  const SignedIn anna = school->as(school->anna), ben = school->as(school->ben);
  school->opened(hourFrom(rig->now_us, " Jugular 7 "));
  EXPECT_EQ(kindFor(anna), TestAdmission::Kind::NeedsCode);
  EXPECT_EQ(sittingNow(anna), Practice) << "without the code";
  EXPECT_EQ(refusalOf(OpeningStore(anna).enterCode("course", "exam", "jugular 8")),
            "The code is wrong. Ask the instructor for the code of this test.");
  EXPECT_EQ(valueOf(OpeningStore(anna).enterCode("course", "exam", "jugular 7")).kind, TestAdmission::Kind::Open);
  EXPECT_EQ(sittingNow(anna), Opened);
  EXPECT_EQ(sittingNow(anna), Opened) << "a second attempt";
  EXPECT_EQ(sittingNow(ben), Practice) << "another trainee";
  EXPECT_EQ(valueOf(OpeningStore(anna).enterCode("course", "exam", "whatever")).kind, TestAdmission::Kind::Open)
      << "no code is needed anymore";
  rig->pass(2 * kHour_us);
  school->opened(hourFrom(rig->now_us, "jugular 7"));
  EXPECT_EQ(kindFor(anna), TestAdmission::Kind::NeedsCode) << "another opening";
  std::vector<std::string> entries;
  for (const AuditEntry& entry : valueOf(AuditLog(school->admin).page(100)))
    if (entry.act == "enter test code") entries.push_back(entry.allowed ? "right" : "wrong");
  EXPECT_THAT(entries, ElementsAre("right", "wrong"));
}

TEST_P(StoreOpenings, WrongCodesLockTheTestForThePersonAlone) {
  const SignedIn anna = school->as(school->anna), ben = school->as(school->ben);
  school->opened(hourFrom(rig->now_us, "jugular"));
  for (int i = 0; i < 5; ++i)
    EXPECT_THAT(refusalOf(OpeningStore(anna).enterCode("course", "exam", "guess")), HasSubstr("is wrong"));
  EXPECT_EQ(refusalOf(OpeningStore(anna).enterCode("course", "exam", "jugular")),
            "There were too many wrong codes. Try again in 30 s.");
  EXPECT_EQ(valueOf(OpeningStore(ben).enterCode("course", "exam", "jugular")).kind, TestAdmission::Kind::Open);
  EXPECT_TRUE(school->store.signIn("anna", kPassword)) << "the password is another matter";
  rig->pass(31 * kSecond_us);
  EXPECT_EQ(valueOf(OpeningStore(anna).enterCode("course", "exam", "jugular")).kind, TestAdmission::Kind::Open);
}

TEST_P(StoreOpenings, OfTwoAtOnceEitherOpensTheTest) {
  const SignedIn anna = school->as(school->anna), ben = school->as(school->ben);
  school->opened(hourFrom(rig->now_us, "first code"));
  school->opened({.cohort = school->spring.id, .level = "exam", .code = "second code"});
  EXPECT_EQ(valueOf(OpeningStore(anna).enterCode("course", "exam", "second code")),
            (TestAdmission{.kind = TestAdmission::Kind::Open, .end_us = std::nullopt}));
  EXPECT_EQ(valueOf(OpeningStore(ben).enterCode("course", "exam", "first code")).kind, TestAdmission::Kind::Open);
  rig->pass(2 * kHour_us);
  EXPECT_EQ(sittingNow(anna), Opened) << "it has no end";
  EXPECT_EQ(kindFor(ben), TestAdmission::Kind::NeedsCode);
  school->opened(hourFrom(rig->now_us));
  EXPECT_EQ(sittingNow(ben), Opened) << "one without a code is enough";
}

TEST_P(StoreOpenings, AnAdministratorOpensATestForEveryone) {
  NewOpening everyone = hourFrom(rig->now_us);
  everyone.cohort.clear();
  EXPECT_THAT(refusalOf(OpeningStore(school->as(school->ina)).open(everyone)), HasSubstr("permission"));
  EXPECT_THAT(refusalOf(OpeningStore(school->admin).open(everyone)), HasSubstr("is not published"));
  everyone.curriculum = "course";
  const TestOpening opening = valueOf(OpeningStore(school->admin).open(everyone));
  EXPECT_EQ(sittingNow(school->as(school->anna)), Opened);
  EXPECT_EQ(sittingNow(school->as(school->carl)), Opened);
  EXPECT_THAT(valueOf(OpeningStore(school->as(school->otto)).listByCohort(school->autumn.id)), ElementsAre(opening));
  EXPECT_THAT(valueOf(OpeningStore(school->admin).all()), ElementsAre(opening));
}

TEST_P(StoreOpenings, APersonWithoutAClassTakesTestsAlone) {
  const SignedIn lone = school->as(school->add("lone", Role::Trainee, ""));
  EXPECT_EQ(kindFor(lone), TestAdmission::Kind::SelfAdministered);
  EXPECT_EQ(sittingNow(lone), SelfAdministered);
  AttemptFacts builtIn = passAt(rig->now_us, "jugular_test");
  builtIn.curriculum = "central_line", builtIn.curriculumVersion = valueOf(loadCurriculum("central_line")).version;
  valueOf(AttemptStore(lone).begin(builtIn));
  EXPECT_EQ(sittingOf(lone, builtIn.id), SelfAdministered) << "of the built-in curriculum, which is not published";
  const Cohort own = valueOf(CohortStore(school->admin).add("Own training"));
  succeed(CohortStore(school->admin).join(own.id, lone.person().id, false));
  EXPECT_EQ(sittingNow(lone), SelfAdministered) << "in a class of one";
  succeed(CohortStore(school->admin).join(own.id, school->otto.id, true));
  EXPECT_EQ(sittingNow(lone), Practice) << "an instructor opens the tests now";
}

TEST_P(StoreOpenings, ABeginningThatArrivesLateIsDecidedByTheEnd) {
  const SignedIn anna = school->as(school->anna);
  const std::int64_t start_us = rig->now_us + kHour_us;
  school->opened(hourFrom(start_us));
  rig->pass(kHour_us + 30 * kMinute_us);
  const AttemptFacts before = passAt(start_us - kMinute_us);
  valueOf(AttemptStore(anna).begin(before));
  EXPECT_EQ(sittingOf(anna, before.id), Undecided) << "the test is open now";
  succeed(AttemptStore(anna).end(before));
  EXPECT_EQ(sittingOf(anna, before.id), Practice) << "it was not when the attempt began";
  rig->pass(35 * kMinute_us);
  AttemptFacts inside = passAt(rig->now_us - 6 * kMinute_us);
  valueOf(AttemptStore(anna).begin(inside));
  EXPECT_EQ(sittingOf(anna, inside.id), Undecided) << "the test has ended";
  EXPECT_EQ(school->masteredBy(school->anna), 0);
  succeed(AttemptStore(anna).end(inside));
  EXPECT_EQ(sittingOf(anna, inside.id), Opened);
  EXPECT_EQ(school->masteredBy(school->anna), 1);
}

TEST_P(StoreOpenings, AnAttemptThatIsAddedAfterwardsCountsIfTheTestWasOpenThen) {
  const SignedIn anna = school->as(school->anna);
  const std::int64_t start_us = rig->now_us;
  school->opened(hourFrom(start_us));
  rig->pass(kDay_us);
  const auto added = [&](std::int64_t begun_us, AttemptProof proof) {
    AttemptFacts facts = passAt(begun_us);
    facts.proof = proof, facts.testConditions = Opened;
    return sittingOf(anna, valueOf(AttemptStore(anna).add(facts)));
  };
  EXPECT_EQ(added(start_us + kMinute_us, AttemptProof::Proven), Opened);
  EXPECT_EQ(added(start_us + kHour_us, AttemptProof::Proven), Practice) << "whatever its sender states";
  EXPECT_EQ(added(start_us + kHour_us, AttemptProof::Demonstration), Opened);
}

TEST_P(StoreOpenings, AnOpeningHoldsForLaterVersionsOfTheCurriculum) {
  const SignedIn anna = school->as(school->anna);
  school->opened(hourFrom(rig->now_us));
  Curriculum later = examCourse(2);
  later.levels[0].assistance = Assistance::Test;
  valueOf(PublishedCurricula(school->admin).publish("course", 2, curriculumText(later)));
  EXPECT_EQ(sittingNow(anna, "a"), None) << "by version 1, which was practiced";
  AttemptFacts facts = passAt(rig->now_us);
  facts.curriculumVersion = 2;
  valueOf(AttemptStore(anna).begin(facts));
  EXPECT_EQ(sittingOf(anna, facts.id), Opened);
  succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "course", 2));
  EXPECT_EQ(valueOf(CohortStore(school->as(school->ina)).standings(school->spring.id, {{school->anna.id}}))
                .at(school->anna.id)
                .mastered,
            0)
      << "the level has become a test since the attempt";
}

TEST_P(StoreOpenings, WhatCannotBeOpenedIsRefusedWithTheReason) {
  const OpeningStore ina(school->as(school->ina));
  NewOpening opening = hourFrom(rig->now_us);
  opening.end_us.reset();
  EXPECT_EQ(refusalOf(ina.open(opening)), "The opening has neither an end nor a code. State one of them, or both.");
  opening.end_us = rig->now_us - kSecond_us, opening.start_us = rig->now_us - kHour_us;
  EXPECT_THAT(refusalOf(ina.open(opening)), HasSubstr("State a later end."));
  opening = hourFrom(rig->now_us, " ab\t");
  EXPECT_FALSE(ina.open(opening));
  opening.code = "abc";
  EXPECT_EQ(refusalOf(ina.open(opening)), "The code has 3 characters. Choose one of 4 to 32 characters.");
  opening = hourFrom(rig->now_us);
  opening.level = "a";
  EXPECT_EQ(refusalOf(ina.open(opening)),
            "'a' is not a test of the curriculum 'course', which has the tests 'exam'. Only tests are opened.");
  const Cohort bare = valueOf(CohortStore(school->admin).add("Bare"));
  opening = hourFrom(rig->now_us);
  opening.cohort = bare.id;
  EXPECT_THAT(refusalOf(OpeningStore(school->admin).open(opening)), HasSubstr("has no curriculum; set one."));
  EXPECT_THAT(valueOf(ina.listByCohort(school->spring.id)), IsEmpty());
}

TEST_P(StoreOpenings, AnOpeningInThePastBeginsNow) {
  NewOpening opening = hourFrom(rig->now_us);
  opening.start_us = rig->now_us - kDay_us;
  EXPECT_EQ(school->opened(opening).start_us, rig->now_us) << "attempts that were practice stay practice";
}

TEST_P(StoreOpenings, TheDatabaseRefusesToChangeWhatWasDecided) {
  const SignedIn anna = school->as(school->anna);
  const TestOpening opening = school->opened(hourFrom(rig->now_us + kHour_us, "jugular"));
  EXPECT_EQ(sittingNow(anna), Practice);
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address))).value();
  for (const char* sql : {"UPDATE attempts SET sitting = 'opened'", "UPDATE openings SET start_us = 0",
                          "UPDATE openings SET code = ''", "DELETE FROM openings"})
    EXPECT_FALSE(connection->script(sql)) << sql;
  EXPECT_EQ(valueOf(OpeningStore(school->as(school->ina)).listByCohort(school->spring.id)).front(), opening);
  succeed(StoreUpkeep(school->admin).exportJson(rig->folder / "all.json"));
  EXPECT_THAT(bytesOf(rig->folder / "all.json"), Not(HasSubstr("argon2"))) << "codes are not exported";
}

TEST_P(StoreOpenings, AWorkstationDecidesByTheOpeningsOfItsServer) {
  StoreRig ward;
  const CurriculumStore near = valueOf(CurriculumStore::open(ward.address, ward.services));
  const SiteUpload upload(near, school->store);
  const TestOpening opening = school->opened(hourFrom(rig->now_us, "jugular"));
  valueOf(upload.exchange());
  const SignedIn anna = valueOf(near.signIn("anna", kPassword)), ina = valueOf(near.signIn("ina", kPassword));
  EXPECT_THAT(refusalOf(OpeningStore(ina).open(hourFrom(rig->now_us))), HasSubstr("openings of tests are stored on"));
  EXPECT_EQ(valueOf(OpeningStore(anna).enterCode("course", "exam", "jugular")).kind, TestAdmission::Kind::Open);
  const AttemptFacts counted = passAt(ward.now_us);
  valueOf(AttemptStore(anna).add(counted));
  succeed(OpeningStore(school->as(school->ina)).close(school->spring.id, opening.id));
  valueOf(upload.exchange());
  ward.pass(kMinute_us);
  const AttemptFacts practice = passAt(ward.now_us);
  valueOf(AttemptStore(anna).add(practice));
  valueOf(upload.exchange());
  EXPECT_EQ(sittingOf(school->admin, counted.id), Opened);
  EXPECT_EQ(sittingOf(school->admin, practice.id), Practice);
}

}  // namespace
}  // namespace insonate::test
