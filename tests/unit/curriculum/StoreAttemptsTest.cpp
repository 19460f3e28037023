#include "StoreRig.h"
#include "store/MetricsText.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PublishedCurricula.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

class StoreAttempts : public OnBoth {};
INSONATE_ON_BOTH(StoreAttempts);

TEST_P(StoreAttempts, WhatWasMeasuredComesBackBitForBit) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  AttemptFacts facts = endedFacts(begunFacts());
  facts.metrics = {{"tiny", 1, std::numeric_limits<double>::denorm_min()},
                   {"large", 1, std::numeric_limits<double>::max()},
                   {"third", 1, 1.0 / 3},
                   {"minus nought", 3, -0.0},
                   {"missing", 1, std::nullopt}};
  facts.points = 100.0 / 3;
  facts.begun_us = -1;
  valueOf(AttemptStore(anna).begin(facts));
  succeed(AttemptStore(anna).end(facts));

  const StoredAttempt kept = valueOf(AttemptStore(anna).attempt(facts.id));
  facts.person = school.anna.id;
  facts.workstation = "ward 7";
  EXPECT_EQ(kept.facts, facts);
  EXPECT_TRUE(std::signbit(*kept.facts.metrics[3].value));
  EXPECT_FALSE(kept.crashed);
}

TEST_P(StoreAttempts, AnAttemptIsBegunEndedAndVoidedOnce) {
  const School school(rig->open());
  const AttemptStore anna(school.as(school.anna)), ina(school.as(school.ina));
  AttemptFacts facts = begunFacts();
  EXPECT_EQ(valueOf(anna.begin(facts)), facts.id);
  EXPECT_EQ(valueOf(anna.begin(facts)), facts.id) << "the same once more";
  EXPECT_EQ(valueOf(anna.attempt(facts.id)).facts.state, AttemptState::Open);
  EXPECT_THAT(refusalOf(ina.voidAttempt(facts.id, "device failed")), HasSubstr("still open"));

  AttemptFacts other = facts;
  other.level = "second";
  EXPECT_THAT(refusalOf(anna.begin(other)), HasSubstr("already begun with another"));
  EXPECT_THAT(refusalOf(anna.end(endedFacts(other))), HasSubstr("already begun with another"));

  facts = endedFacts(facts);
  succeed(anna.end(facts));
  succeed(anna.end(facts));
  other = facts;
  other.points = 100;
  EXPECT_THAT(refusalOf(anna.end(other)), HasSubstr("has already ended"));

  EXPECT_THAT(refusalOf(ina.voidAttempt(facts.id, "  ")), HasSubstr("type it"));
  succeed(ina.voidAttempt(facts.id, "device failed"));
  succeed(ina.voidAttempt(facts.id, "device failed"));
  EXPECT_THAT(refusalOf(ina.voidAttempt(facts.id, "another reason")), HasSubstr("voided already"));
  succeed(anna.end(facts));
  const StoredAttempt kept = valueOf(anna.attempt(facts.id));
  EXPECT_EQ(kept.facts.state, AttemptState::Voided);
  EXPECT_EQ(kept.voidReason, "device failed");
  EXPECT_EQ(kept.facts.points, facts.points) << "kept, but not counted";
}

