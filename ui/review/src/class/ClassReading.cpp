#include "ClassReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Standings.h>

#include <algorithm>

namespace insonate::review {
namespace {

/// The last attempts at a level all failed.
bool failsOn(const Level& level, const Curriculum& curriculum, std::span<const AttemptFacts> history) {
  int failed = 0;
  for (auto it = history.rbegin(); it != history.rend() && failed < kStuckAfter; ++it) {
    if (it->level != level.name || it->curriculum != curriculum.name || !counts(*it)) continue;
    if (judge(level.pass, *it).passed) return false;
    ++failed;
  }
  return failed == kStuckAfter;
}

}  // namespace

Result<Curriculum> curriculumOf(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty())
    return fail("The class '" + cohort.name + "' has no curriculum yet; choose one under People and classes (Alt+U).");
  const auto text = PublishedCurricula(by).text(cohort.curriculum, cohort.curriculumVersion);
  if (!text) return tl::unexpected(text.error());
  return parseCurriculum(*text);
}

Result<ClassFacts> readClass(const SignedIn& by, const Cohort& cohort) {
  ClassFacts facts;
  facts.cohort = cohort;
  auto members = CohortStore(by).members(cohort.id);
  if (!members) return tl::unexpected(members.error());
  std::ranges::copy_if(*members, std::back_inserter(facts.learners), [](const Member& one) { return !one.teaches; });
  const auto last = AttemptStore(by).lastOfCohort(cohort.id, kLastAttempts);
  if (!last) return tl::unexpected(last.error());
  facts.heat = heatMapOf(*last);
  auto curriculum = curriculumOf(by, cohort);
  curriculum ? void(facts.curriculum = std::move(*curriculum)) : void(facts.trouble = curriculum.error().message);
  return facts;
}

PersonStanding personStanding(const Curriculum& curriculum, std::span<const AttemptFacts> history,
                              std::span<const LevelProgress> progress, std::int64_t changes) {
  PersonStanding result{standingOf(curriculum, progress, changes), Concern::None, {}};
  result.sentence = result.standing.sentence;
  const auto lapsed = std::ranges::find(progress, LevelState::Lapsed, &LevelProgress::state);
  if (lapsed != progress.end()) {
    result.concern = Concern::Slipped;
    result.sentence = lapsed->why;
    return result;
  }
  for (const LevelProgress& one : progress) {
    const Level* level = curriculum.level(one.level);
    if (one.state != LevelState::Open || !level || !failsOn(*level, curriculum, history)) continue;
    result.concern = Concern::Stuck;
    result.sentence = one.why;
    break;
  }
  return result;
}

Result<PersonStanding> readStanding(const SignedIn& by, const Member& member, const Curriculum& curriculum,
                                    std::int64_t now_us) {
  const auto changes = AttemptStore(by).changes(member.person.id);
  if (!changes) return tl::unexpected(changes.error());
  const auto history = AttemptStore(by).history(member.person.id);
  if (!history) return tl::unexpected(history.error());
  PersonStanding result = personStanding(curriculum, *history, progressOf(curriculum, *history, now_us), *changes);
  if (member.standing != result.standing)
    if (const auto kept = CohortStore(by).rememberStanding(member.person.id, result.standing); !kept)
      return tl::unexpected(kept.error());
  return result;
}

}  // namespace insonate::review
