#include "StoreRig.h"
#include "support/ReadOnlyFolder.h"

#include <insonate/curriculum/AuditLog.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace insonate::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

StoreServices readingServices(const StoreRig& rig) {
  StoreServices services = rig.services;
  services.opensReadOnly = true;
  return services;
}

TEST(StoreReadOnly, IsReadAndStoresNothing) {
  const StoreRig rig;
  Person anna;
  AttemptFacts facts;
  {
    const School school(rig.open());
    anna = school.anna;
    facts = keepAttempt(school.as(anna));
    EXPECT_FALSE(school.store.isReadOnly());
  }
  const std::string before = bytesOf(rig.address);
  const ReadOnlyFolder now(rig.folder.path());
  EXPECT_FALSE(CurriculumStore::open(rig.address, rig.services)) << "a server, for example, has to store";

  const CurriculumStore store = valueOf(CurriculumStore::open(rig.address, readingServices(rig)));
  EXPECT_TRUE(store.isReadOnly());
  EXPECT_EQ(store.place(), rig.address);
  EXPECT_EQ(store.recordings(), rig.address + ".recordings");
  EXPECT_FALSE(store.signIn("ina", "another password"));
  const SignedIn ina = valueOf(store.signIn("ina", kPassword));
  const auto attempts = valueOf(AttemptStore(ina).page(anna.id, 10));
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts.front().facts.id, facts.id);
  EXPECT_EQ(attempts.front().facts.metrics, facts.metrics);
  EXPECT_FALSE(valueOf(AuditLog(valueOf(store.signIn("admin", kPassword))).page(10)).empty());

  const std::string refusal = rig.address + " can only be read, so nothing can be stored";
  EXPECT_THAT(refusalOf(AttemptStore(ina).voidAttempt(facts.id, "a mistake")), HasSubstr(refusal));
  EXPECT_THAT(refusalOf(AttemptStore(valueOf(store.signIn("anna", kPassword))).begin(begunFacts())),
              HasSubstr(refusal));
  EXPECT_THAT(refusalOf(PeopleStore(ina).changeOwnPassword(kPassword, "another password")), HasSubstr(refusal));
  EXPECT_EQ(bytesOf(rig.address), before);
  EXPECT_FALSE(fs::exists(rig.address + "-wal"));
}

TEST(StoreReadOnly, HasWhatAnotherProgramHasJustWritten) {
  const StoreRig rig;
  const School school(rig.open());
  const AttemptFacts facts = keepAttempt(school.as(school.anna));
  ASSERT_TRUE(fs::exists(rig.address + "-wal"));
  const ReadOnlyFolder now(rig.folder.path());
  const CurriculumStore store = valueOf(CurriculumStore::open(rig.address, readingServices(rig)));
  const auto attempts = valueOf(AttemptStore(valueOf(store.signIn("ina", kPassword))).page(school.anna.id, 10));
  ASSERT_EQ(attempts.size(), 1U);
  EXPECT_EQ(attempts.front().facts.id, facts.id);
}

TEST(StoreReadOnly, ADatabaseThatCanBeWrittenIsOpenedAsUsual) {
  const StoreRig rig;
  const CurriculumStore store = valueOf(CurriculumStore::open(rig.address, readingServices(rig)));
  EXPECT_FALSE(store.isReadOnly());
  EXPECT_TRUE(store.createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, kPassword));
}

}  // namespace
}  // namespace insonate::test
