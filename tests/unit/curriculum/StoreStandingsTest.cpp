#include "StoreRig.h"
#include "store/Core.h"
#include "store/Texts.h"

#include <insonate/curriculum/LevelSituations.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteUpload.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

/// A course of one level, mastered by two passes in a row, which lapses after 30 days.
Curriculum shortCourse() {
  Curriculum course = courseOf({levelNamed("a", 2)});
  course.levels[0].mastery.lapsesAfter_days = 30;
  return course;
}

/// Spring is taught by the short course.
struct TaughtSchool : School {
  explicit TaughtSchool(const CurriculumStore& in) : School(in) {
    valueOf(PublishedCurricula(admin).publish("course", 1, curriculumText(shortCourse())));
    succeed(CohortStore(admin).setCurriculum(spring.id, "course", 1));
  }
  Member annas() const {
    for (const Member& row : valueOf(CohortStore(as(ina)).members(spring.id)))
      if (row.person.id == anna.id) return row;
    throw std::runtime_error("not in her cohort");
  }
};

AttemptFacts annasAttempt(char outcome) {
  AttemptFacts facts = outcome == 'P' ? passedAttempt("a", kToday_us) : failedAttempt("a", kToday_us);
  facts.id = freshUuid(), facts.person = {}, facts.caseName = "textbook";
  return facts;
}

std::string keep(const SignedIn& by, char outcome) {
  const AttemptFacts facts = annasAttempt(outcome);
  valueOf(AttemptStore(by).begin(facts));
  succeed(AttemptStore(by).end(facts));
  return facts.id;
}

void runInside(const StoreRig& rig, const char* sql) {
  const auto core = valueOf(store::Core::open(rig.address, rig.services));
  succeed(inTransaction(*core, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    transaction.script(sql);
    return {};
  }));
}

class StoreStandings : public OnBoth {};
INSONATE_ON_BOTH(StoreStandings);

TEST_P(StoreStandings, AreKeptWithEachEndAndVoiding) {
  const TaughtSchool school(rig->open());
  const SignedIn anna = school.as(school.anna);
  EXPECT_FALSE(school.annas().standing) << "nothing is done, and nobody has asked";
  keep(anna, 'P');
  ASSERT_TRUE(school.annas().standing);
  EXPECT_EQ(school.annas().standing->sentence, "Unlocked: 1 of 2 passed attempts in a row; the last attempt passed.");
  const std::string second = keep(anna, 'P');
  EXPECT_EQ(school.annas().standing->mastered, 1);
  EXPECT_EQ(school.annas().standing->level, "");
  EXPECT_TRUE(school.annas().standingIsCurrent);
  valueOf(AttemptStore(anna).begin(annasAttempt('P')));
  EXPECT_TRUE(school.annas().standingIsCurrent) << "what is open tells nothing";

  succeed(AttemptStore(school.as(school.ina)).voidAttempt(second, "device failed"));
  EXPECT_EQ(school.annas().standing->mastered, 0);
  EXPECT_TRUE(school.annas().standingIsCurrent);
  EXPECT_EQ(school.annas().attempts, 1);
}

TEST_P(StoreStandings, AreWhatAllAttemptsTell) {
  const TaughtSchool school(rig->open());
  const SignedIn anna = school.as(school.anna);
  for (const char outcome : std::string("PFPPFFFFFP")) {
    keep(anna, outcome);
    const auto history = valueOf(AttemptStore(anna).history(school.anna.id));
    const Standing whole = computeStanding(shortCourse(), history, computeProgress(shortCourse(), history, rig->now_us),
                                           rig->now_us, valueOf(AttemptStore(anna).changes(school.anna.id)));
    EXPECT_EQ(school.annas().standing, whole);
  }
}

TEST_P(StoreStandings, EndWithTheirDayAndWithAClockThatIsSetBack) {
  const TaughtSchool school(rig->open());
  const CohortStore ina(school.as(school.ina));
  keep(school.as(school.anna), 'P'), keep(school.as(school.anna), 'P');
  rig->pass(30 * kDay_us);
  EXPECT_TRUE(school.annas().standingIsCurrent);
  rig->pass(kDay_us);
  EXPECT_FALSE(school.annas().standingIsCurrent);
  const Standing lapsed = valueOf(ina.standings(school.spring.id, {{school.anna.id}})).at(school.anna.id);
  EXPECT_EQ(lapsed.concern, Concern::Slipped);
  EXPECT_THAT(lapsed.sentence, HasSubstr("without practice (31 days)"));
  EXPECT_EQ(school.annas().standing, lapsed) << "what was looked at is kept";
  EXPECT_TRUE(school.annas().standingIsCurrent);
  rig->now_us -= 5 * kDay_us;
  EXPECT_FALSE(school.annas().standingIsCurrent);
}

