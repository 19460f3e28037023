#include "StoreRig.h"
#include "store/Texts.h"
#include "store/sql/Connection.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/CommentStore.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/OpeningStore.h>
#include <insonate/curriculum/PersonData.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Retention.h>
#include <insonate/curriculum/SiteService.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreChanges.h>
#include <insonate/curriculum/StoreUpkeep.h>
#include <insonate/curriculum/VerificationQueue.h>
#include <insonate/curriculum/Workstations.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace insonate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A server of either kind, and a workstation with a token instead of a password of the database.
class StoreSite : public OnBoth {
 protected:
  void SetUp() override {
    OnBoth::SetUp();
    if (IsSkipped()) return;
    rig->services.workstation = "server";
    if (GetParam() == Place::Server) rig->services.recordings = rig->folder / "recordings";
    school.emplace(rig->open());
    Level exam = levelNamed("exam", 1);
    exam.assistance = Assistance::Test;
    valueOf(
        PublishedCurricula(school->admin).publish("course", 1, curriculumText(courseOf({levelNamed("a", 1), exam}))));
    succeed(CohortStore(school->admin).setCurriculum(school->spring.id, "course", 1));
    rig->pass(kSecond_us);
    ward.services.now_us = [this] { return rig->now_us; };
    near.emplace(ward.open());
    token = valueOf(Workstations(school->admin).add("ward 7"));
  }

  /// Requests go to the server as its program passes them on.
  SiteLink link() {
    return {.place = "https://site.example.org", .send = [this](const std::string& path, const std::string& body) {
              ++requests;
              if (breaksAt == requests) return Result<SiteAnswer>(fail("The connection broke."));
              return passOn(path, body);
            }};
  }
  Result<SiteAnswer> passOn(const std::string& path, const std::string& body) const {
    const SiteService service(school->store, recordingsPerDay_bytes);
    const auto workstation = valueOf(service.workstationOf(token));
    if (!workstation) return SiteAnswer{true, "The token is not valid."};
    const auto answer = service.answer(*workstation, path, body);
    return answer ? SiteAnswer{false, *answer} : SiteAnswer{true, answer.error().message};
  }
  SiteUpload site() { return {*near, link()}; }
  SignedIn here(const Person& person) {
    EXPECT_EQ(valueOf(site().signIn(person.name, kPassword)), SiteUpload::Reached::Yes);
    return valueOf(near->signIn(person.name, kPassword));
  }
  /// An attempt that passes, with a recording of this size.
  AttemptFacts attemptOf(const SignedIn& by, std::size_t size_bytes = 2000, const std::string& level = "a") {
    const auto file = ward.folder / "recording";
    const std::string content(size_bytes, static_cast<char>('a' + attempts++));
    std::ofstream(file) << content;
    AttemptFacts facts = passedAttempt(level, rig->now_us);
    facts.id = freshUuid(), facts.person = {}, facts.caseName = "textbook", facts.proof = AttemptProof::Proven;
    facts.recording = "a.rec", facts.recordingHash = store::sha256(content);
    valueOf(AttemptStore(by).add(facts, file));
    return facts;
  }
  /// Answer of the server to a completed attempt of Anna that claims all it can, changed by `change`.
  template <class Change>
  std::string errorsOf(const AttemptFacts& facts, const Change& change) const {
    nlohmann::json attempt = {{"facts",
                               {{"id", facts.id},
                                {"person", school->anna.id},
                                {"curriculum", "course"},
                                {"curriculumVersion", 1},
                                {"level", "a"},
                                {"procedure", "p"},
                                {"procedureVersion", 1},
                                {"case", "textbook"},
                                {"caseHash", ""},
                                {"workstation", "ward 7"},
                                {"begun_us", rig->now_us},
                                {"length_us", 60'000'000},
                                {"state", "completed"},
                                {"succeeded", true},
                                {"criticalErrors", 0},
                                {"points", 95.0},
                                {"metrics", nlohmann::json::array()},
                                {"recording", "a.rec"},
                                {"recordingHash", std::string(64, 'a')},
                                {"handsHash", ""},
                                {"proof", "demonstration"},
                                {"sitting", "earlier"}}},
                              {"crashed", false},
                              {"voidReason", ""},
                              {"voided_us", nullptr},
                              {"voidedBy", ""},
                              {"acceptedBy", ""},
                              {"comments", nlohmann::json::array()}};
    change(attempt);
    const nlohmann::json item = {
        {"number", 1}, {"kind", "attempt"}, {"id", facts.id}, {"attempt", attempt}, {"form", nullptr}};
    const nlohmann::json batch = {{"version", 3}, {"items", {item}}, {"logEnd", 1}, {"logHash", "x"}};
    return nlohmann::json::parse(valueOf(passOn("facts", batch.dump())).text)["troubles"].dump();
  }
  StoredAttempt onServer(const AttemptFacts& facts) const {
    return valueOf(AttemptStore(school->admin).attempt(facts.id));
  }
  int masteredBy(const Person& person) const {
    for (const Member& row : valueOf(CohortStore(school->as(school->ina)).members(school->spring.id)))
      if (row.person.id == person.id) return row.standing ? row.standing->mastered : -1;
    return -2;
  }

