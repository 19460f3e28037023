#include "StoreRig.h"
#include "store/AuditChain.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <filesystem>
#include <fstream>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;

/// Writes to the database past the program.
Result<void> tamper(const StoreRig& rig, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  return (*connection)->script(sql);
}

/// As who knows how to get rid of what guards a table.
std::string unguarded(Place place, const std::string& table, const std::string& sql) {
  if (place == Place::Server) return "ALTER TABLE " + table + " DISABLE TRIGGER USER; " + sql;
  return "DROP TRIGGER " + table + "_fixed; DROP TRIGGER " + table + "_stay; DROP TRIGGER " + table + "_come_once; " +
         sql;
}

class StoreAudit : public OnBoth {
 protected:
  std::string verifiedAfter(const std::string& sql) {
    const School school(rig->open());
    anchor = valueOf(AuditLog(school.admin).anchor());
    EXPECT_TRUE(AuditLog(school.admin).verify({anchor}));
    succeed(tamper(*rig, unguarded(GetParam(), "audit", sql)));
    return refusalOf(AuditLog(school.admin).verify({anchor}));
  }
  AuditAnchor anchor;
};
INSONATE_ON_BOTH(StoreAudit);

TEST_P(StoreAudit, AChangedEntryIsFound) {
  EXPECT_THAT(verifiedAfter("UPDATE audit SET person = 'someone else' WHERE number = 5"),
              HasSubstr("entry 5: it was changed"));
}

TEST_P(StoreAudit, ARefusalThatIsMadeAnAccessIsFound) {
  EXPECT_THAT(verifiedAfter("UPDATE audit SET allowed = 1 - allowed WHERE number = 7"),
              HasSubstr("entry 7: it was changed"));
}

TEST_P(StoreAudit, ALetterMovedFromOneFieldToTheNextIsFound) {
  EXPECT_THAT(verifiedAfter("UPDATE audit SET act = 'add perso', person = 'n' || person WHERE number = 4"),
              HasSubstr("entry 4: it was changed"));
}

TEST_P(StoreAudit, ADeletedEntryIsFound) {
  EXPECT_THAT(verifiedAfter("DELETE FROM audit WHERE number = 5"), HasSubstr("entry 5: it is missing"));
}

TEST_P(StoreAudit, EntriesThatChangePlacesAreFound) {
  EXPECT_THAT(
      verifiedAfter("UPDATE audit SET number = -5 WHERE number = 5; UPDATE audit SET number = 5 WHERE number = 6;"
                    "UPDATE audit SET number = 6 WHERE number = -5"),
      HasSubstr("entry 5: it was changed"));
}

TEST_P(StoreAudit, AnEndCutOffIsFound) {
  EXPECT_THAT(verifiedAfter("DELETE FROM audit WHERE number > 5"), HasSubstr("it is missing"))
      << "the look itself is an entry";
}

TEST_P(StoreAudit, ALogCutWithItsEndIsFoundByAnAnchorOnly) {
  EXPECT_THAT(verifiedAfter("DELETE FROM audit WHERE number > 5; UPDATE audit_end SET number = 5, hash = (SELECT hash "
                            "FROM audit WHERE number = 5)"),
              HasSubstr("the end is missing"));
  const SignedIn admin = valueOf(rig->open().signIn("admin", kPassword));
  EXPECT_TRUE(AuditLog(admin).verify()) << "what cannot be found without an anchor, as its header says";
}

