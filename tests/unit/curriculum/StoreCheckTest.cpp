#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/RepeatedValues.h>
#include <insonate/curriculum/StoreCheck.h>
#include <insonate/curriculum/StoreUpkeep.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Writes as someone who may write the database can, past this program and its triggers.
void writePast(const StoreRig& rig, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  const bool isFile = (*connection)->dialect().name == "sqlite";
  std::string kept;
  if (isFile)
    for (const store::Row& row :
         valueOf((*connection)->rows("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'", {}))) {
      succeed((*connection)->script("DROP TRIGGER " + row.text(0)));
      kept += row.text(1) + ";\n";
    }
  succeed((*connection)->script((isFile ? "" : "SET session_replication_role = replica;") + sql));
  if (isFile) succeed((*connection)->script(kept));
}

auto differs(const std::string& attempt, const std::string& field) {
  return AllOf(Field(&StoreDifference::attempt, attempt), Field(&StoreDifference::field, field));
}

/// Anna has an attempt at the first level of central_line, which her class is taught by.
class StoreCheckOnBoth : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (!rig) return;
    school.emplace(rig->open());
    const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
    valueOf(PublishedCurricula(school->admin).publish(curriculum.name, curriculum.version, curriculumText(curriculum)));
    succeed(CohortStore(school->admin).setCurriculum(school->spring.id, curriculum.name, curriculum.version));
    AttemptFacts begun = begunFacts();
    begun.curriculumVersion = curriculum.version, begun.level = curriculum.levels.front().name;
    facts = keepAttempt(school->as(school->anna), begun);
    const std::vector<std::string> anna{school->anna.id};
    valueOf(CohortStore(school->admin).standings(school->spring.id, anna));
    check.emplace(school->admin);
  }
  std::string ofAnna() const { return " WHERE id = '" + facts.id + "'"; }

  std::optional<School> school;
  std::optional<StoreCheck> check;
  AttemptFacts facts;
};
INSONATE_ON_BOTH(StoreCheckOnBoth);

TEST_P(StoreCheckOnBoth, AStoreThatOnlyTheProgramWroteAgrees) {
  succeed(AttemptStore(school->as(school->ina)).voidAttempt(facts.id, "a reason"));
  valueOf(AttemptStore(school->as(school->ben)).begin(begunFacts()));
  EXPECT_THAT(valueOf(check->againstLog()), IsEmpty());
  EXPECT_THAT(valueOf(check->standings()), IsEmpty());
  const auto all = valueOf(check->attempts(0, 1000));
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].facts.id, facts.id);
  EXPECT_EQ(valueOf(check->attempts(all[0].arrival, 1000)).size(), 1U);
}

TEST_P(StoreCheckOnBoth, OnlyAnAdministratorLooks) {
  const StoreCheck inas(school->as(school->ina));
  EXPECT_THAT(refusalOf(inas.attempts(0, 10)), HasSubstr("You do not have the permission for this"));
  EXPECT_THAT(refusalOf(inas.againstLog()), HasSubstr("You do not have the permission for this"));
  EXPECT_THAT(refusalOf(inas.standings()), HasSubstr("You do not have the permission for this"));
}

TEST_P(StoreCheckOnBoth, ARowThatTheLogContradictsIsNamed) {
  writePast(*rig, "UPDATE attempts SET level = 'mastery_test'" + ofAnna());
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "level")));
  writePast(*rig, "UPDATE attempts SET level = '" + facts.level + "', recording_hash = '" + std::string(64, 'c') + "'" +
                      ofAnna());
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "recording hash")));
  writePast(*rig, "UPDATE attempts SET recording_hash = '" + facts.recordingHash + "', person = '" + school->ben.id +
                      "'" + ofAnna());
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "person")));
}

