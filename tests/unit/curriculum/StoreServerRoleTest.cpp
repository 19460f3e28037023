#include "StoreRig.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/VideoQueue.h>
#include <insonate/curriculum/Workstations.h>

namespace insonate::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

Result<void> execute(const std::string& address, const std::string& sql) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(address)));
  if (!connection) throw std::runtime_error(connection.error().message);
  return (*connection)->script(sql);
}

/// A database of a site on PostgreSQL, and a role that may only run the server.
class StoreServerRole : public testing::Test {
 protected:
  void SetUp() override {
    if (!PostgresServer::shared()) GTEST_SKIP() << "PostgreSQL 15 is not installed";
    rig.emplace(Place::Server);
    school.emplace(rig->open());
    succeed(execute(rig->address, "DROP ROLE IF EXISTS insonate_run; CREATE ROLE insonate_run LOGIN PASSWORD 'run'"));
    succeed(StoreUpkeep(school->admin).grantServerRole("insonate_run"));
    asRole = rig->address;
    asRole.replace(asRole.find("//") + 2, asRole.find('@') - asRole.find("//") - 2, "insonate_run:run");
  }
  void TearDown() override {
    if (rig) succeed(execute(rig->address, "DROP OWNED BY insonate_run; DROP ROLE insonate_run"));
  }
  CurriculumStore open() { return valueOf(CurriculumStore::open(asRole, rig->services)); }

  std::optional<StoreRig> rig;
  std::optional<School> school;
  std::string asRole;
};

TEST_F(StoreServerRole, RunsTheServer) {
  const CurriculumStore store = open();
  const SignedIn admin = valueOf(store.signIn("admin", kPassword)), ina = valueOf(store.signIn("ina", kPassword));
  const SignedIn anna = valueOf(store.signIn("anna", kPassword));
  valueOf(PublishedCurricula(ina).publish("central_line", 1, curriculumOf(1)));
  succeed(CohortStore(admin).setCurriculum(school->spring.id, "central_line", 1));
  const AttemptFacts attempt = keepAttempt(anna);
  valueOf(FormStore(anna).add({"", "feedback", 1, school->anna.id, attempt.id, "", 0, "{}"}));
  const std::string comment = valueOf(CommentStore(ina).add(attempt.id, 0, "Slower"));
  succeed(CommentStore(ina).remove(attempt.id, comment));
  succeed(AttemptVideos(anna).request(attempt.id));
  EXPECT_TRUE(valueOf(VideoQueue(store, "server").waiting()) == 1);
  valueOf(Workstations(admin).add("ward 9"));
  succeed(Workstations(admin).revoke("ward 9"));
  valueOf(PeopleStore(admin).add({"dora", "Dora"}, "first password", school->spring.id));
  succeed(PeopleStore(admin).resetPassword(school->anna.id, "another password"));
  const Cohort summer = valueOf(CohortStore(admin).add("Summer"));
  succeed(CohortStore(admin).remove(summer.id, "Summer"));
  succeed(PersonData(admin).erase(school->anna.id));
  EXPECT_TRUE(AuditLog(admin).verify());
  EXPECT_TRUE(StoreUpkeep(admin).verify());
}

TEST_F(StoreServerRole, CannotRewriteTheLogOrSwitchGuardsOff) {
  const CurriculumStore store = open();
  for (const std::string sql :
       {"UPDATE audit SET act = ''", "DELETE FROM audit", "TRUNCATE audit", "DROP TABLE audit",
        "ALTER TABLE audit DISABLE TRIGGER USER", "ALTER TABLE attempts DISABLE TRIGGER USER",
        "UPDATE curricula SET text = '{}'", "DELETE FROM curricula", "INSERT INTO schema_migrations VALUES (99, 0)",
        "SET session_replication_role = replica", "CREATE TABLE others (id INTEGER)", "CREATE ROLE another"}) {
    const auto done = execute(asRole, sql);
    ASSERT_FALSE(done) << sql;
    EXPECT_THAT(done.error().message, HasSubstr("permission")) << sql;
  }
  EXPECT_THAT(refusalOf(execute(asRole, "UPDATE audit SET detail = ''")), HasSubstr("The audit log is not changed"));
  succeed(execute(asRole, "UPDATE audit SET detail = '(erased)' WHERE number = 3"));
  EXPECT_THAT(refusalOf(AuditLog(school->admin).verify()), HasSubstr("entry 3: it was changed"));
  EXPECT_THAT(refusalOf(StoreUpkeep(valueOf(store.signIn("admin", kPassword))).grantServerRole("pg_monitor")),
              HasSubstr("does not own the tables"));
  EXPECT_THAT(refusalOf(StoreUpkeep(school->admin).grantServerRole("insonate")), HasSubstr("is a superuser"));
}

TEST_F(StoreServerRole, LeavesAnUpgradeToTheOwner) {
  succeed(execute(rig->address,
                  "DELETE FROM schema_migrations WHERE number = (SELECT MAX(number) FROM schema_migrations)"));
  const auto opened = CurriculumStore::open(asRole, rig->services);
  ASSERT_FALSE(opened);
  EXPECT_THAT(opened.error().message, AllOf(HasSubstr("could not be upgraded"), HasSubstr("curriculum migrate")));
}

TEST_F(StoreServerRole, HasAPlainName) {
  for (const auto& name :
       std::vector<std::string>{"", "a b", "Role", "r; DROP TABLE audit", "1st", "r\"", std::string(64, 'r')})
    EXPECT_THAT(refusalOf(StoreUpkeep(school->admin).grantServerRole(name)), HasSubstr("is not a name")) << name;
  EXPECT_THAT(refusalOf(StoreUpkeep(school->admin).grantServerRole("missing")), HasSubstr("does not exist"));
}

TEST(StoreServerRoleOfAFile, IsRefused) {
  const StoreRig rig;
  const School school(rig.open());
  EXPECT_THAT(refusalOf(StoreUpkeep(school.admin).grantServerRole("insonate_run")), HasSubstr("is a file"));
}

}  // namespace
}  // namespace insonate::test
