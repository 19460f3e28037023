#include "comparison/ComparisonPage.h"

#include "page/Charts.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/teaching/MetricCatalog.h>
#include <insonate/teaching/MetricComparison.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace insonate::web {
namespace {

/// A class that is compared, with the values of its people.
struct ComparedClass {
  Cohort cohort{};
  HeatMap heat{};
};

Result<HeatMap> heatOf(const SignedIn& by, const Cohort& cohort) {
  const auto last = AttemptStore(by).recentOfCohort(cohort.id, kLastAttempts);
  return last ? Result<HeatMap>(heatMapOf(*last)) : tl::unexpected(last.error());
}

/// Place of a metric among those that can be compared; the first one if the id is unknown.
std::size_t metricOf(const std::string& id) {
  const auto& all = MetricCatalog::instance().all();
  const auto end = all.begin() + static_cast<std::ptrdiff_t>(MetricCatalog::instance().comparableCount());
  const auto found = std::find_if(all.begin(), end, [&](const MetricMeaning& one) { return one.id == id; });
  return found == end ? 0 : static_cast<std::size_t>(found - all.begin());
}

std::string percentText(double share) {
  return std::to_string(std::lround(100 * share)) + " %";
}

std::string shortNumber(double value, const char* format) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), format, value);
  return digits.data();
}

Markup meanLine(const std::string& name, std::size_t count, const Estimate& mean) {
  const std::string words = name + ": n = " + std::to_string(count) + ", mean " + numberOf(mean.value);
  if (!mean.interval) return paragraph(words + ", no interval: " + std::string(mean.basis) + ".");
  return paragraph(words + ", 95 % interval " + numberOf(mean.interval->low) + " to " + numberOf(mean.interval->high) +
                   " (" + std::string(mean.basis) + ").");
}

Markup differenceOf(const ComparedClass& first, const ComparedClass& second, const MetricComparison& compared) {
  if (!compared.ranks)
    return paragraph("No comparison: " + std::to_string(compared.first.size()) + " people of " + first.cohort.name +
                     " and " + std::to_string(compared.second.size()) + " people of " + second.cohort.name +
                     " have values; each class needs at least " + std::to_string(kFewestCompared) + ".");
  const RankComparison& ranks = *compared.ranks;
  Markup lines =
      meanLine(first.cohort.name, compared.first.size(), *compared.meanOfFirst) +
      meanLine(second.cohort.name, compared.second.size(), *compared.meanOfSecond) +
      paragraph("Effect size (Cliff's delta) " + shortNumber(ranks.effect, "%.2f") + ": in " +
                percentText(ranks.superiority) + " of the pairs of one person of each class, the person of " +
                first.cohort.name + " has the higher value. p = " + shortNumber(ranks.p, "%.2g") + " (Mann-Whitney, " +
                (ranks.exact ? "exact" : "approximate") + ").");
  if (compared.inBoth > 0)
    lines += paragraph("People who are in both classes: " + std::to_string(compared.inBoth) +
                       ". The interval and the p-value count them as different people.");
  return lines;
}

Markup comparisonOf(const ComparedClass& first, const ComparedClass& second, std::size_t metric) {
  const MetricMeaning& meaning = MetricCatalog::instance().all()[metric];
  const MetricComparison compared = compareInMetric(first.heat, second.heat, metric);
  return drawBoxes(
             BoxChart{.title = meaning.title,
                      .unit = meaning.unit,
                      .groups = {{first.cohort.name, compared.first, {}}, {second.cohort.name, compared.second, {}}}}) +
         differenceOf(first, second, compared);
}

Markup choiceForm(const Cohort& own, const std::vector<Cohort>& others, const std::string& with, std::size_t metric) {
  Choices classes, metrics;
  for (const Cohort& one : others) classes.emplace_back(one.id, listedName(one));
  for (std::size_t i = 0; i < MetricCatalog::instance().comparableCount(); ++i)
    metrics.emplace_back(MetricCatalog::instance().all()[i].id, MetricCatalog::instance().all()[i].title);
  return element("form",
                 {{"method", "get"}, {"action", "/classes/" + encoded(own.id) + "/comparison"}, {"class", "line"}},
                 choiceField("Other class", "with", classes, with) +
                     choiceField("Metric", "metric", metrics, metrics[metric].first) +
                     element("button", {{"type", "submit"}}, "Compare"));
}

}  // namespace

Response showComparison(const Visit& visit, const Parts& parts) {
  auto cohorts = CohortStore(*visit.by).cohorts();
  if (!cohorts) return refusal(visit, 403, cohorts.error().message);
  const auto own = std::ranges::find(*cohorts, parts[0], &Cohort::id);
  if (own == cohorts->end()) return refusal(visit, 404, "There is no such class, or it is not yours.");
  ComparedClass first{.cohort = *own};
  auto heat = heatOf(*visit.by, first.cohort);
  if (!heat) return refusal(visit, 403, heat.error().message);
  first.heat = std::move(*heat);
  cohorts->erase(own);
  const std::string title = "Compare " + first.cohort.name + " with another class";
  if (cohorts->empty()) return page(visit, title, paragraph("You can see only one class; a comparison needs two."));
  auto with = std::ranges::find(*cohorts, valueOf(visit.request.query, "with"), &Cohort::id);
  if (with == cohorts->end()) with = cohorts->begin();
  ComparedClass second{.cohort = *with};
  heat = heatOf(*visit.by, second.cohort);
  if (!heat) return refusal(visit, 403, heat.error().message);
  second.heat = std::move(*heat);
  const std::size_t metric = metricOf(valueOf(visit.request.query, "metric"));
  return page(visit, title,
              choiceForm(first.cohort, *cohorts, second.cohort.id, metric) + comparisonOf(first, second, metric) +
                  note("Each person is one value: the mean of the last " + std::to_string(kLastAttempts) +
                       " attempts at levels."));
}

Result<Markup> placeInClassSection(const SignedIn& by, const Cohort& cohort, const std::string& person,
                                   const MetricMeaning& metric) {
  const auto heat = heatOf(by, cohort);
  if (!heat) return tl::unexpected(heat.error());
  const auto& all = MetricCatalog::instance().all();
  const auto column = static_cast<std::size_t>(std::ranges::find(all, metric.id, &MetricMeaning::id) - all.begin());
  const std::vector<double> values = valuesOf(*heat, column);
  const auto row = heat->find(person);
  const auto own = row == heat->end() ? std::nullopt : row->second[column].value;
  const std::string heading = "Compared with the class";
  if (!own)
    return section(heading, paragraph("This person has no values in the last " + std::to_string(kLastAttempts) +
                                      " attempts at levels."));
  if (values.size() < kFewestCompared)
    return section(heading, paragraph("Fewer than " + std::to_string(kFewestCompared) +
                                      " people of the class have values in this metric."));
  std::string words;
  if (metric.better == MetricMeaning::Better::Neither) {
    words = "Percentile " + std::to_string(std::lround(*percentileRank(values, *own))) + " of the class.";
  } else {
    const PlaceInClass place = placeAmong(values, *own, metric);
    words = "Better than " + percentText(double(place.worse) / place.others) +
            " of the others in the class, equal to " + percentText(double(place.equal) / place.others) + ".";
  }
  return section(heading, drawBoxes(BoxChart{.title = metric.title + " (cross: this person)",
                                             .unit = metric.unit,
                                             .groups = {{cohort.name, values, own}}}) +
                              paragraph(words) +
                              note("Means of the last " + std::to_string(kLastAttempts) + " attempts at levels."));
}

}  // namespace insonate::web