TEST_P(StoreCheckOnBoth, ADecisionThatTheLogContradictsIsNamed) {
  const AttemptStore ina(school->as(school->ina));
  writePast(*rig, "UPDATE proofs SET state = 'accepted', accepted_by = '" + school->ina.id + "'");
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "accepted by an instructor")));
  writePast(*rig, "UPDATE proofs SET state = 'unproven', accepted_by = ''");
  succeed(ina.accept(facts.id, "seen"));
  EXPECT_THAT(valueOf(check->againstLog()), IsEmpty());
  succeed(ina.voidAttempt(facts.id, "another person's"));
  EXPECT_THAT(valueOf(check->againstLog()), IsEmpty());
  writePast(*rig, "UPDATE attempts SET voided_us = NULL, voided_by = NULL, void_reason = NULL" + ofAnna());
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "voided"))) << "it would count again";
}

TEST_P(StoreCheckOnBoth, ARowThatIsMadeUpOrDeletedIsNamed) {
  const std::string made = freshUuid();
  writePast(*rig,
            "INSERT INTO attempts SELECT arrival + 1, '" + made +
                "', person, run, curriculum, curriculum_version, level, procedure, procedure_version, case_name, "
                "case_hash, workstation, begun_us, state, crashed, length_us, succeeded, critical_errors, points, "
                "metrics, recording, recording_hash, voided_us, voided_by, void_reason, sitting FROM attempts");
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(made, "attempt")));
  writePast(*rig, "UPDATE attempts SET arrival = 0 WHERE id = '" + made + "'");
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(made, "attempt"))) << "nor before the first";
  writePast(*rig, "DELETE FROM proofs WHERE attempt = '" + facts.id + "'");
  writePast(*rig, "DELETE FROM attempts WHERE id IN ('" + made + "', '" + facts.id + "')");
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(facts.id, "attempt")));
}

TEST_P(StoreCheckOnBoth, AnEndThatNobodyMadeIsNamed) {
  const SignedIn ben = school->as(school->ben);
  const std::string open = valueOf(AttemptStore(ben).begin(begunFacts()));
  writePast(*rig, "UPDATE attempts SET state = 'completed', succeeded = 1 WHERE id = '" + open + "'");
  EXPECT_THAT(valueOf(check->againstLog()), ElementsAre(differs(open, "state")));
}

TEST_P(StoreCheckOnBoth, ValuesOfAnEarlierAttemptOfAnyoneAreFound) {
  const SignedIn ben = school->as(school->ben), ina = school->as(school->ina);
  const auto keep = [&](double path_mm, double passes) {
    AttemptFacts made = endedFacts(begunFacts());
    made.metrics = {{"passes", 1, passes}, {"needle_path_mm", 1, path_mm}};
    made.recordingHash.clear();
    return valueOf(AttemptStore(ben).add(made));
  };
  AttemptFacts first = endedFacts(begunFacts());
  first.metrics = {{"passes", 1, 1.0}, {"needle_path_mm", 1, 0.1 + 0.2}};
  valueOf(AttemptStore(school->as(school->anna)).add(first));
  keep(0.3, 1);
  const std::string same = keep(0.1 + 0.2, 1);
  keep(0.5, 0), keep(0.5, 0);
  EXPECT_THAT(valueOf(repeatedValues(ina, school->ben.id)), ElementsAre(same));
  EXPECT_THAT(valueOf(repeatedValues(ina, school->anna.id)), IsEmpty()) << "hers was the first";
  EXPECT_THAT(refusalOf(repeatedValues(school->as(school->otto), school->ben.id)),
              HasSubstr("You do not have the permission for this"));
}

TEST_P(StoreCheckOnBoth, AStandingThatWasEditedIsNamed) {
  writePast(*rig, "UPDATE standings SET mastered = 9, sentence = 'All levels are mastered.'");
  const auto differences = valueOf(check->standings());
  ASSERT_EQ(differences.size(), 2U);
  EXPECT_EQ(differences[0].person, school->anna.id);
  EXPECT_THAT(differences[0].field, HasSubstr("levels mastered"));
  EXPECT_EQ(differences[0].stored, "9");
  EXPECT_EQ(differences[0].expected, "0");
  EXPECT_THAT(differences[1].field, HasSubstr("sentence"));
}

}  // namespace
}  // namespace insonate::test
