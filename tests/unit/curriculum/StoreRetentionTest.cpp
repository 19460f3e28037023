#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/Retention.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/VideoQueue.h>

#include <algorithm>
#include <fstream>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

/// A class whose people were last active on the first day.
class StoreRetention : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    rig->services.recordings = rig->folder / "recordings";
    fs::create_directories(rig->services.recordings);
    school.emplace(rig->open());
    attempt = keepAttempt(school->as(school->anna)).id;
    std::ofstream(recordingOf(attempt)) << "motion";
  }
  fs::path recordingOf(const std::string& id) const { return rig->services.recordings / (id + ".attempt"); }
  /// Administrators stay signed in, which counts as no activity of trainees.
  Retention retention() const { return Retention(school->admin); }
  std::vector<std::string> namesDue(const RetentionRule& rule) const {
    std::vector<std::string> names;
    for (const auto& one : valueOf(retention().preview(rule)).trainees) names.push_back(one.person.name);
    std::ranges::sort(names);
    return names;
  }
  std::string nameOf(const Person& person) const {
    return valueOf(PeopleStore(school->admin).person(person.id)).fullName;
  }
  std::ptrdiff_t applications() const {
    return std::ranges::count(valueOf(AuditLog(school->admin).page(1000)), "apply retention", &AuditEntry::act);
  }

  std::optional<School> school;
  std::string attempt;
};
INSONATE_ON_BOTH(StoreRetention);

TEST_P(StoreRetention, NothingIsDeletedWithoutARule) {
  EXPECT_EQ(valueOf(retention().rule()), RetentionRule{});
  RetentionSchedule server(school->store);
  for (int i = 0; i < 5; ++i) {
    rig->pass(400 * kDay_us);
    EXPECT_THAT(valueOf(server.applyDaily()).attempts, IsEmpty());
  }
  EXPECT_THAT(valueOf(retention().deleteExpired()).trainees, IsEmpty());
  EXPECT_TRUE(fs::exists(recordingOf(attempt)));
  EXPECT_EQ(nameOf(school->anna), "Dr anna");
}

TEST_P(StoreRetention, OnlyTraineesWithoutActivityAreDue) {
  rig->pass(100 * kDay_us);
  (void)school->as(school->ben);
  EXPECT_THAT(namesDue({.erase_months = 3}), ElementsAre("anna", "carl")) << "ben has signed in";
  EXPECT_THAT(namesDue({.erase_months = 4}), IsEmpty());
  Person carl = school->carl;
  carl.disabled = true;
  succeed(PeopleStore(school->admin).change(carl));
  EXPECT_THAT(namesDue({.erase_months = 3}), ElementsAre("anna", "carl")) << "of those who left, too";
  succeed(PersonData(school->admin).erase(school->carl.id));
  EXPECT_THAT(namesDue({.erase_months = 3}), ElementsAre("anna")) << "an erased person is not erased again";
}

TEST_P(StoreRetention, APersonWhoNeverSignedInCountsFromTheRule) {
  valueOf(PeopleStore(school->admin).add({"dora", "Dora", ""}, "first password"));
  rig->pass(100 * kDay_us);
  const RetentionRule rule{.erase_months = 3};
  succeed(retention().setRule(rule));
  EXPECT_THAT(namesDue(rule), ElementsAre("anna", "ben", "carl"));
  rig->pass(100 * kDay_us);
  EXPECT_THAT(namesDue(rule), ElementsAre("anna", "ben", "carl", "dora"));
}

TEST_P(StoreRetention, ANewPersonAndOneWhoReturnsAreSpared) {
  const RetentionRule rule{.erase_months = 3};
  succeed(retention().setRule(rule));
  rig->pass(300 * kDay_us);
  valueOf(PeopleStore(school->admin).add({"dora", "Dora", ""}, "first password", school->spring.id));
  succeed(PeopleStore(school->admin).resetPassword(school->anna.id, "another password"));
  succeed(CohortStore(school->admin).join(school->autumn.id, school->ben.id, false));
  EXPECT_THAT(namesDue(rule), ElementsAre("carl")) << "dora has not signed in yet, anna and ben were called back";
  rig->pass(100 * kDay_us);
  EXPECT_THAT(namesDue(rule), testing::SizeIs(4));
}

