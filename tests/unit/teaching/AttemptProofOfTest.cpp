#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/AttemptProofOf.h>

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace insonate {
namespace {

using testing::HasSubstr;

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// Two people at a store, and an attempt that the first begins.
class AttemptProofOfTest : public testing::Test {
 protected:
  void SetUp() override {
    admin = valueOf(store.createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, "a long password"));
    facts.id = "1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa", facts.person = admin->person().id;
    facts.curriculum = "course", facts.curriculumVersion = 1, facts.level = "first";
    seal = valueOf(AttemptStore(*admin).issueSeal(facts));
    whose = {facts.id, facts.person, "course", 1, "first", seal.nonce};
  }
  static CurriculumStore open(const std::filesystem::path& file) {
    StoreServices services;
    services.passwordCost = PasswordCost::Minimum;
    return valueOf(CurriculumStore::open(file.string(), services));
  }
  std::filesystem::path record(const RecordedFor& of, const std::optional<RecordKey>& key) {
    test::ScriptedAttempt attempt;
    attempt.needleTo(25), attempt.hold(1);
    AttemptHeader header;
    header.procedure = "internal_jugular", header.picture = test::ScriptedAttempt::picture(), header.recordedFor = of;
    std::filesystem::remove(file);
    const auto recorder = valueOf(AttemptRecorder::start(file, header, nullptr, key));
    for (const auto& entry : attempt.stream) {
      while (recorder->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { recorder->record(what); }, entry);
    }
    (void)valueOf(recorder->finish(AttemptStatus::Completed));
    return file;
  }
  Result<AttemptProofOf> proof() const { return proofOfAttempt(AttemptStore(*admin), facts, file); }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "first.attempt";
  const CurriculumStore store = open(folder / "store.db");
  std::optional<SignedIn> admin;
  AttemptFacts facts;
  AttemptSeal seal;
  RecordedFor whose;
};

TEST_F(AttemptProofOfTest, WhatTheStoreSealedIsProven) {
  record(whose, seal.key);
  const auto proven = proof();
  ASSERT_TRUE(proven) << proven.error().message;
  EXPECT_EQ(proven->proof, AttemptProof::Proven);
  EXPECT_TRUE(proven->isOfStore);
  const auto read = factsOfRecording(file);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->id, facts.id);
  EXPECT_EQ(read->person, facts.person);
  EXPECT_EQ(read->level, "first");
}

TEST_F(AttemptProofOfTest, AnotherPersonsIsRefused) {
  record(whose, seal.key);
  facts.person = "another person";
  EXPECT_THAT(proof().error().message, HasSubstr("was recorded for another person"));
}

TEST_F(AttemptProofOfTest, WhatSaysOtherThanTheNonceIsRefused) {
  RecordedFor other = whose;
  other.level = "second";
  record(other, seal.key);
  EXPECT_THAT(proof().error().message, HasSubstr("its header names another attempt or level"));
  record(whose, std::nullopt);
  EXPECT_THAT(proof().error().message, HasSubstr("its codes are not those of the store"));
}

TEST_F(AttemptProofOfTest, WithoutANonceOfThisStoreNothingIsProven) {
  record({}, std::nullopt);
  EXPECT_EQ(proof()->proof, AttemptProof::Unproven);
  EXPECT_FALSE(proof()->isOfStore);
  EXPECT_THAT(proof()->why, HasSubstr("without a store of attempts"));
  const CurriculumStore elsewhere = open(folder / "elsewhere.db");
  const SignedIn there =
      valueOf(elsewhere.createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, "a long password"));
  const AttemptSeal foreign = valueOf(AttemptStore(there).issueSeal(facts));
  whose.nonce = foreign.nonce;
  record(whose, foreign.key);
  EXPECT_EQ(proof()->proof, AttemptProof::Unproven);
  EXPECT_FALSE(proof()->isOfStore);
  EXPECT_THAT(proof()->why, HasSubstr("for another store"));
}

/// As after a power cut: it is this attempt's, and proves nothing of its end.
TEST_F(AttemptProofOfTest, WhatWasCutShortIsOfTheStoreAndUnproven) {
  record(whose, seal.key);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 40);
  EXPECT_EQ(proof()->proof, AttemptProof::Unproven);
  EXPECT_TRUE(proof()->isOfStore);
  EXPECT_THAT(proof()->why, HasSubstr("stopped early"));
}

}  // namespace
}  // namespace insonate