  std::int64_t recordingsPerDay_bytes = SiteService::kRecordingsPerDay_bytes;
  StoreRig ward;
  std::optional<School> school;  ///< on the server
  std::optional<CurriculumStore> near;
  std::string token;
  int requests = 0, breaksAt = 0, attempts = 0;
};
INSONATE_ON_BOTH(StoreSite);

TEST_P(StoreSite, AWorkstationKnowsOnlyWhoSignedInAtIt) {
  valueOf(site().exchange());
  EXPECT_FALSE(near->signIn("anna", kPassword)) << "nobody has signed in yet";
  EXPECT_EQ(here(school->anna).person(), school->anna);
  EXPECT_TRUE(near->signIn("anna", kPassword)) << "without connection, too";
  EXPECT_FALSE(near->signIn("ben", kPassword));
  const StoreUpkeep upkeep(here(school->admin.person()));
  EXPECT_EQ(valueOf(upkeep.facts()).people, 3) << "anna, her instructor and the administrator";
}

TEST_P(StoreSite, AnInstructorBringsTheLearnersWithoutTheirPasswords) {
  const SignedIn ina = here(school->ina);
  EXPECT_EQ(valueOf(CohortStore(ina).members(school->spring.id)).size(), 3U);
  EXPECT_FALSE(near->signIn("ben", kPassword));
  EXPECT_EQ(here(school->ben).person(), school->ben);
}

TEST_P(StoreSite, WrongPasswordsAreRefusedByTheServerAndLockTheName) {
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(site().signIn("anna", "wrong password"));
  EXPECT_THAT(refusalOf(site().signIn("anna", kPassword)), HasSubstr("30 s"));
}

TEST_P(StoreSite, APasswordThatTheServerChangedIsAskedForAnew) {
  here(school->anna);
  succeed(PeopleStore(school->admin).resetPassword(school->anna.id, "set on the server"));
  valueOf(site().exchange());
  EXPECT_FALSE(near->signIn("anna", kPassword));
  EXPECT_FALSE(near->signIn("anna", "set on the server")) << "the server has not sent it";
  EXPECT_EQ(valueOf(site().signIn("anna", "set on the server")), SiteUpload::Reached::Yes);
  EXPECT_TRUE(near->signIn("anna", "set on the server"));
}

TEST_P(StoreSite, APasswordIsChangedOnTheServer) {
  const SignedIn anna = here(school->anna);
  EXPECT_THAT(refusalOf(PeopleStore(anna).changeOwnPassword(kPassword, "changed in the ward")),
              HasSubstr("change it there"));
  EXPECT_THAT(refusalOf(site().changePassword("anna", "wrong password", "changed in the ward")), HasSubstr("password"));
  succeed(site().changePassword("anna", kPassword, "changed in the ward"));
  EXPECT_TRUE(school->store.signIn("anna", "changed in the ward"));
  EXPECT_TRUE(near->signIn("anna", "changed in the ward"));
  EXPECT_FALSE(near->signIn("anna", kPassword));
}

TEST_P(StoreSite, WithoutConnectionAPersonWhoIsKnownHereSignsIn) {
  here(school->anna);
  requests = 0, breaksAt = 1;
  EXPECT_EQ(valueOf(site().signIn("anna", kPassword)), SiteUpload::Reached::No);
  EXPECT_TRUE(near->signIn("anna", kPassword));
}

