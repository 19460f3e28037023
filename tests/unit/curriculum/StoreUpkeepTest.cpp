#include "StoreRig.h"
#include "store/Migrations.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/StoreCheck.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <nlohmann/json.hpp>
#include <sqlite3.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <set>
#include <thread>

namespace insonate::test {
namespace {
namespace fs = std::filesystem;

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

void runSql(const std::string& address, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  succeed((*connection)->script(sql));
}

std::string refusalToOpen(const std::string& address, const StoreServices& services = {}) {
  return refusalOf(CurriculumStore::open(address, services));
}

/// Names in a folder, but for what SQLite keeps beside an open database.
std::set<std::string> filesIn(const fs::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(folder))
    if (const std::string name = entry.path().filename(); !name.ends_with("-wal") && !name.ends_with("-shm"))
      names.insert(name);
  return names;
}

class StoreUpkeepOnBoth : public OnBoth {};
INSONATE_ON_BOTH(StoreUpkeepOnBoth);

TEST_P(StoreUpkeepOnBoth, TheExportHoldsEverythingButPasswords) {
  const School school(rig->open());
  const AttemptFacts facts = keepAttempt(school.as(school.anna));
  valueOf(
      FormStore(school.as(school.anna)).add({"", "feedback", 1, school.anna.id, facts.id, "", 0, R"({"realism": 4})"}));
  const fs::path file = rig->folder / "all.json";
  succeed(StoreUpkeep(school.admin).exportJson(file));
  EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const auto json = nlohmann::json::parse(bytesOf(file));
  EXPECT_EQ(json.at("schema"), store::newestSchema());
  EXPECT_EQ(json.at("people").size(), 6U);
  EXPECT_EQ(json.at("attempts").at(0).at("id"), facts.id);
  EXPECT_EQ(json.at("attempts").at(0).at("points"), 81.2500000000001);
  EXPECT_EQ(json.at("attempts").at(0).at("metrics").at(1).at(2), 0.1 + 0.2);
  EXPECT_TRUE(json.at("attempts").at(0).at("voided_us").is_null());
  EXPECT_EQ(json.at("forms").at(0).at("answers").at("realism"), 4);
  EXPECT_GT(json.at("audit").size(), 10U);
  EXPECT_THAT(bytesOf(file), Not(HasSubstr("argon2")));
}

TEST_P(StoreUpkeepOnBoth, TheExportSaysWhatPassedWasVoidedOrBrokeOff) {
  const School school(rig->open());
  valueOf(PublishedCurricula(school.admin).publish("central_line", 2, curriculumOf(2)));
  const Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  const auto keep = [&](AttemptState state, int criticalErrors, const std::string& level) {
    AttemptFacts facts = begunFacts();
    facts.level = level;
    if (level.empty()) facts.curriculum = "", facts.curriculumVersion = 0;
    valueOf(AttemptStore(school.as(school.anna)).begin(facts));
    facts = endedFacts(facts);
    facts.state = state, facts.succeeded = state == AttemptState::Completed, facts.criticalErrors = criticalErrors;
    facts.metrics.clear();
    for (const MetricStandard& one : curriculum.level("jugular_first")->pass.standards)
      if (state == AttemptState::Completed && !valueOf(facts, one.metric, one.version))
        facts.metrics.push_back({one.metric, one.version, one.minimum.value_or(0)});
    succeed(AttemptStore(school.as(school.anna)).end(facts));
    return facts.id;
  };
  keep(AttemptState::Completed, 0, "jugular_first");
  keep(AttemptState::Completed, 1, "jugular_first");
  keep(AttemptState::Abandoned, 0, "jugular_first");
  keep(AttemptState::Completed, 0, "");
  succeed(AttemptStore(school.as(school.ina)).voidAttempt(keep(AttemptState::Completed, 0, "jugular_first"), "a test"));
  const fs::path file = rig->folder / "all.json";
  succeed(StoreUpkeep(school.admin).exportJson(file));
  const auto attempts = nlohmann::json::parse(bytesOf(file)).at("attempts");
  const auto column = [&](const char* name) {
    nlohmann::json values = nlohmann::json::array();
    for (const auto& attempt : attempts) values.push_back(attempt.at(name));
    return values;
  };
  EXPECT_EQ(column("passed"), nlohmann::json({true, false, false, nullptr, nullptr}));
  EXPECT_EQ(column("assistance"), nlohmann::json({"guided", "guided", "guided", nullptr, "guided"}));
  EXPECT_EQ(column("broke_off"), nlohmann::json({false, false, true, false, false}));
  EXPECT_EQ(column("voided"), nlohmann::json({false, false, false, false, true}));
  EXPECT_EQ(column("state"), nlohmann::json({"completed", "completed", "abandoned", "completed", "completed"}));
}

TEST_P(StoreUpkeepOnBoth, FactsOfTheStoreTellNoPassword) {
  const School school(rig->open());
  const insonate::StoreFacts facts = valueOf(StoreUpkeep(school.admin).facts());
  EXPECT_EQ(facts.people, 6);
  EXPECT_EQ(facts.cohorts, 2);
  EXPECT_EQ(facts.schema, store::newestSchema());
  EXPECT_THAT(facts.place, Not(HasSubstr("a b/c")));
}

TEST_P(StoreUpkeepOnBoth, ANewerSchemaIsRefusedAndLeftAsItIs) {
  (void)rig->open();
  runSql(rig->address, "INSERT INTO schema_migrations VALUES (999, 0)");
  EXPECT_THAT(refusalToOpen(rig->address), HasSubstr("newer Insonate"));
  EXPECT_THAT(refusalToOpen(rig->address), HasSubstr("999"));
}

TEST(StoreUpkeepOfFile, AServerIsBackedUpWhereItRuns) {
  if (!PostgresServer::shared()) GTEST_SKIP() << "PostgreSQL 15 is not installed";
  const StoreRig rig(Place::Server);
  const School school(rig.open());
  EXPECT_THAT(refusalOf(StoreUpkeep(school.admin).backup(rig.folder / "backup.db")), HasSubstr("pg_dump"));
}

TEST(StoreUpkeepOfFile, ABackupIsOfOneMomentAndRestoresWhileOthersHaveTheStoreOpen) {
  const StoreRig rig;
  const School school(rig.open());
  const SignedIn anna = school.as(school.anna);
  keepAttempt(anna);
  const fs::path backup = rig.folder / "backup.db";
  succeed(StoreUpkeep(school.admin).backup(backup));
  keepAttempt(anna);

  EXPECT_THAT(refusalOf(restoreStore(rig.address, backup, "admin", "wrong password")), HasSubstr("was not restored"));
  EXPECT_THAT(refusalOf(restoreStore(rig.address, backup, "ina", kPassword)), HasSubstr("not an administrator"));
  EXPECT_EQ(valueOf(AttemptStore(anna).history(school.anna.id)).size(), 2U);

  succeed(restoreStore(rig.address, backup, "admin", kPassword));
  EXPECT_EQ(valueOf(AttemptStore(anna).history(school.anna.id)).size(), 1U) << "in the session that was open";
  keepAttempt(anna);
  succeed(StoreUpkeep(school.admin).verify());
  EXPECT_THAT(filesIn(rig.folder.path()), ElementsAre("backup.db", "curriculum.db", "curriculum.db.before-restore"));

  succeed(restoreStore(rig.address, rig.address + ".before-restore", "admin", kPassword));
  EXPECT_EQ(valueOf(AttemptStore(anna).history(school.anna.id)).size(), 2U) << "and back";
}

fs::perms rightsOf(const fs::path& file) {
  return fs::status(file).permissions();
}

TEST(StoreUpkeepOfFile, OnlyTheOwnerReadsAStoreAndWhatIsCopiedFromIt) {
  const StoreRig rig;
  const fs::perms owner = fs::perms::owner_read | fs::perms::owner_write;
  {
    const School school(rig.open());
    succeed(StoreUpkeep(school.admin).backup(rig.folder / "backup.db"));
    for (const char* part : {"", "-wal", "-shm"}) EXPECT_EQ(rightsOf(rig.address + part), owner) << part;
    EXPECT_EQ(rightsOf(rig.folder / "backup.db"), owner);
    succeed(restoreStore(rig.address, rig.folder / "backup.db", "admin", kPassword));
    EXPECT_EQ(rightsOf(rig.address + ".before-restore"), owner);
  }
  fs::permissions(rig.address,
                  fs::perms::owner_read | fs::perms::owner_write | fs::perms::group_read | fs::perms::others_read);
  (void)rig.open();
  EXPECT_EQ(rightsOf(rig.address), owner) << "of an earlier program's store";
}

/// A trainee's own store, of which they are the administrator, is no way into that of the class.
TEST(StoreUpkeepOfFile, OnlyAnAdministratorOfTheStoreIsAllowedToReplaceIt) {
  const StoreRig rig;
  const School school(rig.open());
  const std::string own = rig.folder / "own.db", ownBackup = rig.folder / "own-backup.db";
  {
    const CurriculumStore made = valueOf(CurriculumStore::open(own, rig.services));
    const SignedIn anna = valueOf(made.createFirstAdministrator({"anna", "Anna", "", Role::Administrator}, kPassword));
    succeed(StoreUpkeep(anna).backup(ownBackup));
  }
  EXPECT_THAT(refusalOf(restoreStore(rig.address, ownBackup, "anna", kPassword)),
              AllOf(HasSubstr("was not restored"), HasSubstr("not an administrator of " + rig.address)));
  EXPECT_EQ(valueOf(StoreUpkeep(school.admin).facts()).people, 6);
  EXPECT_THAT(filesIn(rig.folder.path()), ElementsAre("curriculum.db", "own-backup.db", "own.db"));
  const auto tried = valueOf(AuditLog(school.admin).page(20));
  EXPECT_TRUE(std::ranges::any_of(tried, [&](const AuditEntry& entry) {
    return entry.act == "sign in" && entry.person == school.anna.id && entry.allowed;
  })) << "the try is written down";

  succeed(restoreStore(rig.address, ownBackup, "admin", kPassword));
  const SignedIn anna = valueOf(rig.open().signIn("anna", kPassword));
  const auto entries = valueOf(AuditLog(anna).page(10));
  const auto restored = std::ranges::find(entries, "restore backup", &AuditEntry::act);
  ASSERT_NE(restored, entries.end());
  EXPECT_EQ(restored->actor, school.admin.person().id);
  EXPECT_THAT(restored->detail, HasSubstr("over a store whose log ends at "));
}

TEST(StoreUpkeepOfFile, ADatabaseOfAnotherProgramIsNotReplaced) {
  const StoreRig rig;
  const School school(rig.open());
  const fs::path backup = rig.folder / "backup.db";
  succeed(StoreUpkeep(school.admin).backup(backup));
  const std::string other = rig.folder / "photos.db";
  runSql(other, "CREATE TABLE photos (id INTEGER)");
  EXPECT_THAT(refusalOf(restoreStore(other, backup, "admin", kPassword)), HasSubstr("another program"));
}

TEST(StoreUpkeepOfFile, ABackupWhileOthersWriteIsWhole) {
  const StoreRig rig;
  const School school(rig.open());
  const SignedIn anna = school.as(school.anna);
  std::atomic<bool> stop{false};
  std::thread writer([&] {
    while (!stop) keepAttempt(anna);
  });
  for (int i = 0; i < 5; ++i) {
    const std::string backup = rig.folder / ("backup" + std::to_string(i));
    EXPECT_TRUE(StoreUpkeep(school.admin).backup(backup));
    const CurriculumStore copy = valueOf(CurriculumStore::open(backup, rig.services));
    EXPECT_TRUE(StoreUpkeep(valueOf(copy.signIn("admin", kPassword))).verify());
  }
  stop = true;
  writer.join();
}

TEST(StoreUpkeepOfFile, ADamagedStoreIsRefusedAndABackupTakesItsPlace) {
  const StoreRig rig;
  const fs::path backup = rig.folder / "backup.db";
  {
    const School school(rig.open());
    keepAttempt(school.as(school.anna));
    succeed(StoreUpkeep(school.admin).backup(backup));
  }
  const auto size = static_cast<std::streamoff>(fs::file_size(rig.address));
  {
    std::fstream file(rig.address, std::ios::in | std::ios::out | std::ios::binary);
    for (std::streamoff at = 4096; at < size; at += 512) file.seekp(at) << "damage";
  }
  EXPECT_THAT(refusalToOpen(rig.address), HasSubstr("Put a backup in its place"));
  succeed(restoreStore(rig.address, backup, "admin", kPassword));
  const SignedIn anna = valueOf(rig.open().signIn("anna", kPassword));
  EXPECT_EQ(valueOf(AttemptStore(anna).history(anna.person().id)).size(), 1U);
  EXPECT_TRUE(fs::exists(rig.address + ".before-restore"));
}

/// Opens the store and a connection of another thread, then changes the file under both.
void expectNoUse(const std::function<void(const fs::path&)>& change, const std::string& why) {
  const StoreRig rig;
  const School school(rig.open());
  change(rig.address);
  EXPECT_THAT(refusalOf(school.store.hasPeople()), HasSubstr(why));
  EXPECT_THAT(refusalOf(school.store.signIn("anna", kPassword)), HasSubstr(why));
  std::string elsewhere;
  std::thread([&] { elsewhere = refusalOf(school.store.hasPeople()); }).join();
  EXPECT_THAT(elsewhere, HasSubstr(rig.address)) << "a thread that had no connection before";
}

TEST(StoreUpkeepOfFile, AStoreThatIsTakenAwayWhileItIsInUseIsNoLongerUsed) {
  expectNoUse([](const fs::path& file) { fs::remove(file); }, "was deleted while it was in use");
  expectNoUse([](const fs::path& file) { fs::resize_file(file, 0); }, "was emptied while it was in use");
  expectNoUse(
      [](const fs::path& file) {
        fs::rename(file, file.string() + ".moved");
        fs::copy_file(file.string() + ".moved", file);
      },
      "was replaced while it was in use");
  const StoreRig rig;
  const School school(rig.open());
  fs::remove(rig.address);
  (void)school.store.hasPeople();
  EXPECT_FALSE(fs::exists(rig.address)) << "no new, empty store takes its place";
}

TEST(StoreUpkeepOfFile, OpeningALockedStoreEnds) {
  const StoreRig rig;
  { const School school(rig.open()); }
  sqlite3* owner = nullptr;
  ASSERT_EQ(sqlite3_open(rig.address.c_str(), &owner), SQLITE_OK);
  ASSERT_EQ(sqlite3_exec(owner, "PRAGMA locking_mode = EXCLUSIVE; BEGIN EXCLUSIVE; UPDATE people SET email = ''",
                         nullptr, nullptr, nullptr),
            SQLITE_OK);
  EXPECT_THAT(refusalToOpen(rig.address), HasSubstr("in use by another program for longer than 10 s"));
  sqlite3_close(owner);
}

TEST(StoreUpkeepOfFile, ABackupThatWasWrittenToIsNotRestored) {
  const StoreRig rig;
  const School school(rig.open());
  const std::string backup = rig.folder / "backup.db";
  succeed(StoreUpkeep(school.admin).backup(backup));
  runSql(backup, "DROP TRIGGER audit_fixed; UPDATE audit SET actor = '' WHERE number = 3");
  EXPECT_THAT(refusalOf(restoreStore(rig.address, backup, "admin", kPassword)), HasSubstr("entry 3: it was changed"));
  EXPECT_THAT(refusalOf(restoreStore(rig.address, rig.folder / "nosuch.db", "admin", kPassword)),
              HasSubstr("does not exist"));
  EXPECT_THAT(refusalOf(restoreStore(rig.address, rig.address, "admin", kPassword)), HasSubstr("the store itself"));
}

TEST(StoreUpkeepOfFile, WhatIsNoStoreIsRefusedAndLeftAlone) {
  const TemporaryFolder folder;
  const std::string text = folder / "letter.txt", other = folder / "photos.db";
  std::ofstream(text) << std::string(10'000, 'x');
  runSql(other, "CREATE TABLE photos (id INTEGER)");
  EXPECT_THAT(refusalToOpen(text), HasSubstr("is damaged or is not a curriculum's database"));
  EXPECT_THAT(refusalToOpen(other), HasSubstr("another program"));
  EXPECT_THAT(refusalToOpen(folder / "nosuch/curriculum.db"), HasSubstr("Check that its folder exists"));
  EXPECT_THAT(refusalToOpen(folder.path()), HasSubstr("is a folder"));
  EXPECT_THAT(refusalToOpen(""), HasSubstr("is empty"));
  EXPECT_THAT(refusalToOpen("postgresql://localhost/db"), HasSubstr("does not name a user"));
  EXPECT_THAT(refusalToOpen("postgresql://me:secret@127.0.0.1:1/db"),
              AllOf(HasSubstr("cannot be reached"), Not(HasSubstr("secret"))));
  EXPECT_EQ(bytesOf(text), std::string(10'000, 'x'));
}

TEST(StoreUpkeepOfFile, AnOddFileNameIsAFileName) {
  const TemporaryFolder folder;
  const std::string odd = folder / "klinik ä'\"%20;?#.db";
  { (void)valueOf(CurriculumStore::open(odd)); }
  EXPECT_TRUE(fs::exists(odd));
  EXPECT_EQ(filesIn(folder.path()).size(), 1U);
}

/// A store that an earlier program left, one file for each schema that was ever published: `sqlite3 FILE .dump`.
class StoreUpkeepOfEarlier : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Schemas, StoreUpkeepOfEarlier, ::testing::Range(1, 16));

std::string dumpOf(int schema) {
  return bytesOf(fs::path(INSONATE_SOURCE_DIR) / "tests/unit/curriculum/schemas" / (std::to_string(schema) + ".sql"));
}

/// Makes the same store on a server: the steps up to then, and the rows of the file. Writes past triggers and keys.
void copyToServer(const std::string& file, const std::string& server, int schema) {
  const auto from = store::Connection::open(valueOf(store::Address::parse(file))).value();
  const auto to = store::Connection::open(valueOf(store::Address::parse(server))).value();
  succeed(
      to->script("CREATE TABLE schema_migrations (number BIGINT NOT NULL PRIMARY KEY, applied_us BIGINT NOT NULL)"));
  std::set<fs::path> steps;
  for (const auto& entry : fs::directory_iterator(fs::path(INSONATE_SOURCE_DIR) / "resources/migrations"))
    steps.insert(entry.path());
  for (const fs::path& step : steps) {
    if (step.stem().string().ends_with("_sqlite") || std::stoi(step.filename()) > schema) continue;
    succeed(to->script(to->dialect().spelled(bytesOf(step))));
  }
  succeed(to->script("SET session_replication_role = replica"));
  for (const store::Row& table : valueOf(from->rows("SELECT name FROM sqlite_master WHERE type = 'table'", {}))) {
    const std::string name = table.text(0);
    succeed(to->script("DELETE FROM " + name));  // what the steps themselves put there
    for (const store::Row& row : valueOf(from->rows("SELECT * FROM " + name, {}))) {
      std::string places;
      std::vector<QVariant> values;
      for (std::size_t i = 0; i < row.size(); ++i) values.push_back(row.value(i)), places += i ? ", ?" : "?";
      valueOf(to->run("INSERT INTO " + name + " VALUES (" + places + ")", values));
    }
  }
}

void expectAllThatItHeld(const CurriculumStore& store, int schema) {
  const SignedIn admin = valueOf(store.signIn("admin", kPassword));
  const insonate::StoreFacts facts = valueOf(StoreUpkeep(admin).facts());
  EXPECT_EQ(facts.schema, store::newestSchema());
  EXPECT_EQ(facts.people, 6);
  EXPECT_EQ(facts.attempts, 2);
  EXPECT_EQ(facts.forms, 1);
  succeed(StoreUpkeep(admin).verify());
  EXPECT_TRUE(valueOf(StoreCheck(admin).againstLog()).empty()) << "earlier programs wrote no entries";
  EXPECT_TRUE(valueOf(StoreCheck(admin).standings()).empty());
  const SignedIn anna = valueOf(store.signIn("anna", kPassword));
  const auto history = valueOf(AttemptStore(anna).history(anna.person().id));
  EXPECT_EQ(history[0].metrics, endedFacts({}).metrics);
  EXPECT_EQ(history[1].state, AttemptState::Voided);
  EXPECT_EQ(history[0].proof, AttemptProof::Earlier) << "it counts as it did";
  EXPECT_EQ(history[0].testConditions, TestConditions::Earlier);
  EXPECT_EQ(valueOf(CommentStore(anna).countsOf(anna.person().id)).size(), schema < 7 ? 0U : 1U);
}

TEST_P(StoreUpkeepOfEarlier, IsBroughtUpToDateWithAllThatItHeld) {
  const StoreRig rig;
  runSql(rig.address, dumpOf(GetParam()));
  expectAllThatItHeld(rig.open(), GetParam());
  EXPECT_EQ(fs::exists(store::copyBeforeMigration(rig.address, GetParam())), GetParam() != store::newestSchema());
}

TEST_P(StoreUpkeepOfEarlier, IsMigratedForAnAdministratorOfItAlone) {
  if (GetParam() == store::newestSchema()) GTEST_SKIP() << "it is the newest";
  const StoreRig rig;
  runSql(rig.address, dumpOf(GetParam()));
  const auto schema = [&] {
    const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address))).value();
    return valueOf(connection->rows("SELECT MAX(number) FROM schema_migrations", {})).front().count(0);
  };
  EXPECT_THAT(refusalOf(migrateStore(rig.address, "anna", kPassword, rig.services)), HasSubstr("was not migrated"));
  EXPECT_THAT(refusalOf(migrateStore(rig.address, "admin", "wrong", rig.services)), HasSubstr("was not migrated"));
  EXPECT_EQ(schema(), GetParam());
  succeed(migrateStore(rig.address, "admin", kPassword, rig.services));
  EXPECT_EQ(schema(), store::newestSchema());
}

TEST_P(StoreUpkeepOfEarlier, IsBroughtUpToDateOnAServerToo) {
  if (!PostgresServer::shared()) GTEST_SKIP() << "PostgreSQL 15 is not installed";
  const StoreRig file, server(Place::Server);
  runSql(file.address, dumpOf(GetParam()));
  copyToServer(file.address, server.address, GetParam());
  expectAllThatItHeld(server.open(), GetParam());
}

TEST(StoreUpkeepOfNewest, HasAnEarlierStoreToTestWith) {
  const std::string name = "unit/curriculum/schemas/" + std::to_string(store::newestSchema()) + ".sql";
  EXPECT_TRUE(fs::exists(fs::path(INSONATE_SOURCE_DIR) / "tests" / name))
      << "dump a store of the new schema for later programs";
}

}  // namespace
}  // namespace insonate::test
