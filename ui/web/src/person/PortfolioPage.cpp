#include "forms/FormPages.h"
#include "person/PersonPage.h"
#include "person/PersonReading.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/teaching/MetricCatalog.h>

#include <algorithm>
#include <cmath>

namespace insonate::web {
namespace {

Markup levelTable(const PersonFacts& facts) {
  if (!facts.curriculum)
    return section("Levels", paragraph(facts.cohort ? "The class has no curriculum." : "This person is in no class."));
  std::vector<std::vector<Markup>> rows;
  for (std::size_t i = 0; i < facts.progress.size(); ++i) {
    const LevelProgress& one = facts.progress[i];
    rows.push_back({text(facts.curriculum->levels[i].title), text(stateWords(one.state).name),
                    one.since_us ? timeOf(*one.since_us) : text(""), text(std::to_string(one.passes)),
                    text(std::to_string(one.attempts)), text(one.why)});
  }
  return section(
      "Levels", table("Levels of " + facts.curriculum->title + ", version " + std::to_string(facts.curriculum->version),
                      {"Level", "State", "Since", "Passed", "Attempts", "Reason"}, rows));
}

Markup curvesOfAll(const PersonFacts& facts) {
  if (!facts.curriculum) return {};
  const auto& metrics = MetricCatalog::instance().all();
  const auto points = std::ranges::find(metrics, "points", &MetricMeaning::id);
  Markup content;
  for (const Level& level : facts.curriculum->levels) {
    const AttemptChart curve = learningCurve(facts, level.name, level.title, *points);
    if (std::ranges::none_of(curve.points, [](const auto& point) { return point.has_value(); })) continue;
    content += chart(curve);
    if (const auto cusum = cusumCurve(facts, level.name, level.title); cusum && !cusum->points.empty())
      content += chart(*cusum);
  }
  return section("Learning curves", content.empty() ? paragraph("No attempts at levels yet.") : content);
}

std::string levelWords(const PersonFacts& facts, const AttemptFacts& attempt) {
  const Level* level = facts.curriculum ? levelOf(*facts.curriculum, attempt) : nullptr;
  return levelTitle(facts, attempt) + (level && level->assistance == Assistance::Test ? " (test)" : "");
}

/// The outcome of an attempt, and what limits its weight.
std::string weighedOutcome(const PersonFacts& facts, const AttemptFacts& attempt) {
  std::string words = outcomeWords(attempt, facts.curriculum ? &*facts.curriculum : nullptr);
  if (attempt.proof == AttemptProof::Accepted) words += "; accepted by an instructor without proof";
  if (attempt.proof == AttemptProof::Demonstration) words += "; made up for demonstration";
  return words;
}

Markup attemptLine(const PersonFacts& facts, const std::string& id) {
  const auto attempt = std::ranges::find(facts.history, id, &AttemptFacts::id);
  if (attempt == facts.history.end()) return note("About no attempt of this person.");
  return element("p", {{"class", "quiet"}},
                 text("Attempt of ") + timeOf(attempt->begun_us) +
                     text(": " + levelWords(facts, *attempt) + ", " + weighedOutcome(facts, *attempt) + "."));
}

Markup allAttempts(const PersonFacts& facts) {
  std::vector<std::vector<Markup>> rows;
  for (const AttemptFacts& one : facts.history)
    rows.push_back({timeOf(one.begun_us), text(levelWords(facts, one)), text(weighedOutcome(facts, one)),
                    text(one.points ? numberOf(*one.points) : ""),
                    text(numberOf(std::round(double(one.length_us) / 1e5) / 10))});
  if (rows.empty()) return section("Attempts", paragraph("No attempts yet."));
  return section("Attempts",
                 table("All attempts, oldest first", {"Begun", "Level", "Outcome", "Points", "Duration, s"}, rows));
}

Response portfolioPage(const Visit& visit, const Result<PersonFacts>& facts) {
  if (!facts) return refusal(visit, 403, facts.error().message);
  const auto judgements = judgementSection(visit, facts->person.id,
                                           [&](const std::string& attempt) { return attemptLine(*facts, attempt); });
  if (!judgements) return refusal(visit, 403, judgements.error().message);
  const std::string cohort = facts->cohort ? "Class: " + facts->cohort->name + ". " : "";
  return page(visit, "Portfolio of " + displayName(facts->person),
              element("p", {{"class", "quiet"}},
                      text(cohort + "Read by " + displayName(visit.by->person()) + ", ") + timeOf(visit.by->now_us())) +
                  element("p", {{"class", "quiet screen"}}, "To save the portfolio as PDF, print this page (Ctrl+P).") +
                  levelTable(*facts) + curvesOfAll(*facts) + *judgements + allAttempts(*facts));
}

}  // namespace

Response showOwnPortfolio(const Visit& visit, const Parts& /*parts*/) {
  return portfolioPage(visit, readOwn(visit));
}

Response showPortfolio(const Visit& visit, const Parts& parts) {
  return withMember(visit, parts,
                    [&](const Cohort& cohort) { return portfolioPage(visit, readMember(visit, cohort, parts[1])); });
}

}  // namespace insonate::web