TEST_P(StoreSite, APassCountsOnceTheServerHasVerifiedIt) {
  const AttemptFacts facts = attemptOf(here(school->anna), 1'300'000);
  const UploadReport report = valueOf(site().exchange());
  EXPECT_EQ(report.attempts, 1);
  EXPECT_EQ(report.recordings, 1);
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Verifying);
  EXPECT_EQ(masteredBy(school->anna), 0) << "the workstation's word is not enough";

  const VerificationQueue queue(school->store);
  const auto waiting = valueOf(queue.takeNext());
  ASSERT_TRUE(waiting);
  EXPECT_EQ(waiting->facts.id, facts.id);
  EXPECT_EQ(store::sha256(contentOf(waiting->recording)), facts.recordingHash);
  succeed(queue.storeResult(facts.id, true, ""));
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Proven);
  EXPECT_EQ(masteredBy(school->anna), 1);
  EXPECT_EQ(valueOf(queue.waiting()), 0);
  const auto log = valueOf(AuditLog(school->admin).page(20));
  EXPECT_TRUE(std::ranges::any_of(
      log, [&](const AuditEntry& entry) { return entry.act == "verify attempt" && entry.detail == facts.id; }));
  succeed(StoreUpkeep(school->admin).verify());
}

TEST_P(StoreSite, AtAnotherWorkstationAPersonFindsTheLevelsThatWereMastered) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  valueOf(site().exchange());
  StoreRig other;
  other.services.workstation = "ward 8", other.services.now_us = ward.services.now_us;
  const CurriculumStore far = other.open();
  const std::string farToken = valueOf(Workstations(school->admin).add("ward 8"));
  const auto exchange = [&](bool isSigningIn) {
    const std::string nearToken = std::exchange(token, farToken);
    const SiteUpload farSite(far, link());
    if (isSigningIn) valueOf(farSite.signIn("anna", kPassword));
    const UploadReport report = valueOf(farSite.exchange());
    token = nearToken;
    return report;
  };
  const auto proofThere = [&] {
    return valueOf(AttemptStore(valueOf(far.signIn("anna", kPassword))).attempt(facts.id)).facts.proof;
  };
  EXPECT_THAT(exchange(true).errors, IsEmpty());
  EXPECT_EQ(proofThere(), AttemptProof::Unproven) << "not verified yet";
  succeed(VerificationQueue(school->store).storeResult(facts.id, true, ""));
  EXPECT_THAT(exchange(false).errors, IsEmpty());
  EXPECT_EQ(proofThere(), AttemptProof::Proven);
  succeed(AttemptStore(school->as(school->ina)).voidAttempt(facts.id, "device failed"));
  exchange(false);
  EXPECT_EQ(valueOf(AttemptStore(valueOf(far.signIn("anna", kPassword))).attempt(facts.id)).voidReason,
            "device failed");
  EXPECT_EQ(valueOf(SiteUpload(far, link()).pending()), 0) << "it is not sent back";
  exchange(false);
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).attempts, 1);
}

TEST_P(StoreSite, ManyAttemptsElsewhereArriveInParts) {
  constexpr std::size_t kEach = 110;
  const std::vector<Person> learners{school->anna, school->ben, school->add("dora", Role::Trainee, school->spring.id)};
  for (const Person& learner : learners) {
    const SignedIn by = school->as(learner);
    for (std::size_t i = 0; i < kEach; ++i) {
      AttemptFacts facts = endedFacts(begunFacts());
      facts.recordingHash = store::sha256(facts.id);
      valueOf(AttemptStore(by).begin(facts));
      succeed(AttemptStore(by).end(facts));
    }
  }
  int parts = 0;
  SiteLink counted = link();
  counted.send = [&parts, send = counted.send](const std::string& path, const std::string& body) {
    parts += path == "attempts-elsewhere" ? 1 : 0;
    return send(path, body);
  };
  bool breaks = true;
  counted.send = [&, send = counted.send](const std::string& path, const std::string& body) {
    return breaks && parts == 1 && path == "attempts-elsewhere" ? Result<SiteAnswer>(fail("The connection broke."))
                                                                : send(path, body);
  };
  const SiteUpload site(*near, counted);
  EXPECT_EQ(valueOf(site.signIn("ina", kPassword)), SiteUpload::Reached::Yes) << "although a part is missing";
  breaks = false;
  EXPECT_THAT(valueOf(site.exchange()).errors, IsEmpty());
  EXPECT_EQ(parts, 2) << "220 attempts of two learners, then those of the third";
  const SignedIn ina = valueOf(near->signIn("ina", kPassword));
  for (const Person& learner : learners)
    EXPECT_EQ(valueOf(AttemptStore(ina).page(learner.id, 1000)).size(), kEach) << learner.name;
  EXPECT_THAT(valueOf(site.exchange()).errors, IsEmpty());
  EXPECT_EQ(parts, 3) << "nothing is sent again";
}