TEST_P(StoreStandings, OfAnotherProgramOrCurriculumAreWorkedOutAnew) {
  const TaughtSchool school(rig->open());
  const CohortStore ina(school.as(school.ina));
  keep(school.as(school.anna), 'P');
  runInside(*rig, "UPDATE standings SET rules = rules - 1, sentence = 'by older rules'");
  EXPECT_FALSE(school.annas().standingIsCurrent);
  EXPECT_THAT(valueOf(ina.standings(school.spring.id, {{school.anna.id}})).at(school.anna.id).sentence,
              HasSubstr("1 of 2 passed attempts"));
  EXPECT_TRUE(school.annas().standingIsCurrent);

  Curriculum next = shortCourse();
  next.version = 2, next.levels[0].mastery.consecutivePasses = 1;
  valueOf(PublishedCurricula(school.admin).publish("course", 2, curriculumText(next)));
  succeed(ina.setCurriculum(school.spring.id, "course", 2));
  EXPECT_FALSE(school.annas().standing);
  EXPECT_EQ(valueOf(ina.standings(school.spring.id, {{school.anna.id}})).at(school.anna.id).mastered, 1);
}

TEST_P(StoreStandings, OfACurriculumThatWasTamperedWithAreRefusedButAttemptsAreKept) {
  const TaughtSchool school(rig->open());
  runInside(*rig, GetParam() == Place::File
                      ? "DROP TRIGGER curricula_fixed; UPDATE curricula SET text = '{}'"
                      : "ALTER TABLE curricula DISABLE TRIGGER ALL; UPDATE curricula SET text = '{}'");
  keep(school.as(school.anna), 'P');
  EXPECT_EQ(school.annas().attempts, 1);
  EXPECT_FALSE(school.annas().standing);
  const CohortStore ina(school.as(school.ina));
  EXPECT_THAT(refusalOf(ina.standings(school.spring.id, {{school.anna.id}})),
              HasSubstr("is not the one that was published"));
  EXPECT_THAT(refusalOf(CohortStore(school.as(school.otto)).standings(school.autumn.id, {{school.carl.id}})),
              HasSubstr("has no curriculum"));
}

TEST_P(StoreStandings, OfWhatAWorkstationSendsAreThereAtOnce) {
  const TaughtSchool school(rig->open());
  StoreRig ward;
  ward.services.workstation = "ward 8";
  const CurriculumStore here = ward.open();
  valueOf(here.createFirstAdministrator({"local", "Local", "", Role::Administrator}, kPassword));
  valueOf(SiteUpload(here, school.store).exchange());
  const SignedIn anna = valueOf(here.signIn("anna", kPassword));
  keep(anna, 'P'), keep(anna, 'P');
  EXPECT_EQ(valueOf(SiteUpload(here, school.store).exchange()).attempts, 2);
  ASSERT_TRUE(school.annas().standing);
  EXPECT_EQ(school.annas().standing->mastered, 1);
  EXPECT_TRUE(school.annas().standingIsCurrent);
}

TEST(StoreStandingsRules, HaveANumberThatIsRaisedWithThem) {
  Curriculum course = courseOf({levelNamed("a", 2), levelNamed("b", 1, {"a"})});
  course.levels[0].mastery.lapsesAfter_days = 30;
  course.levels[0].mastery.lapsesAfter = FailureRule{2, 3};
  course.levels[1].mastery.cusum = CusumRule{0.1, 0.25, 0.5};
  AttemptFacts brokenOff = passedAttempt("a");
  brokenOff.state = AttemptState::Abandoned;
  std::string told;
  for (const char* outcomes : {"", "F", "P", "PP", "PPF", "PPFF", "PPFFPP", "FFFFF"})
    for (const int days : {0, 1, 40}) {
      auto history = attemptsAt("a", outcomes);
      for (const AttemptFacts& one : attemptsAt("b", outcomes)) history.push_back(one);
      if (days == 1) history.push_back(brokenOff);
      const std::int64_t now_us = kNoon_us + days * kDay_us;
      const Standing one = computeStanding(course, history, computeProgress(course, history, now_us), now_us, 0);
      told += one.level + one.sentence + std::to_string(one.mastered) + std::to_string(int(one.concern));
    }
  EXPECT_EQ(std::to_string(kStandingRules) + " " + store::sha256(told).substr(0, 16), "3 45c78389dcf14f8d")
      << "raise kStandingRules, so that what stores keep is worked out anew, and write the new digest here";
}

}  // namespace
}  // namespace insonate::test