TEST_P(StoreAttempts, WhatIsNoFactIsRefused) {
  const School school(rig->open());
  const AttemptStore anna(school.as(school.anna));
  const auto beginning = [&](auto change) {
    AttemptFacts facts = begunFacts();
    change(facts);
    return refusalOf(anna.begin(facts));
  };
  EXPECT_THAT(beginning([](auto& f) { f.id = "1"; }), HasSubstr("UUID"));
  EXPECT_THAT(beginning([](auto& f) { f.id = "{" + f.id + "}"; }), HasSubstr("UUID"));
  EXPECT_THAT(beginning([](auto& f) { f.level = std::string("a\0b", 3); }), HasSubstr("zero byte"));
  EXPECT_THAT(beginning([](auto& f) { f.caseName = "\xc3\x28"; }), HasSubstr("UTF-8"));
  EXPECT_THAT(beginning([](auto& f) { f.caseName = std::string(1 << 20, 'x'); }), HasSubstr("Shorten"));
  EXPECT_THAT(beginning([](auto& f) { f.procedureVersion = -1; }), HasSubstr("negative"));

  const AttemptFacts begun = begunFacts();
  valueOf(anna.begin(begun));
  const auto ending = [&](auto change) {
    AttemptFacts facts = endedFacts(begun);
    change(facts);
    return refusalOf(anna.end(facts));
  };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_THAT(ending([](auto& f) { f.metrics[0].value = std::nan(""); }), HasSubstr("not a finite number"));
  EXPECT_THAT(ending([](auto& f) { f.metrics[0].value = -kInfinity; }), HasSubstr("not a finite number"));
  EXPECT_THAT(ending([](auto& f) { f.metrics[1].id = f.metrics[0].id; }), HasSubstr("twice"));
  EXPECT_THAT(ending([](auto& f) { f.points = std::nan(""); }), HasSubstr("0 and 100"));
  EXPECT_THAT(ending([](auto& f) { f.points = 100.001; }), HasSubstr("0 and 100"));
  EXPECT_THAT(ending([](auto& f) { f.length_us = -1; }), HasSubstr("negative"));
  EXPECT_THAT(ending([](auto& f) { f.state = AttemptState::Open; }), HasSubstr("completed or abandoned"));
  EXPECT_THAT(ending([](auto& f) { f.state = AttemptState::Voided; }), HasSubstr("completed or abandoned"));
  EXPECT_THAT(ending([](auto& f) { f.recording = "../../etc/passwd"; }), HasSubstr("not a file name"));
  EXPECT_THAT(ending([](auto& f) { f.recordingHash = "abc"; }), HasSubstr("SHA-256"));
  EXPECT_EQ(valueOf(anna.attempt(begun.id)).facts.state, AttemptState::Open) << "nothing of it was kept";
}

TEST_P(StoreAttempts, OrderIsThatOfArrivalWhateverTheClocksSay) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  std::vector<std::string> ids;
  for (const std::int64_t clock_us :
       {kToday_us, kToday_us - 9000 * kDay_us, kToday_us + 9000 * kDay_us, std::int64_t{0}}) {
    rig->now_us = clock_us;
    AttemptFacts facts = begunFacts();
    facts.begun_us = clock_us;
    ids.push_back(keepAttempt(anna, facts).id);
  }
  std::vector<std::string> history, newestFirst;
  for (const AttemptFacts& facts : valueOf(AttemptStore(anna).history(school.anna.id))) history.push_back(facts.id);
  EXPECT_EQ(history, ids);

  const auto first = valueOf(AttemptStore(anna).page(school.anna.id, 3));
  const auto second = valueOf(AttemptStore(anna).page(school.anna.id, 3, first.back().arrival));
  for (const auto& page : {first, second})
    for (const StoredAttempt& kept : page) newestFirst.push_back(kept.facts.id);
  EXPECT_EQ(first.size(), 3U);
  EXPECT_EQ(newestFirst, std::vector<std::string>(ids.rbegin(), ids.rend()));
  EXPECT_THAT(refusalOf(AttemptStore(anna).page(school.anna.id, 0)), HasSubstr("1 to 1000"));
}

TEST_P(StoreAttempts, AClassIsSeenWithItsLastAttemptsThatCount) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna), ben = school.as(school.ben), carl = school.as(school.carl);
  std::vector<std::string> ids;
  for (int i = 0; i < 4; ++i) ids.push_back(keepAttempt(anna).id);
  ids.push_back(keepAttempt(ben).id);
  keepAttempt(carl);
  const AttemptStore ina(school.as(school.ina));
  succeed(ina.voidAttempt(ids[3], "device failed"));
  valueOf(AttemptStore(anna).begin(begunFacts()));

  std::vector<std::string> annas, bens;
  for (const AttemptFacts& facts : valueOf(ina.recentOfCohort(school.spring.id, 2)))
    (facts.person == school.anna.id ? annas : bens).push_back(facts.id);
  EXPECT_EQ(annas, (std::vector<std::string>{ids[1], ids[2]})) << "neither the voided nor the open one";
  EXPECT_EQ(bens, std::vector<std::string>{ids[4]});
  EXPECT_TRUE(valueOf(ina.recentOfCohort(school.spring.id, 1000)).front().metrics == endedFacts({}).metrics);
}