TEST_P(StoreSite, WhatDoesNotAgreeWithItsRecordingIsNotProven) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  valueOf(site().exchange());
  const VerificationQueue queue(school->store);
  ASSERT_TRUE(valueOf(queue.takeNext()));
  succeed(queue.storeResult(facts.id, false, "points: 95 stored, 60 recomputed"));
  succeed(queue.storeResult(facts.id, true, ""));
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Unproven) << "the first result stays";
  EXPECT_EQ(masteredBy(school->anna), 0);
  const auto proofHere = [&] {
    return valueOf(AttemptStore(valueOf(near->signIn("anna", kPassword))).attempt(facts.id)).facts.proof;
  };
  EXPECT_EQ(proofHere(), AttemptProof::Proven);
  EXPECT_THAT(valueOf(site().exchange()).errors, ElementsAre(HasSubstr("points: 95 stored, 60 recomputed")));
  EXPECT_EQ(proofHere(), AttemptProof::Unproven) << "the level closes here, too";
  EXPECT_THAT(valueOf(site().exchange()).errors, IsEmpty()) << "it is told once";
  succeed(AttemptStore(school->as(school->ina)).accept(facts.id, "I watched it"));
  EXPECT_EQ(masteredBy(school->anna), 1);
  valueOf(site().exchange());
  EXPECT_EQ(proofHere(), AttemptProof::Accepted);
}

TEST_P(StoreSite, AnAttemptIsTakenByOneServerAndAgainIfThatOneDied) {
  const AttemptFacts first = attemptOf(here(school->anna)), second = attemptOf(here(school->anna));
  valueOf(site().exchange());
  const VerificationQueue queue(school->store);
  EXPECT_EQ(valueOf(queue.takeNext())->facts.id, first.id);
  EXPECT_EQ(valueOf(queue.takeNext())->facts.id, second.id);
  EXPECT_FALSE(valueOf(queue.takeNext()));
  rig->pass(11 * 60 * kSecond_us);
  EXPECT_TRUE(valueOf(queue.takeNext()));
}

TEST_P(StoreSite, ARecordingGoesOnWhereTheConnectionBroke) {
  const AttemptFacts facts = attemptOf(here(school->anna), 2'000'000);
  requests = 0, breaksAt = 9;  // the second of four parts
  EXPECT_THAT(valueOf(site().exchange()).errors, ElementsAre(HasSubstr("broke")));
  EXPECT_FALSE(valueOf(VerificationQueue(school->store).takeNext()));
  requests = breaksAt = 0;
  EXPECT_EQ(valueOf(site().exchange()).recordings, 1);
  EXPECT_EQ(requests, 9) << "three parts are left of four";
  EXPECT_EQ(store::sha256(contentOf(valueOf(VerificationQueue(school->store).takeNext())->recording)),
            facts.recordingHash);
}

TEST_P(StoreSite, AWorkstationCannotFillTheDiskOfTheServer) {
  recordingsPerDay_bytes = 1'500'000;
  const SignedIn anna = here(school->anna);
  std::vector<AttemptFacts> facts;
  for (int i = 0; i < 4; ++i) facts.push_back(attemptOf(anna, 1'000'000));
  const UploadReport first = valueOf(site().exchange());
  EXPECT_EQ(first.recordings, 1);
  EXPECT_THAT(first.errors, ElementsAre(HasSubstr("up to 0.0015 GB from this computer in 24 hours")));
  EXPECT_THAT(first.errors, ElementsAre(HasSubstr("stay on this computer and are sent later")));
  std::uintmax_t stored_bytes = 0;
  for (const auto& file : std::filesystem::directory_iterator(school->store.recordings()))
    stored_bytes += file.file_size();
  EXPECT_LE(stored_bytes, 1'500'000U) << "with the part of the second recording";
  for (const AttemptFacts& one : facts)
    EXPECT_EQ(store::sha256(contentOf(near->recordings() / (one.id + ".attempt"))), one.recordingHash);
  EXPECT_EQ(valueOf(site().exchange()).recordings, 0) << "on the same day";
  int sent = 1;
  for (int day = 1; day <= 4; ++day) {
    rig->pass(25 * 3600 * kSecond_us);
    sent += valueOf(site().exchange()).recordings;
    EXPECT_LE(sent, 1 + day);
  }
  EXPECT_EQ(sent, 4);
  EXPECT_THAT(valueOf(site().exchange()).errors, IsEmpty());
}