TEST_P(StoreAudit, ALogThatItsOwnerHasRewrittenIsFoundByTheAnchorsOfTheServer) {
  const CurriculumStore store = rig->open();
  const School school(store);
  const std::filesystem::path file = rig->folder / "anchors";
  AuditAnchors server(store, file), another(store, file);
  succeed(server.append());
  succeed(server.append());
  EXPECT_EQ(valueOf(readAuditAnchors(file)).size(), 1U) << "nothing has changed";
  EXPECT_FALSE(AuditLog(school.as(school.ina)).anchor()) << "the refusal is an entry";
  succeed(server.append());
  succeed(another.append());
  const auto anchors = valueOf(readAuditAnchors(file));
  ASSERT_EQ(anchors.size(), 3U);
  EXPECT_LT(anchors[0].number, anchors[1].number);
  EXPECT_EQ(anchors[1], anchors[2]);
  EXPECT_TRUE(AuditLog(school.admin).verify(anchors));
  // The log of another database stands for one that the owner has written anew: it is consistent in itself.
  StoreRig other(GetParam());
  const School rewritten(other.open());
  EXPECT_FALSE(AuditLog(rewritten.as(rewritten.ina)).anchor());
  EXPECT_TRUE(AuditLog(rewritten.admin).verify());
  EXPECT_THAT(refusalOf(AuditLog(rewritten.admin).verify(anchors)), HasSubstr("differs from the noted anchor"));
  EXPECT_THAT(refusalOf(AuditLog(school.admin).verify({{anchors[1].number + 1000, anchors[1].hash}})),
              HasSubstr("the end is missing"));
}

TEST_P(StoreAudit, ADetailThatNoErasureChangesCannotBeHidden) {
  const School school(rig->open());
  EXPECT_FALSE(StoreUpkeep(school.as(school.ina)).facts()) << "an entry that Ina would like to hide";
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address)));
  ASSERT_TRUE(connection);
  for (const std::string& person : {school.ina.id, school.anna.id}) {
    store::Transaction transaction(**connection, store::Way::Write);
    AuditEntry hidden = store::auditEntryOf(
        *transaction.row("SELECT * FROM audit WHERE act = 'look after store' ORDER BY number DESC LIMIT 1"));
    hidden.detail = "(erased)";
    transaction.run("UPDATE audit SET detail = ? WHERE number = ?", hidden.detail, hidden.number);
    store::appendAudit(transaction, {.time_us = rig->now_us,
                                     .act = std::string(store::kEraseDetail),
                                     .person = person,
                                     .detail = store::voucherFor(hidden)});
    succeed(transaction.commit());
    EXPECT_THAT(refusalOf(AuditLog(school.admin).verify()), HasSubstr("it was changed"));
  }
}

TEST_P(StoreAudit, AFileOfAnchorsIsReadLineByLine) {
  const std::filesystem::path file = rig->folder / "anchors";
  std::ofstream(file) << "2026-11-29T07:00:00Z 5:abc\n\n7:def\n2026-11-29T07:02:00Z 9:cut o";
  EXPECT_EQ(valueOf(readAuditAnchors(file)), (std::vector<AuditAnchor>{{5, "abc"}, {7, "def"}}));
  for (const std::string wrong : {"soon\n", "5:\n", ":abc\n", "5 abc\n", "99999999999999999999:abc\n"}) {
    std::ofstream(file) << "5:abc\n" << wrong;
    EXPECT_THAT(refusalOf(readAuditAnchors(file)), HasSubstr("line 2")) << wrong;
  }
  EXPECT_THAT(refusalOf(readAuditAnchors(rig->folder / "missing")), HasSubstr("cannot be read"));
  EXPECT_THAT(refusalOf(AuditAnchors(rig->open(), rig->folder.path() / "no folder" / "anchors").append()),
              HasSubstr("cannot be written"));
}

