#include "person/PersonPage.h"

#include "forms/FormPages.h"
#include "levels/BriefingPage.h"
#include "live/LiveUpdates.h"
#include "page/Charts.h"
#include "people/PersonDownload.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>
#include <cmath>

namespace insonate::web {
namespace {

constexpr int kAttemptsShown = 100;

struct PersonFacts {
  Person person{};
  std::optional<Cohort> cohort{};
  std::optional<Curriculum> curriculum{};
  std::vector<AttemptFacts> history{};
  std::vector<LevelProgress> progress{};
  std::string address{};  ///< address of this page
};

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

struct StateWords {
  const char *name, *mark;
};

/// Each state has a word and a mark of its own, so that color is not needed.
StateWords stateWords(LevelState state) {
  switch (state) {
    case LevelState::Mastered:
      return {"mastered", "\u2713"};
    case LevelState::Open:
      return {"open", "\u25B6"};
    case LevelState::Lapsed:
      return {"lapsed", "\u21BB"};
    case LevelState::Locked:
      break;
  }
  return {"locked", "\u25CB"};
}

Markup levelsOf(const PersonFacts& facts) {
  if (!facts.curriculum)
    return section(
        "Levels",
        paragraph(facts.cohort ? "This class has no curriculum yet. An instructor of the class chooses a curriculum."
                               : "No class yet. An instructor adds trainees to a class."));
  Markup items;
  for (std::size_t i = 0; i < facts.progress.size(); ++i) {
    const Level& level = facts.curriculum->levels[i];
    const LevelProgress& now = facts.progress[i];
    const auto [state, mark] = stateWords(now.state);
    const int least = fewestAttempts(level.mastery);
    const std::string takes =
        "Mastery takes at least " + std::to_string(least) + (least == 1 ? " attempt." : " attempts.");
    const std::string test = level.assistance == Assistance::Test
                                 ? " This is a test: an attempt counts if an instructor has opened the test."
                                 : "";
    items += element("li", {{"class", std::string("level ") + state}},
                     element("span", {{"class", "state"}}, std::string(mark) + " " + state) +
                         element("h3", {}, link(briefingAddress(facts.cohort->id, level.name), level.title)) +
                         paragraph(now.why) + element("p", {{"class", "quiet"}}, level.about + " " + takes + test));
  }
  return section("Levels", element("ol", {{"class", "levels"}}, items));
}

AttemptChart::Mark markOf(const PersonFacts& facts, const AttemptFacts& attempt) {
  const auto passed = facts.curriculum ? passedIn(*facts.curriculum, attempt) : std::nullopt;
  if (!passed) return AttemptChart::Mark::Other;
  return *passed ? AttemptChart::Mark::Passed : AttemptChart::Mark::Failed;
}

AttemptChart learningCurve(const PersonFacts& facts, const std::string& level, const std::string& title,
                           const MetricMeaning& metric) {
  AttemptChart values;
  values.title = metric.title + " at " + title;
  values.unit = metric.unit;
  for (const AttemptFacts& attempt : facts.history) {
    if (attempt.level != level || !isCounted(attempt)) continue;
    const Level* at = facts.curriculum ? levelOf(*facts.curriculum, attempt) : nullptr;
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

Markup curvesOf(const Visit& visit, const PersonFacts& facts) {
  std::vector<std::pair<std::string, std::string>> levels;
  if (facts.curriculum)
    for (const Level& level : facts.curriculum->levels) levels.emplace_back(level.name, level.title);
  levels.emplace_back("", "Free practice");
  const auto last = std::ranges::find_if(facts.history.rbegin(), facts.history.rend(),
                                         [](const auto& one) { return isCounted(one); });
  std::string level = last == facts.history.rend() ? levels.front().first : last->level;
  if (const auto asked = visit.request.query.find("level"); asked != visit.request.query.end()) level = asked->second;
  auto chosen = std::ranges::find(levels, level, &std::pair<std::string, std::string>::first);
  if (chosen == levels.end()) chosen = levels.begin();
  const auto& all = MetricCatalog::instance().all();
  auto metric = std::ranges::find(all, valueOf(visit.request.query, "metric"), &MetricMeaning::id);
  if (metric == all.end()) metric = all.begin();
  std::vector<std::pair<std::string, std::string>> metrics;
  for (const MetricMeaning& one : all) metrics.emplace_back(one.id, one.title);
  Markup fields;
  if (facts.cohort && facts.address == "/me")
    fields += element("input", {{"type", "hidden"}, {"name", "class"}, {"value", facts.cohort->id}});
  fields += choiceField("Level", "level", levels, chosen->first) +
            choiceField("Metric", "metric", metrics, metric->id) + element("button", {{"type", "submit"}}, "Show");
  Markup content = element("form", {{"method", "get"}, {"action", facts.address}, {"class", "line"}}, fields) +
                   chart(learningCurve(facts, chosen->first, chosen->second, *metric));
  if (const auto cusum = cusumCurve(facts, chosen->first, chosen->second))
    content += chart(*cusum) + note(
                                   "LC-CUSUM is a score that rises with each pass and falls with each failure. Once "
                                   "the score has reached the limit, the attempts show that the skill was learned.");
  return section("Learning curve", content);
}

std::string levelTitle(const PersonFacts& facts, const AttemptFacts& attempt) {
  if (attempt.level.empty()) return "Free practice";
  const Level* level = facts.curriculum ? facts.curriculum->level(attempt.level) : nullptr;
  return level ? level->title : attempt.level;
}

Markup attemptsOf(const PersonFacts& facts) {
  std::vector<std::vector<Markup>> rows;
  for (auto one = facts.history.rbegin(); one != facts.history.rend() && rows.size() < kAttemptsShown; ++one) {
    std::string address = "/attempts/" + encoded(one->id);
    if (facts.cohort) address += "?class=" + encoded(facts.cohort->id);
    rows.push_back({element("a", {{"href", address}}, timeOf(one->begun_us)), text(levelTitle(facts, *one)),
                    text(outcomeWords(*one, facts.curriculum ? &*facts.curriculum : nullptr)),
                    text(one->points ? numberOf(*one->points) : ""),
                    text(numberOf(std::round(double(one->length_us) / 1e5) / 10))});
  }
  if (rows.empty()) return section("Attempts", paragraph("No attempts yet."));
  Markup content = table("Attempts, newest first", {"Begun", "Level", "Outcome", "Points", "Duration, s"}, rows);
  if (facts.history.size() > rows.size())
    content += paragraph("The newest " + std::to_string(rows.size()) + " of " + std::to_string(facts.history.size()) +
                         " attempts are shown.");
  return section("Attempts", content);
}

Response personPage(const Visit& visit, const Result<PersonFacts>& facts, const std::string& title,
                    std::int64_t since) {
  if (!facts) return refusal(visit, 403, facts.error().message);
  Markup content;
  if (facts->cohort) content += element("p", {{"class", "quiet"}}, "Class: " + facts->cohort->name);
  content += levelsOf(*facts) + curvesOf(visit, *facts) + attemptsOf(*facts);
  if (facts->person.id == visit.by->person().id) {
    const auto questionnaires = questionnaireSection(visit);
    if (!questionnaires) return refusal(visit, 403, questionnaires.error().message);
    content += *questionnaires + downloadSection(visit, facts->person.id);
  }
  return livePage(visit, title, content, facts->address + "/events", since);
}

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

}  // namespace

Result<std::optional<Curriculum>> curriculumOf(const SignedIn& by, const Cohort& cohort) {
  if (cohort.curriculum.empty()) return std::nullopt;
  const auto published = PublishedCurricula(by).text(cohort.curriculum, cohort.curriculumVersion);
  if (!published) return tl::unexpected(published.error());
  auto curriculum = parseCurriculum(*published);
  if (!curriculum) return tl::unexpected(curriculum.error());
  return std::move(*curriculum);
}

Response showOwnTraining(const Visit& visit, const Parts& /*parts*/) {
  const std::int64_t since = visit.live.numberOfLastChange();
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  auto chosen = std::ranges::find(*cohorts, valueOf(visit.request.query, "class"), &Cohort::id);
  if (chosen == cohorts->end()) chosen = cohorts->begin();
  auto facts =
      readPerson(*visit.by, visit.by->person().id, chosen == cohorts->end() ? std::nullopt : std::optional(*chosen));
  if (facts) facts->address = "/me";
  return personPage(visit, facts, "My training", since);
}

Response showMember(const Visit& visit, const Parts& parts) {
  const std::int64_t since = visit.live.numberOfLastChange();
  return withMember(visit, parts, [&](const Cohort& cohort) {
    auto facts = readPerson(*visit.by, parts[1], cohort);
    if (facts) facts->address = "/classes/" + encoded(parts[0]) + "/people/" + encoded(parts[1]);
    return personPage(visit, facts, facts ? displayName(facts->person) : "", since);
  });
}

Response followOwnTraining(const Visit& visit, const Parts& /*parts*/) {
  return follow(visit, {visit.by->person().id});
}

Response followMember(const Visit& visit, const Parts& parts) {
  return withMember(visit, parts, [&](const Cohort& /*cohort*/) { return follow(visit, {parts[1]}); });
}

}  // namespace insonate::web