TEST_P(StoreRetention, APersonWhoCannotBeErasedKeepsNoOther) {
  rig->pass(100 * kDay_us);
  valueOf(PeopleStore(school->admin).add({"dora", "Dora", ""}, "first password"));
  succeed(retention().setRule({.erase_months = 3}));
  // Anna's entry in the log was changed by another program, so that her erasure fails.
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address)));
  ASSERT_TRUE(connection);
  const std::string entry =
      "(SELECT MIN(number) FROM audit WHERE act = 'add trainee' AND detail LIKE '" + school->anna.id + "%')";
  const std::string guard =
      GetParam() == Place::File ? "DROP TRIGGER audit_fixed; " : "ALTER TABLE audit DISABLE TRIGGER USER; ";
  succeed((*connection)
              ->script(guard + "UPDATE audit SET detail = 'anna, trainee', person = '" + school->anna.id +
                       "', act = 'void attempt' WHERE number = " + entry));
  RetentionSchedule server(school->store);
  rig->pass(kDay_us);
  EXPECT_FALSE(server.applyDaily());
  EXPECT_EQ(nameOf(school->anna), "Dr anna");
  EXPECT_THAT(nameOf(school->ben), HasSubstr("Erased person"));
}

TEST_P(StoreRetention, ARuleThatWaitsSinceTheFutureWaitsFromNowOn) {
  rig->pass(2000 * kDay_us);
  succeed(retention().setRule({.erase_months = 3}));
  rig->pass(-1500 * kDay_us);
  RetentionSchedule server(school->store);
  EXPECT_THAT(valueOf(server.applyDaily()).attempts, IsEmpty());
  rig->pass(kDay_us);
  (void)valueOf(server.applyDaily());
  EXPECT_THAT(nameOf(school->anna), HasSubstr("Erased person"));
}

TEST_P(StoreRetention, ARuleThatIsAppliedErasesAndDeletes) {
  rig->pass(100 * kDay_us);
  const SignedIn ben = school->as(school->ben);
  AttemptFacts recent = begunFacts();
  recent.begun_us = rig->now_us;
  recent = endedFacts(recent);
  recent.recordingHash = std::string(64, 'b');
  rig->pass(200 * kSecond_us);
  valueOf(AttemptStore(ben).begin(recent));
  succeed(AttemptStore(ben).end(recent));
  std::ofstream(recordingOf(recent.id)) << "motion";
  succeed(retention().setRule({.erase_months = 3, .recording_months = 2}));
  const RetentionDue done = valueOf(retention().deleteExpired());
  EXPECT_EQ(done.trainees.size(), 2U);
  EXPECT_THAT(done.attempts, ElementsAre(attempt));
  EXPECT_THAT(nameOf(school->anna), HasSubstr("Erased person"));
  EXPECT_EQ(nameOf(school->ben), "Dr ben");
  EXPECT_FALSE(fs::exists(recordingOf(attempt)));
  EXPECT_TRUE(fs::exists(recordingOf(recent.id)));
  EXPECT_EQ(applications(), 1);
  succeed(StoreUpkeep(school->admin).verify());
  EXPECT_THAT(valueOf(retention().deleteExpired()).trainees, IsEmpty());
}

TEST_P(StoreRetention, RecordingsAloneAreDeletedAndVideosAreNoLongerMade) {
  succeed(AttemptVideos(school->as(school->anna)).request(attempt));
  rig->pass(100 * kDay_us);
  succeed(retention().setRule({.recording_months = 3}));
  EXPECT_THAT(valueOf(retention().deleteExpired()).attempts, ElementsAre(attempt));
  EXPECT_FALSE(fs::exists(recordingOf(attempt)));
  EXPECT_EQ(valueOf(VideoQueue(school->store, "server").waiting()), 0);
  EXPECT_EQ(nameOf(school->anna), "Dr anna");
}

