#include "person/PersonReading.h"

#include "person/PersonPage.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>

namespace insonate::web {
namespace {

Result<PersonFacts> readPerson(const SignedIn& by, const std::string& person, const std::optional<Cohort>& cohort) {
  PersonFacts facts;
  facts.cohort = cohort;
  auto who = PeopleStore(by).person(person);
  if (!who) return tl::unexpected(who.error());
  facts.person = std::move(*who);
  auto history = AttemptStore(by).history(person);
  if (!history) return tl::unexpected(history.error());
  facts.history = std::move(*history);
  if (!cohort) return facts;
  auto curriculum = curriculumOf(by, *cohort);
  if (!curriculum) return tl::unexpected(curriculum.error());
  facts.curriculum = std::move(*curriculum);
  if (facts.curriculum) facts.progress = computeProgress(*facts.curriculum, facts.history, by.now_us());
  return facts;
}

AttemptChart::Mark markOf(const PersonFacts& facts, const AttemptFacts& attempt) {
  const auto passed = facts.curriculum ? passedIn(*facts.curriculum, attempt) : std::nullopt;
  if (!passed) return AttemptChart::Mark::Other;
  return *passed ? AttemptChart::Mark::Passed : AttemptChart::Mark::Failed;
}

}  // namespace

Result<std::optional<Curriculum>> curriculumOf(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty()) return std::nullopt;
  const auto published = PublishedCurricula(by).text(cohort.curriculum, cohort.curriculumVersion);
  if (!published) return tl::unexpected(published.error());
  auto curriculum = parseCurriculum(*published);
  if (!curriculum) return tl::unexpected(curriculum.error());
  return std::move(*curriculum);
}

Result<PersonFacts> readOwn(const Visit& visit) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return tl::unexpected(cohorts.error());
  auto chosen = std::ranges::find(*cohorts, valueOf(visit.request.query, "class"), &Cohort::id);
  if (chosen == cohorts->end()) chosen = cohorts->begin();
  auto facts =
      readPerson(*visit.by, visit.by->person().id, chosen == cohorts->end() ? std::nullopt : std::optional(*chosen));
  if (facts) facts->address = "/me";
  return facts;
}

Result<PersonFacts> readMember(const Visit& visit, const Cohort& cohort, const std::string& person) {
  auto facts = readPerson(*visit.by, person, cohort);
  if (facts) facts->address = "/classes/" + encoded(cohort.id) + "/people/" + encoded(person);
  return facts;
}

StateWords stateWords(LevelState state) {
  switch (state) {
    case LevelState::Mastered:
      return {"mastered", "\u2713"};
    case LevelState::Open:
      return {"unlocked", "\u25B6"};
    case LevelState::Lapsed:
      return {"lapsed", "\u21BB"};
    case LevelState::Locked:
      break;
  }
  return {"locked", "\u25CB"};
}

AttemptChart learningCurve(const PersonFacts& facts, const std::string& level, const std::string& title,
                           const MetricMeaning& metric) {
  AttemptChart values;
  values.title = metric.title + " at " + title;
  values.unit = metric.unit;
  for (const AttemptFacts& attempt : facts.history) {
    if (attempt.level != level || !isInFigures(attempt)) continue;
    const Level* at = facts.curriculum ? levelOf(*facts.curriculum, attempt) : nullptr;
    // Another curriculum may have a level of the same name.
    if (!level.empty() && !at) continue;
    if (at && countsAsPractice(attempt, *at)) continue;
    const auto value = valueIn(attempt, metric);
    values.points.push_back(value ? std::optional(AttemptChart::Point{*value, markOf(facts, attempt)}) : std::nullopt);
  }
  return values;
}

std::optional<AttemptChart> cusumCurve(const PersonFacts& facts, const std::string& level, const std::string& title) {
  const auto progress = std::ranges::find(facts.progress, level, &LevelProgress::level);
  const Level* rule = facts.curriculum ? facts.curriculum->level(level) : nullptr;
  if (progress == facts.progress.end() || !rule || !rule->mastery.cusum) return std::nullopt;
  AttemptChart values;
  values.title = "LC-CUSUM at " + title;
  for (const double score : progress->cusum) values.points.emplace_back(AttemptChart::Point{score});
  values.limit = rule->mastery.cusum->limit;
  values.limitName = "limit " + numberOf(rule->mastery.cusum->limit);
  return values;
}

std::string levelTitle(const PersonFacts& facts, const AttemptFacts& attempt) {
  if (attempt.level.empty()) return "Free practice";
  const Level* level = facts.curriculum ? facts.curriculum->level(attempt.level) : nullptr;
  return level ? level->title : attempt.level;
}

}  // namespace insonate::web
