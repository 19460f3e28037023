#pragma once

#include "page/Charts.h"
#include "page/Page.h"

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/MetricMeaning.h>
#include <insonate/curriculum/Unlocking.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace insonate::web {

/// Facts about one person, which the pages of this person show.
struct PersonFacts {
  Person person{};
  std::optional<Cohort> cohort{};
  std::optional<Curriculum> curriculum{};
  std::vector<AttemptFacts> history{};
  std::vector<LevelProgress> progress{};
  std::string address{};  ///< address of the person's page
};

/// Reads the user's own facts, in the class that the query names ("class"), or in the first class.
Result<PersonFacts> readOwn(const Visit& visit);
/// Reads the facts of a member of a class. `person`: Person::id.
Result<PersonFacts> readMember(const Visit& visit, const Cohort& cohort, const std::string& person);

/// Name and mark of a state. Each state has a word and a mark of its own, so that color is not needed.
struct StateWords {
  const char *name, *mark;
};
StateWords stateWords(LevelState state);

/// Returns the values of one metric at a level, by attempt. `title`: title of the level.
AttemptChart learningCurve(const PersonFacts& facts, const std::string& level, const std::string& title,
                           const MetricMeaning& metric);
/// Returns the LC-CUSUM scores at a level; empty if the level does not use LC-CUSUM.
std::optional<AttemptChart> cusumCurve(const PersonFacts& facts, const std::string& level, const std::string& title);
/// Returns the title of an attempt's level.
std::string levelTitle(const PersonFacts& facts, const AttemptFacts& attempt);

/// Calls work(Cohort) for the class of a member's page, or returns a page that says why the user may not see it.
template <class Work>
Response withMember(const Visit& visit, const Parts& parts, const Work& work) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto cohort = std::ranges::find(*cohorts, parts[0], &Cohort::id);
  if (cohort == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  if (parts[1] != visit.by->person().id) {
    const auto members = CohortStore(*visit.by).members(cohort->id);
    if (!members) return refusal(visit, 403, members.error().message);
    const bool learns =
        std::ranges::any_of(*members, [&](const Member& one) { return one.person.id == parts[1] && !one.teaches; });
    if (!learns) return refusal(visit, 404, "The class has no such trainee.");
  }
  return work(*cohort);
}

}  // namespace insonate::web
