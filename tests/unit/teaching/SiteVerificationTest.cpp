#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/cases/CaseVersions.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/SiteService.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/Workstations.h>
#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/teaching/AttemptFactsOf.h>
#include <insonate/teaching/SiteVerification.h>

#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <stdexcept>
#include <thread>

namespace insonate {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <class T>
T received(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// A server, a workstation with a token, and a person who trains there.
class SiteVerificationTest : public testing::Test {
 protected:
  void SetUp() override {
    admin = received(server.createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, kPassword));
    token = received(Workstations(*admin).add("ward 7"));
    if (const auto known = site().signIn("admin", kPassword); !known) throw std::runtime_error(known.error().message);
    trainee = received(here.signIn("admin", kPassword));
  }
  CurriculumStore open(const std::filesystem::path& database, const std::string& workstation) const {
    StoreServices services;
    services.now_us = [this] { return now_us; };
    services.passwordCost = PasswordCost::Minimum, services.workstation = workstation;
    return received(CurriculumStore::open(database.string(), services));
  }
  SiteUpload site() const {
    const auto ask = [this](const std::string& path, const std::string& body) -> Result<SiteAnswer> {
      const SiteService service(server);
      const auto workstation = received(service.workstationOf(token));
      if (!workstation) return SiteAnswer{true, "The token is not valid."};
      const auto answer = service.answer(*workstation, path, body);
      return answer ? SiteAnswer{false, *answer} : SiteAnswer{true, answer.error().message};
    };
    return {here, SiteLink{.place = "https://site.example.org", .send = ask}};
  }
  /// Facts of an attempt that begins now, with its seal.
  AttemptFacts begin() const {
    AttemptFacts facts;
    facts.id = kIds[begun++], facts.person = trainee->person().id;
    facts.curriculum = "course", facts.curriculumVersion = 1, facts.level = "first";
    return facts;
  }
  /// Publishes the course of begin(), whose level has this case, before the attempts are made.
  void publishCourse(const std::string& levelsCase) {
    constexpr std::int64_t kYear_us = std::int64_t{365} * 86400 * 1'000'000;
    now_us -= kYear_us;
    Curriculum course = received(loadCurriculum("central_line"));
    course.name = "course", course.version = 1;
    course.levels.resize(1);
    course.levels[0].name = "first", course.levels[0].caseName = levelsCase;
    received(PublishedCurricula(*admin).publish(course.name, course.version, curriculumText(course)));
    now_us += kYear_us;
  }
  /// Publishes two versions of the level's case. Returns the hash of the first one's voxels.
  std::string publishTwoVersions() {
    publishCourse(caseName = "Broad neck");
    PatientCase neck = test::smallCase();
    neck.manifest.title = caseName;
    cases = folder / "cases";
    const std::filesystem::path home = cases / "broad";
    std::filesystem::create_directories(cases);
    const std::string first = received(saveCaseVersion(neck, home, "2026-11-22", "")).voxels;
    received(publishCase(neck, home, "2026-11-22"));
    neck.labels.voxels[0] ^= 1;
    received(saveCaseVersion(neck, home, "2026-11-23", ""));
    received(publishCase(neck, home, "2026-11-23"));
    return first;
  }
  RecordedFor recordedFor(const AttemptFacts& facts, const std::string& nonce) const {
    return {facts.id, facts.person, facts.curriculum, facts.curriculumVersion, facts.level, nonce};
  }
  void record(const RecordedFor& of, const std::optional<RecordKey>& key, double depth_mm = 25,
              bool isScripted = false) {
    AttemptHeader header;
    header.software = "insonate 0.1.0", header.begun = "2026-01-02T03:04:05Z";
    header.procedure = procedure, header.procedureVersion = loadProcedure("internal_jugular")->version;
    header.caseName = caseName, header.caseHash = caseHash, header.picture = test::ScriptedAttempt::picture();
    header.recordedFor = of, header.isScripted = isScripted;
    test::ScriptedAttempt attempt;
    attempt.aspirating = true;
    attempt.needleTo(depth_mm), attempt.hold(2);
    std::filesystem::remove(file);
    const auto recorder = received(AttemptRecorder::start(file, header, nullptr, key));
    for (const auto& entry : attempt.stream) {
      while (recorder->freeSlots() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::visit([&](const auto& what) { recorder->record(what); }, entry);
    }
    (void)received(recorder->finish(AttemptStatus::Completed));
  }
  /// Records an attempt as the window does.
  AttemptFacts recorded(double depth_mm = 25, bool isScripted = false) {
    AttemptFacts facts = begin();
    const AttemptSeal seal = received(AttemptStore(*trainee).issueSeal(facts));
    record(recordedFor(facts, seal.nonce), seal.key, depth_mm, isScripted);
    return facts;
  }
  /// Sends the attempt with the facts of its recording, changed as a hostile program could, and verifies it.
  AttemptProof proofAfter(const AttemptFacts& facts, const std::function<void(AttemptFacts&)>& change = {}) {
    AttemptFacts measured = received(factsOfRecording(file, Hands::PersonOrScript));
    measured.id = facts.id, measured.person = facts.person, measured.proof = AttemptProof::Proven;
    measured.curriculum = facts.curriculum, measured.curriculumVersion = facts.curriculumVersion;
    measured.level = facts.level;
    if (change) change(measured);
    return proofOf(measured);
  }
  AttemptProof proofOf(const AttemptFacts& measured) {
    received(AttemptStore(*trainee).add(measured, file));
    const UploadReport report = received(site().exchange());
    EXPECT_THAT(report.errors, testing::IsEmpty());
    const VerificationQueue queue(server);
    const auto waiting = received(queue.takeNext());
    if (!waiting) throw std::runtime_error("nothing waits");
    why = received(whyNotVerified(queue, *waiting, cases, events));
    if (auto done = queue.storeResult(waiting->facts.id, why.empty(), why); !done)
      throw std::runtime_error(done.error().message);
    return received(AttemptStore(*admin).attempt(measured.id)).facts.proof;
  }

  static constexpr const char* kPassword = "a long password";
  static constexpr const char* kIds[] = {"1c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa",
                                         "2c2f8f6e-6a5e-4b52-9c3e-6a1c55d1e0aa"};
  std::int64_t now_us = 1'795'305'600'000'000;  ///< 22 November 2026
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "first.attempt";
  const CurriculumStore server = open(folder / "server.db", "server"), here = open(folder / "ward.db", "ward 7");
  std::optional<SignedIn> admin, trainee;
  std::string token, why, procedure = "internal_jugular", caseName = "neck", caseHash = "c0ffee";
  std::filesystem::path cases;  ///< folder of the server's cases
  CompareEvents events;
  mutable int begun = 0;
};

TEST_F(SiteVerificationTest, EventsThatContradictTheMotionAreRefused) {
  events = [](const AttemptRecording&, const Progress&) {
    return std::vector<EventDifference>{{12'300'000, "needle event at 12.3 s", "none", "entered: artery"}};
  };
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Unproven);
  EXPECT_EQ(why, "The recording gives another needle event at 12.3 s: entered: artery instead of none.");
}

TEST_F(SiteVerificationTest, OnACaseThatTheServerLacksTheRecordedEventsCount) {
  events = [](const AttemptRecording&, const Progress&) -> Result<std::vector<EventDifference>> {
    return fail("The case is not here.");
  };
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Proven) << why;
}

