#include "person/PersonPage.h"

#include "forms/FormPages.h"
#include "levels/BriefingPage.h"
#include "live/LiveUpdates.h"
#include "people/PersonDownload.h"
#include "person/AttemptList.h"
#include "person/PersonReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/PeopleStore.h>
#include <insonate/curriculum/PublishedCurricula.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>

namespace insonate::web {
namespace {

Markup levelsOf(const PersonFacts& facts) {
  if (!facts.curriculum)
    return section(
        "Levels",
        paragraph(facts.cohort ? "This class has no curriculum yet. An instructor of the class chooses a curriculum."
                               : "This trainee is in no class yet. An instructor adds trainees to a class."));
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

/// The metric that the user chose for the charts.
const MetricMeaning& metricOf(const Visit& visit) {
  const auto& all = MetricCatalog::instance().all();
  const auto metric = std::ranges::find(all, valueOf(visit.request.query, "metric"), &MetricMeaning::id);
  return metric == all.end() ? all.front() : *metric;
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
  const MetricMeaning& metric = metricOf(visit);
  std::vector<std::pair<std::string, std::string>> metrics;
  for (const MetricMeaning& one : MetricCatalog::instance().all()) metrics.emplace_back(one.id, one.title);
  Markup fields;
  if (facts.cohort && facts.address == "/me")
    fields += element("input", {{"type", "hidden"}, {"name", "class"}, {"value", facts.cohort->id}});
  fields += attemptFields(visit) + choiceField("Level", "level", levels, chosen->first) +
            choiceField("Metric", "metric", metrics, metric.id) + element("button", {{"type", "submit"}}, "Show");
  Markup content = element("form", {{"method", "get"}, {"action", facts.address}, {"class", "line"}}, fields) +
                   chart(learningCurve(facts, chosen->first, chosen->second, metric));
  if (const auto cusum = cusumCurve(facts, chosen->first, chosen->second))
    content += chart(*cusum) + note(
                                   "LC-CUSUM is a score that rises with each pass and falls with each failure. A score "
                                   "at the limit shows that the skill is learned.");
  return section("Learning curve", content);
}

Response personPage(const Visit& visit, const Result<PersonFacts>& facts, const std::string& title,
                    std::int64_t since) {
  if (!facts) return refusal(visit, 403, facts.error().message);
  const bool isOwnPage = facts->person.id == visit.by->person().id;
  Markup content;
  if (facts->cohort) content += element("p", {{"class", "quiet"}}, "Class: " + facts->cohort->name);
  content += element(
      "p", {},
      link(facts->address + "/portfolio" + (isOwnPage && facts->cohort ? "?class=" + encoded(facts->cohort->id) : ""),
           "Portfolio for printing"));
  // Only those who teach the class may see its values.
  if (facts->cohort && !isOwnPage)
    content += element("p", {}, link(facts->address + "/comparison", "Compare with the class"));
  content += levelsOf(*facts) + curvesOf(visit, *facts);
  const auto attempts = attemptSection(visit, *facts);
  if (!attempts) return refusal(visit, 403, attempts.error().message);
  content += *attempts;
  if (isOwnPage) {
    const auto questionnaires = questionnaireSection(visit);
    if (!questionnaires) return refusal(visit, 403, questionnaires.error().message);
    content += *questionnaires + downloadSection(visit, facts->person.id);
  }
  return livePage(visit, title, content, facts->address + "/events", since);
}

}  // namespace

Response showOwnTraining(const Visit& visit, const Parts& /*parts*/) {
  const std::int64_t since = visit.live.numberOfLastChange();
  return personPage(visit, readOwn(visit), "My training", since);
}

Response showMember(const Visit& visit, const Parts& parts) {
  const std::int64_t since = visit.live.numberOfLastChange();
  return withMember(visit, parts, [&](const Cohort& cohort) {
    const auto facts = readMember(visit, cohort, parts[1]);
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