TEST_P(StoreAttempts, AClassIsSeenWithoutFreePracticeAndWhatWasNotTried) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  const auto keepEnded = [&](AttemptState state, const std::vector<MetricFact>& metrics, bool isPractice = false) {
    AttemptFacts facts = begunFacts();
    if (isPractice) facts.curriculum = facts.level = "", facts.curriculumVersion = 0;
    valueOf(AttemptStore(anna).begin(facts));
    facts = endedFacts(facts);
    facts.state = state, facts.succeeded = state == AttemptState::Completed, facts.metrics = metrics;
    succeed(AttemptStore(anna).end(facts));
    return facts.id;
  };
  const std::string inSkin = keepEnded(AttemptState::Abandoned, {{"bone_contacts", 1, 0.0}, {"passes", 1, 2.0}});
  const std::string brokenOff = keepEnded(AttemptState::Abandoned, {});
  const std::string done = keepEnded(AttemptState::Completed, {{"passes", 1, 0.0}});
  keepEnded(AttemptState::Abandoned, {{"bone_contacts", 1, 3.0}, {"passes", 1, 0.0}});
  keepEnded(AttemptState::Completed, {{"passes", 1, 1.0}}, true);

  const SignedIn ina = school.as(school.ina);
  std::vector<std::string> seen;
  for (const AttemptFacts& facts : valueOf(AttemptStore(ina).recentOfCohort(school.spring.id, 3))) {
    seen.push_back(facts.id);
    EXPECT_TRUE(isCounted(facts)) << "the store and Judgement.h say the same";
  }
  EXPECT_EQ(seen, (std::vector<std::string>{inSkin, brokenOff, done}));
  const auto members = valueOf(CohortStore(ina).members(school.spring.id));
  const auto row = std::ranges::find_if(members, [&](const Member& one) { return one.person.id == school.anna.id; });
  const auto history = valueOf(AttemptStore(anna).history(school.anna.id));
  EXPECT_EQ(row->attempts, 4) << "with free practice, without what was not tried";
  EXPECT_EQ(row->attempts, std::ranges::count_if(history, [](const AttemptFacts& one) { return isCounted(one); }));
}

TEST_P(StoreAttempts, HostileTextsAreKeptAsTexts) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  const std::vector<std::string> texts = {"'; DROP TABLE attempts; --",
                                          "\"nosuch\"",
                                          "\\'\\\\",
                                          "?1 :a $1 %s {TEXT}",
                                          "שלום\u202eعالم",
                                          "💉\u0301",
                                          "NULL",
                                          "a\nb\r\n\tc",
                                          std::string(1000, '\'')};
  for (const std::string& text : texts) {
    AttemptFacts facts = begunFacts();
    facts.level = facts.caseName = text;
    facts = keepAttempt(anna, facts);
    EXPECT_EQ(valueOf(AttemptStore(anna).attempt(facts.id)).facts.level, text);
    EXPECT_FALSE(AttemptStore(anna).attempt(text));
    EXPECT_FALSE(AttemptStore(anna).history(text));
    EXPECT_FALSE(AttemptStore(anna).attempt(facts.id + std::string("\0'", 2)));
  }
  EXPECT_EQ(valueOf(AttemptStore(anna).history(school.anna.id)).size(), texts.size());
  EXPECT_TRUE(AuditLog(school.admin).verify()) << "refusals with such texts are in the log";
}