TEST_P(StoreSite, ARecordingOfAnotherContentIsNotTaken) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  std::ofstream(near->recordings() / (facts.id + ".attempt")) << std::string(2000, 'x');
  EXPECT_THAT(valueOf(site().exchange()).errors, ElementsAre(HasSubstr("was changed")));
  EXPECT_FALSE(valueOf(VerificationQueue(school->store).takeNext()));
}

TEST_P(StoreSite, AnAttemptOfALostWorkstationCanBeAccepted) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  std::filesystem::remove(near->recordings() / (facts.id + ".attempt"));
  valueOf(site().exchange());
  ASSERT_EQ(onServer(facts).facts.proof, AttemptProof::Verifying);
  succeed(AttemptStore(school->as(school->ina)).accept(facts.id, "I watched it"));
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Accepted);
  EXPECT_EQ(masteredBy(school->anna), 1);
  EXPECT_EQ(valueOf(VerificationQueue(school->store).waiting()), 0);
  const AttemptFacts arrived = attemptOf(here(school->anna));
  valueOf(site().exchange());
  EXPECT_THAT(refusalOf(AttemptStore(school->as(school->ina)).accept(arrived.id, "I watched it")),
              HasSubstr("is verifying the attempt"));
}

TEST_P(StoreSite, WithoutItsRecordingAnAttemptStaysUnproven) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  std::filesystem::remove(near->recordings() / (facts.id + ".attempt"));
  valueOf(site().exchange());
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Verifying) << "it may still come";
  rig->pass(25 * 3600 * kSecond_us);
  valueOf(site().exchange());
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Unproven);
  EXPECT_EQ(masteredBy(school->anna), 0);
}

TEST_P(StoreSite, AnAttemptElsewhereIsOfThePersonWhoMadeIt) {
  here(school->anna);
  const AttemptFacts bens = keepAttempt(school->as(school->ben));
  EXPECT_THAT(errorsOf(bens, [](auto& attempt) { attempt["facts"]["workstation"] = "server"; }),
              HasSubstr("made at the workstation 'server'"))
      << "said to be of a person on whose attempts the author may comment";
}

TEST_P(StoreSite, ProofsAndActsThatAWorkstationClaimsAreNotBelieved) {
  const SignedIn anna = here(school->anna);
  here(school->otto);  // teaches another class
  const AttemptFacts facts = attemptOf(anna);
  const auto message = [&](auto change) { return errorsOf(facts, change); };
  EXPECT_THAT(message([&](auto& attempt) { attempt["facts"]["workstation"] = "ward 8"; }), HasSubstr("ward 8"));
  EXPECT_THAT(message([&](auto& attempt) { attempt["facts"]["person"] = school->ben.id; }),
              HasSubstr("has not signed in"));
  EXPECT_THAT(message([&](auto& attempt) { attempt["facts"]["begun_us"] = rig->now_us + 86'400 * kSecond_us; }),
              HasSubstr("in the future"));
  EXPECT_THAT(message([&](auto& attempt) { attempt["facts"]["points"] = 1000.0; }), HasSubstr("100"));
  EXPECT_THAT(message([&](auto& attempt) { attempt["facts"]["criticalErrors"] = 1ll << 40; }), HasSubstr("negative"));
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).attempts, 0);
  const std::string acts = message([&](auto& attempt) {
    attempt["voided_us"] = rig->now_us, attempt["voidedBy"] = school->otto.id;
    attempt["acceptedBy"] = school->anna.id;
    attempt["comments"] = {{freshUuid(), facts.id, 5, school->otto.id, rig->now_us, "good", nullptr, nullptr, nullptr}};
  });
  EXPECT_THAT(acts, HasSubstr("voided"));
  EXPECT_THAT(acts, HasSubstr("accepted"));
  EXPECT_THAT(acts, HasSubstr("A comment on the attempt"));
  EXPECT_EQ(onServer(facts).facts.state, AttemptState::Completed);
  EXPECT_EQ(onServer(facts).facts.testConditions, TestConditions::None) << "the level is no test";
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Verifying);
  EXPECT_EQ(masteredBy(school->anna), 0);
  EXPECT_THAT(valueOf(CommentStore(school->admin).listByAttempt(facts.id)), IsEmpty());
}

