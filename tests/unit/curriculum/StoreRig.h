#pragma once

#include "AttemptMaker.h"
#include "PostgresServer.h"
#include "support/TestData.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/PeopleStore.h>

#include <gmock/gmock.h>

#include <QtCore/QUuid>
#include <optional>
#include <string>

namespace insonate::test {

constexpr std::int64_t kSecond_us = 1'000'000;
/// 22 November 2026.
constexpr std::int64_t kToday_us = 1'795'305'600 * kSecond_us;
inline const std::string kPassword = "correct horse battery";

/// The value, or a failed test that says why there is none.
template <class T>
T valueOf(const Result<T>& result) {
  if (!result) throw std::runtime_error(result.error().message);
  return *result;
}
inline void succeed(const Result<void>& result) {
  if (!result) throw std::runtime_error(result.error().message);
}
template <class T>
std::string refusalOf(const Result<T>& result) {
  return result ? "(it was allowed)" : result.error().message;
}

inline std::string freshUuid() {
  return QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString();
}

enum class Place { File, Server };

/// A store in a file or on a server, with clocks that the test sets.
class StoreRig {
 public:
  explicit StoreRig(Place place = Place::File) {
    address = place == Place::File ? (folder / "curriculum.db").string() : PostgresServer::shared()->freshDatabase();
    services.workstation = "ward 7";
    services.passwordCost = PasswordCost::Minimum;
    services.now_us = [this] { return now_us; };
    services.upTime_us = [this] { return up_us; };
    services.boot = "first boot";
  }

  CurriculumStore open() const { return valueOf(CurriculumStore::open(address, services)); }
  void pass(std::int64_t time_us) {
    now_us += time_us;
    up_us += time_us;
  }

  TemporaryFolder folder;
  std::string address;
  StoreServices services;
  std::int64_t now_us = kToday_us, up_us = 1000 * kSecond_us;
};

/// A store with an administrator, two cohorts of an instructor each, and trainees; all have kPassword.
struct School {
  explicit School(const CurriculumStore& in)
      : store(in),
        admin(valueOf(store.createFirstAdministrator({"admin", "Ada Min", "", Role::Administrator}, kPassword))) {
    const CohortStore cohorts(admin);
    spring = valueOf(cohorts.add("Spring"));
    autumn = valueOf(cohorts.add("Autumn"));
    ina = add("ina", Role::Instructor, spring.id);
    otto = add("otto", Role::Instructor, autumn.id);
    anna = add("anna", Role::Trainee, spring.id);
    ben = add("ben", Role::Trainee, spring.id);
    carl = add("carl", Role::Trainee, autumn.id);
  }

  /// With kPassword of their own.
  Person add(const std::string& name, Role role, const std::string& cohort) const {
    Person person =
        valueOf(PeopleStore(admin).add({name, "Dr " + name, name + "@example.org", role}, "first password", cohort));
    succeed(PeopleStore(valueOf(store.signIn(name, "first password"))).changeOwnPassword("first password", kPassword));
    return person;
  }
  SignedIn as(const Person& person) const { return valueOf(store.signIn(person.name, kPassword)); }

  CurriculumStore store;
  SignedIn admin;
  Cohort spring, autumn;
  Person ina, otto;        ///< teach spring, autumn
  Person anna, ben, carl;  ///< learn in spring, spring, autumn
};

inline AttemptFacts begunFacts() {
  return {.id = freshUuid(),
          .curriculum = "central_line",
          .curriculumVersion = 2,
          .level = "first",
          .procedure = "internal_jugular",
          .procedureVersion = 1,
          .caseName = "neck",
          .caseHash = "0123456789abcdef",
          .begun_us = kToday_us};
}

inline AttemptFacts endedFacts(AttemptFacts facts) {
  facts.length_us = 62'000'001;
  facts.state = AttemptState::Completed;
  facts.succeeded = true;
  facts.criticalErrors = 1;
  facts.points = 81.2500000000001;
  facts.metrics = {{"vein_punctures", 1, 1.0}, {"time_to_vein_s", 2, 0.1 + 0.2}, {"near_miss_mm", 1, std::nullopt}};
  facts.recording = "2026-11-22.rec";
  facts.recordingHash = std::string(64, 'a');
  facts.proof = AttemptProof::Proven;
  return facts;
}

/// The text of a curriculum named central_line.
inline std::string curriculumOf(int version, const std::string& title = "Central line") {
  Curriculum curriculum = valueOf(loadCurriculum("central_line"));
  curriculum.version = version;
  curriculum.title = title;
  return curriculumText(curriculum);
}

/// Begun and ended.
inline AttemptFacts keepAttempt(const SignedIn& by, AttemptFacts facts = begunFacts()) {
  facts = endedFacts(std::move(facts));
  valueOf(AttemptStore(by).begin(facts));
  succeed(AttemptStore(by).end(facts));
  return facts;
}

/// Runs each test on both kinds of store; that of a server is skipped where there is none.
class OnBoth : public ::testing::TestWithParam<Place> {
 protected:
  void SetUp() override {
    if (GetParam() == Place::Server && !PostgresServer::shared()) GTEST_SKIP() << "PostgreSQL 15 is not installed";
    rig.emplace(GetParam());
  }
  std::optional<StoreRig> rig;
};

inline std::string placeName(const ::testing::TestParamInfo<Place>& info) {
  return info.param == Place::File ? "Sqlite" : "PostgreSql";
}

#define INSONATE_ON_BOTH(suite) \
  INSTANTIATE_TEST_SUITE_P(Places, suite, ::testing::Values(Place::File, Place::Server), placeName)

}  // namespace insonate::test