TEST_P(StoreAttempts, MetricsAreReadAsTheyWereWrittenAndOtherTextsAsNone) {
  const std::vector<MetricFact> metrics{
      {"whole", 1, 3.0}, {"a \"quoted\" \u00e9", 2, -0.1}, {"missing", 7, std::nullopt}, {"small", 1, 1e-300}};
  EXPECT_EQ(store::metricsOf(store::metricsText(metrics)), metrics);
  EXPECT_THAT(store::metricsOf(store::metricsText({})), IsEmpty());
  for (const char* text : {"", "{}", "7", "[", "[1]", "[[]]", "[[\"a\",1]]", "[[\"a\",1,2,3]]", "[[\"a\",\"b\",1]]",
                           "[[1,1,1]]", "[[\"a\",1,[2]]]", "[[\"a\",1,true]]", "[[\"a\",1,2]", "[[\"a\",1,2]] x"})
    EXPECT_THAT(store::metricsOf(text), IsEmpty()) << text;
}

TEST_P(StoreAttempts, ARecordingCountsOnce) {
  const CurriculumStore store = rig->open();
  const School school(store);
  AttemptFacts first = endedFacts(begunFacts());
  first.handsHash = std::string(64, 'd');
  const AttemptStore anna(school.as(school.anna)), ben(school.as(school.ben));
  valueOf(anna.add(first));
  EXPECT_EQ(valueOf(anna.add(first)), first.id) << "the same once more is no error";
  EXPECT_EQ(valueOf(anna.attempt(first.id)).facts.handsHash, first.handsHash);

  AttemptFacts other = first;  // the header was rewritten: another file, of another day
  other.id = freshUuid(), other.begun_us -= kSecond_us, other.recordingHash = std::string(64, 'e');
  for (const AttemptStore& who : {anna, ben}) {
    const std::string why = refusalOf(who.add(other));
    EXPECT_THAT(why, HasSubstr("This recording was added already, on 2026-11-22"));
    EXPECT_THAT(why, Not(HasSubstr("anna"))) << "when it was added, not whose it is";
  }
  EXPECT_TRUE(valueOf(ben.page(school.ben.id, 10)).empty()) << "nothing half-written";

  const AttemptFacts old = keepAttempt(school.as(school.anna));  // by an earlier program: the hash of the file alone
  other.handsHash = std::string(64, 'f'), other.recordingHash = old.recordingHash;
  EXPECT_THAT(refusalOf(ben.add(other)), HasSubstr("was added already, as an attempt of 2026-11-22"));
}

TEST_P(StoreAttempts, DatesThatCannotBeAreRefused) {
  const School school(rig->open());
  valueOf(PublishedCurricula(school.admin).publish("central_line", 2, curriculumOf(2)));
  const AttemptStore anna(school.as(school.anna));
  const auto at = [](std::int64_t begun_us) {
    AttemptFacts facts = endedFacts(begunFacts());
    facts.begun_us = begun_us;
    return facts;
  };
  const std::int64_t now_us = rig->now_us, minutes_us = 60 * kSecond_us;
  EXPECT_THAT(refusalOf(anna.begin(at(now_us + 11 * minutes_us))), HasSubstr("is in the future"));
  EXPECT_THAT(refusalOf(anna.begin(at(now_us - 11 * minutes_us))),
              HasSubstr("dated 2026-11-21, and its level was published later, on 2026-11-22"));
  AttemptFacts practice = at(now_us - 11 * minutes_us);
  practice.curriculum.clear(), practice.level.clear(), practice.curriculumVersion = 0;
  valueOf(anna.add(practice));
  valueOf(anna.begin(at(now_us - 9 * minutes_us)));
  AttemptFacts tooLong = at(now_us);
  valueOf(anna.begin(tooLong));
  tooLong.length_us = 11 * minutes_us;
  EXPECT_THAT(refusalOf(anna.end(tooLong)), HasSubstr("is in the future"));
  rig->pass(11 * minutes_us);
  succeed(anna.end(tooLong));
}

}  // namespace
}  // namespace insonate::test