TEST_P(StoreSite, TheServerDecidesWhetherATestWasOpen) {
  const SignedIn anna = here(school->anna);
  const auto sittings = [&](const AttemptFacts& facts) {
    return std::pair(valueOf(AttemptStore(anna).attempt(facts.id)).facts.testConditions,
                     onServer(facts).facts.testConditions);
  };
  using enum TestConditions;
  const AttemptFacts closed = attemptOf(anna, 2000, "exam");
  valueOf(site().exchange());
  EXPECT_EQ(sittings(closed), std::pair(Practice, Practice));

  valueOf(OpeningStore(school->as(school->ina)).open({.cohort = school->spring.id, .level = "exam", .code = "blue"}));
  valueOf(site().exchange());
  rig->pass(kSecond_us);
  const OpeningStore openings(anna);
  EXPECT_EQ(valueOf(openings.admission("course", "exam")).kind, TestAdmission::Kind::NeedsCode);
  EXPECT_FALSE(openings.enterCode("course", "exam", "green"));
  valueOf(openings.enterCode("course", "exam", "blue"));
  const AttemptFacts open = attemptOf(anna, 2000, "exam");
  valueOf(site().exchange());
  EXPECT_EQ(sittings(open), std::pair(Opened, Opened));
  EXPECT_EQ(sittings(closed), std::pair(Practice, Practice)) << "decided once";
}

TEST_P(StoreSite, AnInstructorWhoSignedInHereCommentsAndRatesHereAndVoidsOnTheServer) {
  const SignedIn anna = here(school->anna), ina = here(school->ina);
  const AttemptFacts facts = attemptOf(anna);
  EXPECT_THAT(refusalOf(AttemptStore(ina).voidAttempt(facts.id, "device failed")), HasSubstr("in a browser"));
  EXPECT_THAT(refusalOf(AttemptStore(ina).accept(facts.id, "I watched it")), HasSubstr("in a browser"));
  valueOf(FormStore(ina).add({"", "global_rating", 1, school->anna.id, facts.id, "", 0, "{}"}));
  valueOf(CommentStore(ina).add(facts.id, 5, "good"));
  const UploadReport report = valueOf(site().exchange());
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_EQ(report.forms, 1);
  EXPECT_EQ(valueOf(CommentStore(school->admin).listByAttempt(facts.id)).size(), 1U);
}

TEST_P(StoreSite, WhatIsSaidHereAboutAnAttemptElsewhereReachesTheServer) {
  StoreRig other;
  other.services.workstation = "ward 8", other.services.now_us = ward.services.now_us;
  const CurriculumStore far = other.open();
  const std::string farToken = valueOf(Workstations(school->admin).add("ward 8"));
  const AttemptFacts facts = attemptOf(here(school->anna));
  valueOf(site().exchange());
  const std::string nearToken = std::exchange(token, farToken);
  const SiteUpload farSite(far, link());
  StoreChanges changes(far.guest());
  valueOf(changes.readChanges());
  valueOf(farSite.signIn("ina", kPassword));
  valueOf(farSite.exchange());
  EXPECT_TRUE(valueOf(changes.readChanges()).contains(school->anna.id)) << "pages here are to show the attempt";
  const SignedIn ina = valueOf(far.signIn("ina", kPassword));
  valueOf(CommentStore(ina).add(facts.id, 5, "good"));
  valueOf(FormStore(ina).add({"", "global_rating", 1, school->anna.id, facts.id, "", 0, "{}"}));
  const UploadReport report = valueOf(farSite.exchange());
  EXPECT_THAT(report.errors, IsEmpty());
  EXPECT_EQ(report.forms, 1);
  EXPECT_EQ(valueOf(farSite.pending()), 0);
  EXPECT_EQ(valueOf(CommentStore(school->admin).listByAttempt(facts.id)).size(), 1U);
  EXPECT_EQ(onServer(facts).facts.workstation, "ward 7");
  token = nearToken;
}

