#include "StoreRig.h"
#include "store/sql/Address.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

namespace insonate::test {
namespace {

using ::testing::HasSubstr;
using Kind = NonceOrigin::Kind;

/// Spring learns a course of one level, which one pass masters.
struct ProofSchool : School {
  explicit ProofSchool(const CurriculumStore& in) : School(in) {
    valueOf(PublishedCurricula(admin).publish("course", 1, curriculumText(courseOf({levelNamed("a", 1)}))));
    succeed(CohortStore(admin).setCurriculum(spring.id, "course", 1));
  }
  int masteredBy(const Person& person) const {
    for (const Member& row : valueOf(CohortStore(as(ina)).members(spring.id)))
      if (row.person.id == person.id) return row.standing ? row.standing->mastered : -1;
    throw std::runtime_error("not in the cohort");
  }
};

AttemptFacts pass(AttemptProof proof) {
  AttemptFacts facts = passedAttempt("a", kToday_us);
  facts.id = freshUuid(), facts.person = {}, facts.caseName = "textbook", facts.proof = proof;
  return facts;
}

AttemptProof proofOf(const SignedIn& by, const std::string& id) {
  return valueOf(AttemptStore(by).attempt(id)).facts.proof;
}

class StoreProofs : public OnBoth {};
INSONATE_ON_BOTH(StoreProofs);

TEST_P(StoreProofs, ANonceIsOfOneAttemptOfOnePersonAtOneLevel) {
  const School school(rig->open());
  const SignedIn anna = school.as(school.anna);
  AttemptFacts facts = begunFacts();
  const AttemptSeal seal = valueOf(AttemptStore(anna).issueSeal(facts));
  EXPECT_EQ(seal.nonce.size(), 128U);
  EXPECT_NE(valueOf(AttemptStore(anna).issueSeal(facts)).nonce, seal.nonce) << "a nonce is given once";
  facts.person = school.anna.id;
  const auto originOf = [&](const AttemptFacts& of, const std::string& nonce) {
    return valueOf(AttemptStore(school.admin).originOf(of, nonce));
  };
  const NonceOrigin given = originOf(facts, seal.nonce);
  EXPECT_EQ(given.kind, Kind::Given);
  EXPECT_EQ(given.key, seal.key);
  const auto changed = [&](auto change) {
    AttemptFacts other = facts;
    change(other);
    return originOf(other, seal.nonce).kind;
  };
  EXPECT_EQ(changed([&](auto& f) { f.person = school.ben.id; }), Kind::Forged);
  EXPECT_EQ(changed([](auto& f) { f.id = freshUuid(); }), Kind::Forged) << "used for a second attempt";
  EXPECT_EQ(changed([](auto& f) { f.level = "second"; }), Kind::Forged);
  EXPECT_EQ(changed([](auto& f) { f.curriculum = "other"; }), Kind::Forged);
  EXPECT_EQ(changed([](auto& f) { ++f.curriculumVersion; }), Kind::Forged);
  std::string random = seal.nonce, tag = seal.nonce;
  random[0] = random[0] == '0' ? '1' : '0', tag[40] = tag[40] == '0' ? '1' : '0';
  EXPECT_EQ(originOf(facts, random).kind, Kind::Forged);
  EXPECT_EQ(originOf(facts, tag).kind, Kind::Elsewhere);
  for (const std::string& no : {std::string(), std::string("xyz"), seal.nonce + "00", std::string(128, 'g')})
    EXPECT_EQ(originOf(facts, no).kind, Kind::Elsewhere) << no;
}

TEST_P(StoreProofs, AnotherStoreGivesOtherKeysAndTheSameStoreTheSameAfterwards) {
  const StoreRig elsewhere(GetParam());
  const School school(rig->open()), others(elsewhere.open());
  AttemptFacts facts = begunFacts();
  const AttemptSeal seal = valueOf(AttemptStore(school.as(school.anna)).issueSeal(facts));
  facts.person = others.anna.id;
  EXPECT_EQ(valueOf(AttemptStore(others.admin).originOf(facts, seal.nonce)).kind, Kind::Elsewhere);
  facts.person = school.anna.id;
  const CurriculumStore again = rig->open();
  const NonceOrigin later =
      valueOf(AttemptStore(valueOf(again.signIn("admin", kPassword))).originOf(facts, seal.nonce));
  EXPECT_EQ(later.key, seal.key);
}

TEST_P(StoreProofs, TheSecretIsNeitherChangedNorExported) {
  const School school(rig->open());
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address))).value();
  const std::string secret = valueOf(connection->rows("SELECT secret FROM store_secret", {})).front().text(0);
  EXPECT_EQ(secret.size(), 64U);
  for (const char* change : {"UPDATE store_secret SET secret = secret || ''", "DELETE FROM store_secret",
                             "INSERT INTO store_secret VALUES (1, 'x')"})
    EXPECT_FALSE(connection->script(change)) << change;
  succeed(StoreUpkeep(school.admin).exportJson(rig->folder / "all.json"));
  EXPECT_EQ(bytesOf(rig->folder / "all.json").find(secret), std::string::npos);
}

