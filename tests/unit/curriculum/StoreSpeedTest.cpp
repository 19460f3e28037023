#include "StoreRig.h"
#include "store/AttemptRows.h"
#include "store/Core.h"

#include <insonate/curriculum/AuditLog.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/SiteUpload.h>
#include <insonate/curriculum/StoreUpkeep.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>

namespace insonate::test {
namespace {

constexpr int kTrainees = 200, kAttempts = 500, kMetrics = 26;

AttemptFacts manyMetrics(AttemptFacts facts, int seed) {
  facts = endedFacts(std::move(facts));
  facts.metrics.clear();
  for (int i = 0; i < kMetrics; ++i)
    facts.metrics.push_back({"metric_number_" + std::to_string(i), 1, (seed * 31 + i) / 7.0});
  return facts;
}

/// Past the public classes: 100 000 attempts that are begun and ended one by one take half an hour of the disk's time.
void fill(const StoreRig& rig, const std::vector<Person>& people) {
  const auto core = valueOf(store::Core::open(rig.address, rig.services));
  succeed(inTransaction(*core, store::Way::Write, [&](store::Transaction& transaction) -> Result<void> {
    for (int i = 0; i < kAttempts * kTrainees; ++i) {
      AttemptFacts facts = begunFacts();
      facts.person = people[static_cast<std::size_t>(i % kTrainees)].id;
      facts.workstation = "ward 7";
      store::insertAttempt(transaction, facts, "");
      store::endAttempt(transaction, manyMetrics(facts, i), false);
    }
    return {};
  }));
}

/// Maintenance that a server does by itself within minutes.
void lookAfter(const StoreRig& rig) {
  const auto connection = store::Connection::open(valueOf(store::Address::parse(rig.address)));
  if (connection && (*connection)->dialect().name == "postgresql") succeed((*connection)->script("VACUUM ANALYZE"));
}

/// Median of several, in ms. Printed and kept in the test's report; times depend on the computer and are not judged.
void measure(const std::string& what, const std::function<std::size_t()>& screen) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times_ms;
  std::size_t rows = 0;
  for (int i = 0; i < 7; ++i) {
    const auto begin = Clock::now();
    rows = screen();
    times_ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
  }
  std::nth_element(times_ms.begin(), times_ms.begin() + 3, times_ms.end());
  std::printf("%-28s %7zu rows %8.1f ms\n", what.c_str(), rows, times_ms[3]);
  ::testing::Test::RecordProperty(what, std::to_string(times_ms[3]));
}

class StoreSpeed : public OnBoth {};
INSONATE_ON_BOTH(StoreSpeed);

TEST_P(StoreSpeed, ScreensOfAClassOf200With100000Attempts) {
  const School school(rig->open());
  std::vector<Person> people;
  for (int i = 0; i < kTrainees; ++i)
    people.push_back(valueOf(
        PeopleStore(school.admin).add({"trainee" + std::to_string(i), "A Trainee"}, kPassword, school.spring.id)));
  fill(*rig, people);
  lookAfter(*rig);
  const SignedIn ina = school.as(school.ina);
  const std::string someone = people[100].id;
  ASSERT_EQ(valueOf(CohortStore(ina).members(school.spring.id)).at(1).attempts, kAttempts);
  ASSERT_EQ(valueOf(AttemptStore(ina).recentOfCohort(school.spring.id, 5)).size(), 5U * kTrainees);

  std::int64_t page = 0;
  measure("members of the cohort", [&] { return valueOf(CohortStore(ina).members(school.spring.id)).size(); });
  measure("heat map, last 5 of each",
          [&] { return valueOf(AttemptStore(ina).recentOfCohort(school.spring.id, 5)).size(); });
  measure("history of one", [&] { return valueOf(AttemptStore(ina).history(someone)).size(); });
  measure("newest 50 of one", [&] {
    const auto kept = valueOf(AttemptStore(ina).page(someone, 50));
    page = kept.back().arrival;
    return kept.size();
  });
  measure("next 50 of one", [&] { return valueOf(AttemptStore(ina).page(someone, 50, page)).size(); });
  measure("forms of the cohort",
          [&] { return valueOf(FormStore(ina).listByCohort(school.spring.id, "feedback")).size(); });
  measure("50 of the audit log", [&] { return valueOf(AuditLog(school.admin).page(50)).size(); });
  measure("50 about one", [&] { return valueOf(AuditLog(school.admin).page(50, 0, someone)).size(); });
  measure("pending uploads", [&] { return valueOf(pendingUploads(ina, 100)).size(); });
  measure("signing in", [&] { return std::size_t{!school.as(school.anna).isGuest()}; });
  measure("opening the store", [&] { return std::size_t{valueOf(rig->open().hasPeople())}; });
  measure("an attempt begun and ended", [&] { return keepAttempt(school.as(school.anna)).metrics.size(); });
}

}  // namespace
}  // namespace insonate::test