TEST_P(StoreSite, ARecordingThatIsWholeButWasNotTakenIsTakenLater) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  requests = 0, breaksAt = 7;  // before the first part
  valueOf(site().exchange());
  const auto recordings = school->store.recordings();
  std::filesystem::create_directories(recordings);
  std::filesystem::copy_file(near->recordings() / (facts.id + ".attempt"), recordings / (facts.id + ".attempt.part"),
                             std::filesystem::copy_options::overwrite_existing);
  breaksAt = 0;
  EXPECT_EQ(valueOf(site().exchange()).recordings, 1);
  EXPECT_TRUE(valueOf(VerificationQueue(school->store).takeNext()));
}

TEST_P(StoreSite, ATestStaysOpenForAWorkstationThatLostSightOfIt) {
  const SignedIn anna = here(school->anna);
  valueOf(OpeningStore(school->as(school->ina)).open({.cohort = school->spring.id, .level = "exam", .code = "blue"}));
  valueOf(site().exchange());
  rig->pass(kSecond_us);
  succeed(CohortStore(school->admin).leave(school->spring.id, school->anna.id));
  valueOf(site().exchange());
  succeed(CohortStore(school->admin).join(school->spring.id, school->anna.id, false));
  valueOf(site().exchange());
  EXPECT_EQ(valueOf(OpeningStore(anna).admission("course", "exam")).kind, TestAdmission::Kind::NeedsCode);
}

TEST_P(StoreSite, AWorkstationErasesThePeopleWhomTheServerErased) {
  const SignedIn anna = here(school->anna);
  const AttemptFacts facts = attemptOf(anna);
  valueOf(FormStore(anna).add({"", "questionnaire", 1, school->anna.id, "", "", 0, R"({"says": "I am Anna"})"}));
  valueOf(site().exchange());
  const auto recording = near->recordings() / (facts.id + ".attempt");
  const auto received = school->store.recordings() / (facts.id + ".attempt");
  ASSERT_TRUE(std::filesystem::exists(recording) && std::filesystem::exists(received));
  const AttemptFacts unsent = attemptOf(anna);
  succeed(PersonData(school->admin).erase(school->anna.id));
  EXPECT_FALSE(std::filesystem::exists(received));

  const UploadReport report = valueOf(site().exchange());
  EXPECT_THAT(report.errors, ::testing::Contains(HasSubstr("The server has erased a person.")));
  EXPECT_FALSE(AttemptStore(school->admin).attempt(unsent.id)) << "what comes later is not taken";
  EXPECT_FALSE(std::filesystem::exists(recording));
  EXPECT_FALSE(near->signIn("anna", kPassword));
  const auto rows = store::Connection::open(valueOf(store::Address::parse(ward.address)));
  const auto texts = [&](const char* sql) { return valueOf((*rows)->rows(sql, {})).at(0).text(0); };
  EXPECT_THAT(texts("SELECT full_name FROM people WHERE full_name LIKE 'Erased%'"),
              "Erased person " + school->anna.id.substr(0, 8));
  EXPECT_EQ(texts("SELECT answers FROM forms"), "{\"says\":\"(erased)\"}");
  EXPECT_EQ(texts("SELECT COUNT(*) FROM people WHERE name = 'anna' OR email LIKE 'anna%'"), "0");
  EXPECT_THAT(valueOf(site().exchange()).errors, IsEmpty()) << "the next exchange has nothing to erase";
}

TEST_P(StoreSite, AWorkstationDeletesTheRecordingsThatTheServerDeletedByItsRule) {
  const SignedIn anna = here(school->anna);
  const AttemptFacts facts = attemptOf(anna);
  valueOf(site().exchange());
  const auto recording = near->recordings() / (facts.id + ".attempt");
  succeed(Retention(school->admin).setRule({.recording_months = 1}));
  rig->pass(40 * kDay_us);
  valueOf(site().exchange());
  EXPECT_TRUE(std::filesystem::exists(recording)) << "the server has not applied its rule";
  valueOf(Retention(school->admin).deleteExpired());
  valueOf(site().exchange());
  EXPECT_FALSE(std::filesystem::exists(recording));
}