TEST_P(StoreProofs, APassThatNothingProvesMastersNothingUntilAnInstructorAcceptsIt) {
  const ProofSchool school(rig->open());
  const SignedIn anna = school.as(school.anna), ina = school.as(school.ina);
  const std::string id = valueOf(AttemptStore(anna).add(pass(AttemptProof::Unproven)));
  EXPECT_EQ(proofOf(anna, id), AttemptProof::Unproven);
  EXPECT_EQ(school.masteredBy(school.anna), 0);
  EXPECT_FALSE(AttemptStore(anna).accept(id, "mine"));
  EXPECT_FALSE(AttemptStore(school.as(school.otto)).accept(id, "of another class"));
  EXPECT_THAT(refusalOf(AttemptStore(ina).accept(id, " ")), HasSubstr("for a reason"));
  EXPECT_EQ(school.masteredBy(school.anna), 0);

  succeed(AttemptStore(ina).accept(id, "I stood beside her"));
  EXPECT_EQ(proofOf(anna, id), AttemptProof::Accepted);
  EXPECT_EQ(school.masteredBy(school.anna), 1);
  succeed(AttemptStore(ina).accept(id, "once more"));
  const auto log = valueOf(AuditLog(school.admin).page(20));
  const auto entry = std::ranges::find(log, "accept attempt", &AuditEntry::act);
  ASSERT_NE(entry, log.end());
  EXPECT_EQ(entry->actor, school.ina.id);
  EXPECT_EQ(entry->person, school.anna.id);
  succeed(StoreUpkeep(school.admin).verify());
}

TEST_P(StoreProofs, WhatIsProvenCountsAndNeedsNobody) {
  const ProofSchool school(rig->open());
  const SignedIn anna = school.as(school.anna);
  const std::string id = valueOf(AttemptStore(anna).add(pass(AttemptProof::Proven)));
  EXPECT_EQ(school.masteredBy(school.anna), 1);
  EXPECT_THAT(refusalOf(AttemptStore(school.as(school.ina)).accept(id, "seen")),
              HasSubstr("does not need to be accepted"));
  const std::string open = valueOf(AttemptStore(anna).begin(pass(AttemptProof::Proven)));
  EXPECT_THAT(refusalOf(AttemptStore(school.as(school.ina)).accept(open, "seen")), HasSubstr("still open"));
}

/// Facts that are handed in cannot bring a proof that only the store gives.
TEST_P(StoreProofs, NobodyHandsInTheirOwnAcceptance) {
  const ProofSchool school(rig->open());
  const SignedIn anna = school.as(school.anna);
  for (const AttemptProof claimed : {AttemptProof::Accepted, AttemptProof::Earlier})
    EXPECT_EQ(proofOf(anna, valueOf(AttemptStore(anna).add(pass(claimed)))), AttemptProof::Unproven);
  EXPECT_EQ(school.masteredBy(school.anna), 0);
}

/// Or a trainee would choose which attempts count.
TEST_P(StoreProofs, AFailureWithoutProofStillFails) {
  Curriculum course = courseOf({levelNamed("a", 1)});
  const AttemptFacts failed = failedAttempt("a");
  AttemptFacts unproven = failed;
  unproven.proof = AttemptProof::Unproven;
  EXPECT_EQ(computeProgress(course, {{failed, unproven}}, kNoon_us)[0].attempts, 2);
  AttemptFacts passed = passedAttempt("a");
  passed.proof = AttemptProof::Unproven;
  const auto progress = computeProgress(course, {{passed, failed}}, kNoon_us);
  EXPECT_EQ(progress[0].attempts, 1);
  EXPECT_EQ(progress[0].passes, 0);
}

TEST_P(StoreProofs, ProofsStayAsTheyAre) {
  const ProofSchool school(rig->open());
  const SignedIn anna = school.as(school.anna);
  valueOf(AttemptStore(anna).add(pass(AttemptProof::Proven)));
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig->address))).value();
  for (const char* change : {"UPDATE proofs SET state = 'unproven'", "DELETE FROM proofs"})
    EXPECT_FALSE(connection->script(change)) << change;
}

TEST_P(StoreProofs, ProofsGoUpToTheServerAndAcceptancesComeDown) {
  rig->services.workstation = "server";
  const ProofSchool school(rig->open());
  StoreRig ward;
  ward.services.now_us = [&ward] { return ward.now_us; };
  const CurriculumStore near = ward.open();
  valueOf(SiteUpload(near, school.store).exchange());
  const SignedIn anna = valueOf(near.signIn("anna", kPassword)), ina = valueOf(near.signIn("ina", kPassword));
  const std::string proven = valueOf(AttemptStore(anna).add(pass(AttemptProof::Proven)));
  const std::string accepted = valueOf(AttemptStore(anna).add(pass(AttemptProof::Unproven)));
  const std::string unproven = valueOf(AttemptStore(anna).add(pass(AttemptProof::Unproven)));
  succeed(AttemptStore(ina).accept(accepted, "seen"));
  valueOf(SiteUpload(near, school.store).exchange());
  EXPECT_EQ(proofOf(school.admin, proven), AttemptProof::Proven);
  EXPECT_EQ(proofOf(school.admin, accepted), AttemptProof::Accepted);
  EXPECT_EQ(proofOf(school.admin, unproven), AttemptProof::Unproven);
  succeed(AttemptStore(school.as(school.ina)).accept(unproven, "seen on the server"));
  valueOf(SiteUpload(near, school.store).exchange());
  EXPECT_EQ(proofOf(anna, unproven), AttemptProof::Accepted);
}

}  // namespace
}  // namespace insonate::test
