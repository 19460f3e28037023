#include "levels/BriefingPage.h"

#include "person/PersonPage.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Form.h>
#include <insonate/curriculum/FormStore.h>
#include <insonate/curriculum/Unlocking.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace insonate::web {
namespace {

std::string helpWords(Assistance assistance) {
  switch (assistance) {
    case Assistance::Guided:
      return "Guided level: the program names each step, and gives hints.";
    case Assistance::Hints:
      return "Level with hints: the program gives a hint only if something goes wrong.";
    case Assistance::Test:
      break;
  }
  return "Test: the program gives no hints and does not show the CT. An attempt counts if an instructor has opened the "
         "test.";
}

const MetricMeaning* meaningOf(const std::string& metric) {
  const auto& all = MetricCatalog::instance().all();
  const auto found = std::ranges::find(all, metric, &MetricMeaning::id);
  return found == all.end() ? nullptr : &*found;
}

std::string limitOf(const MetricStandard& standard, const MetricMeaning* meaning) {
  std::string limit =
      standard.minimum ? "at least " + numberOf(*standard.minimum) : "at most " + numberOf(*standard.maximum);
  if (meaning && !meaning->unit.empty()) limit += " " + meaning->unit;
  return limit;
}

Markup standardsOf(const Level& level) {
  const auto count = level.pass.standards.size();
  if (count == 0) return {};
  std::vector<std::vector<Markup>> rows;
  for (const MetricStandard& standard : level.pass.standards) {
    const MetricMeaning* meaning = meaningOf(standard.metric);
    rows.push_back({text(meaning ? meaning->title : standard.metric), text(limitOf(standard, meaning)),
                    text(standard.critical ? "must be met" : ""), text(standard.source)});
  }
  const double least = std::ceil(level.pass.mastery_percent / 100 * static_cast<double>(count) - 1e-9);
  return table("Standards: at least " + numberOf(least) + " of " + std::to_string(count) + " must be met",
               {"Metric", "Limit", "", "Reason for the limit"}, rows);
}

Markup conditionsOf(const Level& level) {
  std::string pass = "An attempt passes if it is completed and successful, without a critical error";
  if (level.pass.minPoints) pass += ", and with at least " + numberOf(*level.pass.minPoints) + " points";
  const int inARow = level.mastery.consecutivePasses, least = fewestAttempts(level.mastery);
  const std::string mastery =
      "The level is mastered after " +
      (inARow == 1 ? std::string("one passed attempt") : std::to_string(inARow) + " passed attempts in a row") +
      (level.mastery.cusum ? " and when the learning curve (LC-CUSUM) has reached its limit" : "") +
      "; this takes at least " + std::to_string(least) + (least == 1 ? " attempt." : " attempts.");
  return section("Passing and mastering this level", paragraph(pass + ".") + standardsOf(level) + paragraph(mastery));
}

Markup stepsOf(const Procedure& procedure) {
  Markup items;
  for (const ProcedureStep& step : procedure.steps)
    items += element("li", {},
                     element("strong", {}, step.title) + text(step.optional ? " (optional)" : "") +
                         element("p", {}, step.instruction));
  return section("Steps", element("ol", {{"class", "steps"}}, items));
}

std::string nameOf(Severity severity) {
  return severity == Severity::Minor ? "minor" : severity == Severity::Major ? "major" : "critical";
}

/// Errors of the procedure, the worst first.
Markup errorsOf(const Procedure& procedure) {
  std::vector<const ProcedureRule*> rules;
  for (const ProcedureRule& rule : procedure.rules) rules.push_back(&rule);
  std::ranges::stable_sort(rules, std::greater(), &ProcedureRule::severity);
  std::vector<std::vector<Markup>> rows;
  for (const ProcedureRule* rule : rules)
    rows.push_back({text(rule->text),
                    element("span", {{"class", rule->severity == Severity::Critical ? "missed" : ""}},
                            (rule->severity == Severity::Critical ? "\u25b2 " : "") + nameOf(rule->severity)),
                    text(rule->advice)});
  if (rows.empty()) return {};
  return section("Errors to avoid", table("Errors, the most severe first", {"Error", "Severity", "Advice"}, rows));
}

/// Returns the resolutions that the user and instructors wrote in the newest debrief of the user's attempts at this
/// level.
Result<Markup> resolutionsOf(const SignedIn& by, const std::string& level) {
  const auto history = AttemptStore(by).history(by.person().id);
  if (!history) return tl::unexpected(history.error());
  const auto forms = FormStore(by).listByPerson(by.person().id);
  if (!forms) return tl::unexpected(forms.error());
  std::map<std::string, bool> isAtLevel;
  for (const AttemptFacts& attempt : *history) isAtLevel[attempt.id] = attempt.level == level;
  std::string newest;
  for (const StoredForm& one : *forms)
    if (one.filled.form == "debrief" && isAtLevel[one.filled.attempt]) newest = one.filled.attempt;
  Markup items;
  for (const StoredForm& one : *forms) {
    if (newest.empty() || one.filled.form != "debrief" || one.filled.attempt != newest) continue;
    const auto answers = parseAnswers(one.filled.answers).value_or(FormAnswers());
    const auto next = answers.find("next");
    const auto* words = next == answers.end() ? nullptr : std::get_if<std::string>(&next->second);
    if (words)
      items += element("li", {},
                       element("span", {{"class", "lines"}}, *words) +
                           element("span", {{"class", "quiet"}}, " (" + one.rater + ")"));
  }
  if (items.empty()) return Markup();
  return section("What to do differently this time",
                 note("From your latest debrief of an attempt at this level.") + element("ul", {}, items) +
                     element("p", {}, link("/attempts/" + encoded(newest), "Open this attempt")));
}

}  // namespace

std::string briefingAddress(const std::string& cohort, const std::string& level) {
  return "/classes/" + encoded(cohort) + "/levels/" + encoded(level);
}

Response showBriefing(const Visit& visit, const Parts& parts) {
  const auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto cohort = std::ranges::find(*cohorts, parts[0], &Cohort::id);
  if (cohort == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  const auto curriculum = curriculumOf(*visit.by, *cohort);
  if (!curriculum) return refusal(visit, 403, curriculum.error().message);
  const Level* level = *curriculum ? (*curriculum)->level(parts[1]) : nullptr;
  if (!level) return refusal(visit, 404, "The curriculum of the class has no such level.");
  const auto resolutions = resolutionsOf(*visit.by, level->name);
  if (!resolutions) return refusal(visit, 403, resolutions.error().message);
  Markup content = paragraph(level->about) + note(helpWords(level->assistance)) + *resolutions;
  const auto procedure = builtInProcedure(level->procedure);
  if (procedure) content += stepsOf(*procedure);
  content += conditionsOf(*level);
  if (procedure) content += errorsOf(*procedure);
  return page(visit, "Briefing: " + level->title, content);
}

}  // namespace insonate::web