TEST_P(StoreSite, ANameThatWentToAnotherPersonArrives) {
  here(school->ina);
  const PeopleStore people(school->admin);
  Person ben = school->ben, anna = school->anna;
  succeed(CohortStore(school->admin).leave(school->spring.id, ben.id));
  ben.name = "benjamin";
  succeed(people.change(ben));
  anna.name = "ben";
  succeed(people.change(anna));
  valueOf(site().exchange());
  EXPECT_EQ(valueOf(site().signIn("ben", kPassword)), SiteUpload::Reached::Yes);
  EXPECT_EQ(valueOf(near->signIn("ben", kPassword)).person().id, school->anna.id);
}

TEST_P(StoreSite, WhatIsSentTwiceIsStoredOnce) {
  const AttemptFacts facts = attemptOf(here(school->anna));
  requests = 0, breaksAt = 4;  // after the facts arrived, before they are known to have arrived
  const SiteLink whole = link();
  const SiteUpload lossy(*near, {.place = whole.place, .send = [&](const std::string& path, const std::string& body) {
                                   auto answer = passOn(path, body);
                                   return path == "facts" ? Result<SiteAnswer>(fail("The connection broke.")) : answer;
                                 }});
  EXPECT_FALSE(lossy.exchange());
  EXPECT_EQ(valueOf(site().pending()), 1);
  breaksAt = 0;
  EXPECT_THAT(valueOf(site().exchange()).errors, IsEmpty());
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).attempts, 1);
  EXPECT_EQ(onServer(facts).facts.proof, AttemptProof::Verifying);
}

TEST_P(StoreSite, ARevokedTokenOpensNothing) {
  here(school->anna);
  const Workstations workstations(school->admin);
  EXPECT_THAT(refusalOf(workstations.add("ward 7")), HasSubstr("has a token already"));
  succeed(workstations.revoke("ward 7"));
  EXPECT_THAT(refusalOf(site().exchange()), HasSubstr("not valid"));
  EXPECT_TRUE(valueOf(workstations.list()).front().revoked_us);
  const std::string former = token;
  token = valueOf(workstations.add("ward 7"));
  EXPECT_NE(token, former);
  EXPECT_EQ(valueOf(site().exchange()).people, 0) << "its people sign in anew";
  for (const Person& person : {school->anna, school->ina})
    EXPECT_THAT(refusalOf(Workstations(school->as(person)).list()), HasSubstr("do not have the permission"));
}

TEST_P(StoreSite, ATokenIsOfOneStoreOfOneComputer) {
  valueOf(site().exchange());
  StoreRig other;
  EXPECT_THAT(refusalOf(SiteUpload(other.open(), link()).exchange()), HasSubstr("not the one that connected first"));
  StoreRig renamed;
  renamed.services.workstation = "ward 9";
  EXPECT_THAT(refusalOf(SiteUpload(renamed.open(), link()).exchange()), HasSubstr("name of this computer is 'ward 9'"));
}

TEST_P(StoreSite, UnreadableMessagesAreRefusedWithASentence) {
  here(school->anna);
  const std::vector<std::string> paths{"hello",
                                       "sign-in",
                                       "unknown-people",
                                       "people",
                                       "facts",
                                       "wanted",
                                       "unavailable",
                                       "recordings/x/0/1",
                                       "directory",
                                       "attempts-elsewhere",
                                       "",
                                       "recordings/" + freshUuid() + "/0/10"};
  const std::vector<std::string> bodies{"",
                                        "{",
                                        "[]",
                                        "{}",
                                        R"({"version":2})",
                                        R"({"version":3,"items":7})",
                                        R"({"version":3,"items":[{"number":"x"}],"logEnd":1,"logHash":""})",
                                        R"({"version":3,"people":[{"id":7}]})",
                                        R"({"version":3,"ids":{}})",
                                        R"({"version":3,"attempts":"x"})",
                                        R"({"version":3,"digests":{},"after":7})",
                                        R"({"version":3,"items":)" + std::string(2'000'000, '[') +
                                            std::string(2'000'000, ']') + ",\"logEnd\":1,\"logHash\":\"\"}",
                                        "\xff\xfe"};
  for (const std::string& path : paths)
    for (const std::string& body : bodies) {
      const SiteAnswer answer = valueOf(passOn(path, body));
      if (answer.isRefusal) {
        EXPECT_THAT(answer.text, ::testing::EndsWith(".")) << path << ' ' << body.substr(0, 100);
      }
    }
  EXPECT_EQ(valueOf(StoreUpkeep(school->admin).facts()).people, 6);
}

}  // namespace
}  // namespace insonate::test