TEST_P(StoreAudit, FactsAreNeitherChangedNorDeletedByWhoeverAsks) {
  const School school(rig->open());
  keepAttempt(school.as(school.anna));
  valueOf(PublishedCurricula(school.admin).publish("central_line", 1, curriculumOf(1)));
  for (const std::string sql :
       {"DELETE FROM attempts", "DELETE FROM audit", "DELETE FROM forms WHERE 1 = 0; DELETE FROM curricula",
        "UPDATE curricula SET text = '{\"easier\": true}'", "UPDATE audit SET detail = ''",
        "UPDATE attempts SET points = 100", "UPDATE attempts SET state = 'open', crashed = 0",
        "UPDATE attempts SET begun_us = begun_us + 1", "UPDATE attempts SET arrival = arrival + 1",
        "UPDATE attempts SET person = (SELECT id FROM people WHERE name = 'ben')",
        "UPDATE attempts SET metrics = '[]'"})
    EXPECT_FALSE(tamper(*rig, sql)) << sql;
  if (GetParam() == Place::File)
    for (const std::string sql : {"REPLACE INTO curricula SELECT name, version, '{}', hash, 0, '' FROM curricula",
                                  "PRAGMA recursive_triggers = OFF; REPLACE INTO attempts SELECT * FROM attempts"})
      EXPECT_FALSE(tamper(*rig, sql)) << sql;
  else
    EXPECT_FALSE(tamper(*rig, "TRUNCATE audit"));
  EXPECT_TRUE(StoreUpkeep(school.admin).verify());
}

TEST_P(StoreAudit, EachAttemptThatArrivesIsAnEntry) {
  const School school(rig->open());
  const AttemptFacts facts = endedFacts(begunFacts());
  valueOf(AttemptStore(school.as(school.anna)).add(facts));
  valueOf(AttemptStore(school.as(school.anna)).add(facts));
  std::vector<std::string> acts;
  for (const AuditEntry& entry : valueOf(AuditLog(school.admin).page(100, 0, school.anna.id)))
    if (entry.detail.starts_with(facts.id)) {
      EXPECT_EQ(entry.actor, school.anna.id);
      acts.push_back(entry.act + entry.detail.substr(facts.id.size()));
    }
  EXPECT_THAT(acts,
              ::testing::ElementsAre("end attempt, recording " + facts.recordingHash, "begin attempt at level first"))
      << "the same once more is no arrival";
  EXPECT_TRUE(AuditLog(school.admin).verify());
}

TEST_P(StoreAudit, VoidingChangesNothingElseAndHappensOnce) {
  const School school(rig->open());
  keepAttempt(school.as(school.anna));
  EXPECT_FALSE(tamper(*rig, "UPDATE attempts SET voided_us = 1, void_reason = 'x', points = 0"));
  EXPECT_TRUE(tamper(*rig, "UPDATE attempts SET voided_us = 1, voided_by = '', void_reason = 'x'"));
  EXPECT_FALSE(tamper(*rig, "UPDATE attempts SET voided_us = NULL, voided_by = NULL, void_reason = NULL"));
}

TEST_P(StoreAudit, ACurriculumWrittenPastTheProgramIsNotRead) {
  const School school(rig->open());
  valueOf(PublishedCurricula(school.admin).publish("central_line", 1, curriculumOf(1)));
  succeed(tamper(*rig, unguarded(GetParam(), "curricula", "UPDATE curricula SET text = '{\"easier\": true}'")));
  EXPECT_THAT(refusalOf(PublishedCurricula(school.admin).text("central_line", 1)),
              HasSubstr("not the one that was published"));
  EXPECT_THAT(refusalOf(StoreUpkeep(school.admin).verify()), HasSubstr("not the one that was published"));
}

TEST_P(StoreAudit, PagesGoBackFromTheNewestAndBySomeone) {
  const School school(rig->open());
  const AuditLog log(school.admin);
  const auto first = valueOf(log.page(3)), second = valueOf(log.page(3, first.back().number));
  EXPECT_EQ(second.front().number, first.back().number - 1);
  for (const AuditEntry& entry : valueOf(log.page(100, 0, school.ina.id)))
    EXPECT_TRUE(entry.actor == school.ina.id || entry.person == school.ina.id ||
                entry.detail.find(school.ina.id) != std::string::npos);
}

}  // namespace
}  // namespace insonate::test