TEST_P(StoreRetention, ServersApplyARuleOnceADayAndADayAfterItWasSet) {
  rig->pass(100 * kDay_us);
  succeed(retention().setRule({.erase_months = 3, .recording_months = 3}));
  StoreServices services = rig->services;
  services.recordings = rig->folder / "recordings of the second";
  fs::create_directories(services.recordings);
  std::ofstream(services.recordings / (attempt + ".attempt")) << "motion";
  RetentionSchedule first(school->store), second(valueOf(CurriculumStore::open(rig->address, services)));
  EXPECT_THAT(valueOf(first.applyDaily()).attempts, IsEmpty());
  EXPECT_EQ(nameOf(school->anna), "Dr anna") << "there is a day to correct the rule";
  rig->pass(kDay_us);
  EXPECT_THAT(valueOf(first.applyDaily()).attempts, ElementsAre(attempt)) << "whose video the server deletes";
  EXPECT_THAT(valueOf(second.applyDaily()).attempts, ElementsAre(attempt));
  EXPECT_FALSE(fs::exists(recordingOf(attempt)));
  EXPECT_FALSE(fs::exists(services.recordings / (attempt + ".attempt"))) << "each server has files";
  EXPECT_EQ(applications(), 1) << "one of them has applied it";
  EXPECT_THAT(nameOf(school->anna), HasSubstr("Erased person"));
  EXPECT_THAT(valueOf(first.applyDaily()).attempts, IsEmpty());
  rig->pass(kDay_us);
  (void)valueOf(second.applyDaily());
  EXPECT_EQ(applications(), 2);
}

TEST_P(StoreRetention, ARecordingThatCannotBeDeletedIsToldAndTriedAgain) {
  rig->pass(100 * kDay_us);
  const std::string bens = keepAttempt(school->as(school->ben)).id;
  const fs::path kept = recordingOf(bens) / "a folder that is not empty";
  fs::create_directories(kept);
  succeed(retention().setRule({.recording_months = 3}));
  rig->pass(kDay_us);
  RetentionSchedule server(school->store);
  for (int i = 0; i < 2; ++i) {
    const FilesToDelete files = valueOf(server.applyDaily());
    EXPECT_THAT(files.attempts, UnorderedElementsAre(attempt, bens)) << "whose videos the server deletes";
    EXPECT_THAT(refusalOf(files.recordings), HasSubstr("could not be deleted"));
    EXPECT_FALSE(fs::exists(recordingOf(attempt)));
  }
  fs::remove(kept);
  EXPECT_TRUE(valueOf(server.applyDaily()).recordings);
  EXPECT_THAT(valueOf(server.applyDaily()).attempts, IsEmpty());
}

TEST_P(StoreRetention, AfterALongPauseAServerWaitsForAnotherDay) {
  succeed(retention().setRule({.erase_months = 3}));
  rig->pass(4000 * kDay_us);
  RetentionSchedule server(school->store);
  EXPECT_THAT(valueOf(server.applyDaily()).attempts, IsEmpty());
  EXPECT_EQ(nameOf(school->anna), "Dr anna") << "the clock may be wrong";
  rig->pass(kDay_us);
  (void)valueOf(server.applyDaily());
  EXPECT_THAT(nameOf(school->anna), HasSubstr("Erased person"));
}

TEST_P(StoreRetention, AnImpossibleRuleIsRefused) {
  for (const int months : {0, -1, 1201}) {
    EXPECT_THAT(refusalOf(retention().setRule({.erase_months = months})), HasSubstr("1 to 1200 months"));
    EXPECT_THAT(refusalOf(retention().preview({.recording_months = months})), HasSubstr("1 to 1200 months"));
  }
  EXPECT_EQ(valueOf(retention().rule()), RetentionRule{});
}

}  // namespace
}  // namespace insonate::test