TEST_F(SiteVerificationTest, WhatAPersonDidAtTheWorkstationIsProven) {
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Proven) << why;
  EXPECT_FALSE(received(verifyNextAttempt(VerificationQueue(server))));
}

TEST_F(SiteVerificationTest, APassOnAnotherCaseThanTheLevelsIsRefused) {
  publishCourse("textbook");
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Unproven);
  EXPECT_THAT(why, AllOf(HasSubstr("the case 'neck'"), HasSubstr("'Textbook neck'")));
}

TEST_F(SiteVerificationTest, ALevelsBuiltInCaseIsKnownByItsTitle) {
  publishCourse("textbook");
  caseName = "Textbook neck";
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Proven) << why;
}

TEST_F(SiteVerificationTest, AVersionThatTheServerHasNotPublishedDoesNotCount) {
  publishTwoVersions();
  PatientCase draft = received(readCase(cases / "broad")).patient;
  draft.labels.voxels[1] ^= 1;
  caseHash = received(saveCaseVersion(draft, cases / "broad", "2026-11-24", "")).voxels;
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("has not published"));
}

TEST_F(SiteVerificationTest, AnEarlierPublishedVersionCounts) {
  caseHash = publishTwoVersions();
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Proven) << "the second version may have arrived later: " << why;
}

TEST_F(SiteVerificationTest, ACaseThatTheServerDoesNotHaveIsKnownByItsTitle) {
  publishCourse(caseName = "Broad neck");
  cases = folder / "cases";
  std::filesystem::create_directories(cases);
  EXPECT_EQ(proofAfter(recorded()), AttemptProof::Proven) << why;
}

TEST_F(SiteVerificationTest, WithoutItsFolderOfCasesTheServerWaits) {
  publishCourse(caseName = "Broad neck");
  const AttemptFacts facts = recorded();
  AttemptFacts measured = received(factsOfRecording(file, Hands::PersonOrScript));
  measured.id = facts.id, measured.person = facts.person, measured.proof = AttemptProof::Proven;
  measured.curriculum = facts.curriculum, measured.curriculumVersion = facts.curriculumVersion;
  measured.level = facts.level;
  received(AttemptStore(*trainee).add(measured, file));
  received(site().exchange());
  const VerificationQueue queue(server);
  EXPECT_FALSE(verifyNextAttempt(queue, folder / "not mounted"));
  EXPECT_EQ(received(queue.waiting()), 1);
}

