#include "ClassReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Unlocking.h>

#include <algorithm>
#include <functional>
#include <iterator>

namespace insonate::review {
namespace {

bool isAnyOpenOrWaiting(const ClassFacts& facts) {
  return std::ranges::any_of(facts.openings, [&](const TestOpening& one) {
    const OpeningState state = stateAt(one, facts.read_us);
    return state == OpeningState::Open || state == OpeningState::Waiting;
  });
}

}  // namespace

Result<std::map<std::string, int>> testReadiness(const SignedIn& by, const ClassFacts& facts) {
  constexpr int kAllAttempts = 1000;
  const auto attempts = AttemptStore(by).recentOfCohort(facts.cohort.id, kAllAttempts);
  if (!attempts) return tl::unexpected(attempts.error());
  std::map<std::string, std::vector<AttemptFacts>> histories;
  for (const AttemptFacts& one : *attempts) histories[one.person].push_back(one);
  std::map<std::string, int> ready;
  for (const Level& level : facts.curriculum->levels)
    if (level.assistance == Assistance::Test) ready[level.name] = 0;
  for (const Member& learner : facts.learners)
    for (const LevelProgress& one : computeProgress(*facts.curriculum, histories[learner.person.id], facts.read_us))
      if (const auto test = ready.find(one.level); test != ready.end() && one.state != LevelState::Locked)
        ++test->second;
  return ready;
}

Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty())
    return fail("The class '" + cohort.name +
                "' has no curriculum yet; choose a curriculum under People and classes (Alt+U).");
  const auto text = PublishedCurricula(by).text(cohort.curriculum, cohort.curriculumVersion);
  if (!text) return tl::unexpected(text.error());
  return parseCurriculum(*text);
}

Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort) {
  ClassFacts facts;
  facts.cohort = cohort;
  facts.read_us = by.now_us();
  auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  std::ranges::copy_if(*members, std::back_inserter(facts.learners), [](const Member& one) { return !one.teaches; });
  auto openings = OpeningStore(by).listByCohort(cohort.id);
  if (!openings) return tl::unexpected(openings.error());
  facts.openings = std::move(*openings);
  const auto last = AttemptStore(by).recentOfCohort(cohort.id, kLastAttempts);
  if (!last) return tl::unexpected(last.error());
  facts.heat = heatMapOf(*last);
  facts.implausible = implausibleOf(*last);
  std::ranges::copy_if(*last, std::back_inserter(facts.unproven), waitsForAcceptance);
  std::ranges::sort(facts.unproven, std::greater(), &AttemptFacts::begun_us);
  auto curriculum = curriculumOf(by, cohort);
  curriculum ? void(facts.curriculum = std::move(*curriculum)) : void(facts.error = curriculum.error().message);
  if (facts.curriculum && isAnyOpenOrWaiting(facts)) {
    auto ready = testReadiness(by, facts);
    if (!ready) return tl::unexpected(ready.error());
    facts.ready = std::move(*ready);
  }
  return facts;
}

}  // namespace insonate::review
