#include "attempt/MetricSection.h"

#include "page/Page.h"

#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/teaching/HeatMap.h>
#include <insonate/teaching/MetricCatalog.h>

namespace insonate::web {
namespace {

std::string limitOf(const MetricStandard& standard, const std::string& unit) {
  std::string limit =
      standard.minimum ? "at least " + numberOf(*standard.minimum) : "at most " + numberOf(*standard.maximum);
  if (!unit.empty()) limit += " " + unit;
  return standard.critical ? limit + ", must be met" : limit;
}

/// The cells "Standard of the level" and "Result" of a metric.
std::pair<Markup, Markup> standardOf(const MetricMeaning& meaning, const Level* level, const Judgement& judgement) {
  std::pair<Markup, Markup> cells;
  for (std::size_t i = 0; level && i < level->pass.standards.size(); ++i) {
    const MetricStandard& standard = level->pass.standards[i];
    if (standard.metric != meaning.id) continue;
    cells.first = text(limitOf(standard, meaning.unit));
    cells.second = element("span", {{"class", judgement.standardsMet[i] ? "met" : "missed"}},
                           judgement.standardsMet[i] ? "\u2713 met" : "\u2717 missed");
  }
  return cells;
}

Markup publishedCell(const std::optional<double>& value, const std::string& unit) {
  return value ? text(publishedValue(*value, unit)) : element("span", {{"class", "quiet"}}, "n/a");
}

Markup explanations(const AttemptFacts& attempt, const std::vector<const MetricMeaning*>& metrics) {
  Markup list;
  for (const MetricMeaning* meaning : metrics) {
    Markup parts;
    for (const MetricExplanation& part : MetricCatalog::instance().explanationOf(attempt.procedure, *meaning))
      parts += element("p", {}, element("span", {{"class", "quiet"}}, part.heading + ": ") + text(part.text));
    if (!parts.empty()) list += element("dt", {}, meaning->title) + element("dd", {}, parts);
  }
  return element("details", {{"class", "explanations"}},
                 element("summary", {}, "Definitions, sources and evidence of the metrics") + element("dl", {}, list));
}

}  // namespace

Markup metricSection(const AttemptFacts& attempt, const Level* level) {
  const MetricCatalog& catalog = MetricCatalog::instance();
  const Judgement judgement = level ? judge(level->pass, attempt) : Judgement{};
  std::vector<const MetricMeaning*> measured;
  std::vector<std::vector<Markup>> rows;
  for (const MetricMeaning& meaning : catalog.all()) {
    const auto value = valueIn(attempt, meaning);
    if (!value) continue;
    measured.push_back(&meaning);
    const MetricMeaning& known = catalog.withNormsOf(attempt.procedure, meaning);
    const auto share = shareIn(attempt, meaning);
    const auto [standard, result] = standardOf(meaning, level, judgement);
    rows.push_back({text(meaning.title), text(numberOf(*value) + (meaning.unit.empty() ? "" : " " + meaning.unit)),
                    publishedCell(known.novice, meaning.unit), publishedCell(known.expert, meaning.unit),
                    text(share && meaning.id != "points" ? heatWords(share) : ""), standard, result});
  }
  if (rows.empty()) return section("Metrics", paragraph("No values were measured."));
  return section("Metrics",
                 table("Metrics of the attempt",
                       {"Metric", "Value", "Novice", "Expert", "Compared with published values",
                        "Standard of the level", "Result"},
                       rows) +
                     note("Novice and expert: published values of novices and experts; n/a: none are known.") +
                     explanations(attempt, measured));
}

}  // namespace insonate::web