TEST_F(SiteVerificationTest, AnotherServerVerifiesWhatAKilledServerHasTaken) {
  const AttemptFacts facts = recorded();
  AttemptFacts measured = received(factsOfRecording(file, Hands::PersonOrScript));
  measured.id = facts.id, measured.person = facts.person, measured.proof = AttemptProof::Proven;
  measured.curriculum = facts.curriculum, measured.curriculumVersion = facts.curriculumVersion;
  measured.level = facts.level;
  received(AttemptStore(*trainee).add(measured, file));
  (void)received(site().exchange());
  const VerificationQueue queue(server);
  ASSERT_TRUE(received(queue.takeNext()));
  now_us += 119'000'000;
  EXPECT_FALSE(received(verifyNextAttempt(queue))) << "the first server may still be busy";
  now_us += 2'000'000;
  EXPECT_TRUE(received(verifyNextAttempt(queue)));
  EXPECT_EQ(received(AttemptStore(*admin).attempt(facts.id)).facts.proof, AttemptProof::Proven);
  EXPECT_EQ(received(queue.waiting()), 0);
}

TEST_F(SiteVerificationTest, BetterFactsThanThoseOfTheRecordingAreNot) {
  EXPECT_EQ(proofAfter(recorded(), [](AttemptFacts& facts) { facts.points = 12.5; }), AttemptProof::Unproven);
  EXPECT_THAT(why, AllOf(HasSubstr("points"), HasSubstr("instead of 12.5")));
}

TEST_F(SiteVerificationTest, AMetricThatTheRecordingDoesNotGiveIsNot) {
  EXPECT_EQ(proofAfter(recorded(), [](AttemptFacts& facts) { facts.metrics.pop_back(); }), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("another version of Insonate"));
}

TEST_F(SiteVerificationTest, AnAttemptThatHidesTheHashOfItsMotionIsNot) {
  EXPECT_EQ(proofAfter(recorded(), [](AttemptFacts& facts) { facts.handsHash.clear(); }), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("hands' motion"));
}

TEST_F(SiteVerificationTest, ARecordingThatNamesAFileAsItsProcedureIsNot) {
  AttemptFacts facts = begin();
  const AttemptSeal seal = received(AttemptStore(*trainee).issueSeal(facts));
  record(recordedFor(facts, seal.nonce), seal.key);
  AttemptFacts measured = received(factsOfRecording(file, Hands::PersonOrScript));
  measured.proof = AttemptProof::Proven;
  const std::filesystem::path rules = folder / "rules.json";
  std::filesystem::copy_file(INSONATE_SOURCE_DIR "/resources/procedures/internal_jugular.json", rules);
  measured.procedure = procedure = std::filesystem::relative(rules).string();
  record(recordedFor(facts, seal.nonce), seal.key);
  ASSERT_TRUE(addRecording(measured, file));
  EXPECT_EQ(proofOf(measured), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("'" + procedure + "' is not a built-in procedure"));
}

TEST_F(SiteVerificationTest, ARecordingThatCannotBeReadIsWaitedFor) {
  AttemptFacts facts = recorded();
  const WaitingAttempt waiting{facts, folder / "nowhere.attempt"};
  EXPECT_FALSE(whyNotVerified(VerificationQueue(server), waiting));
}

TEST_F(SiteVerificationTest, TheRecordingOfAnotherAttemptIsNot) {
  recorded();
  EXPECT_EQ(proofAfter(begin()), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("another attempt or level"));
}

TEST_F(SiteVerificationTest, AnotherLevelThanThatOfTheRecordingIsNot) {
  AttemptFacts facts = recorded();
  facts.level = "last";
  EXPECT_EQ(proofAfter(facts), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("another attempt or level"));
}

TEST_F(SiteVerificationTest, ARecordingWithoutTheKeyOfTheStoreIsNot) {
  const AttemptFacts facts = begin();
  const AttemptSeal seal = received(AttemptStore(*trainee).issueSeal(facts));
  record(recordedFor(facts, seal.nonce), std::nullopt);
  EXPECT_EQ(proofAfter(facts), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("codes"));
  record(recordedFor(facts, ""), std::nullopt);
  EXPECT_THROW((void)proofAfter(facts), std::runtime_error) << "the attempt has ended";
}

TEST_F(SiteVerificationTest, TheMotionOfAScriptIsNot) {
  EXPECT_EQ(proofAfter(recorded(25, true)), AttemptProof::Unproven);
  EXPECT_THAT(why, HasSubstr("script"));
}

TEST_F(SiteVerificationTest, AFailureIsVerifiedLikeAPass) {
  EXPECT_EQ(proofAfter(recorded(3)), AttemptProof::Proven) << why;
}

}  // namespace
}  // namespace insonate
