#include "comparison/ComparisonPage.h"

#include "page/Charts.h"
#include "person/PersonReading.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/AttemptTable.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/PeopleStore.h>
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

std::string formatted(double value, const char* format) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), format, value);
  return digits.data();
}

/// A share in percent; only nothing is 0 %, and only all is 100 %.
std::string percentText(int count, int of) {
  const long percent = std::lround(100.0 * count / of);
  if (percent == 0 && count > 0) return "less than 1 %";
  if (percent == 100 && count < of) return "more than 99 %";
  return std::to_string(percent) + " %";
}

std::string withUnit(double value, const MetricMeaning& metric) {
  return metric.unit.empty() ? numberOf(value) : numberOf(value) + " " + metric.unit;
}

Markup meanLine(const std::string& name, std::size_t count, const Estimate& mean, const MetricMeaning& metric) {
  const std::string words = name + ": n = " + std::to_string(count) + ", mean " + withUnit(mean.value, metric);
  if (!mean.interval) return paragraph(words + ", no interval: " + std::string(mean.basis) + ".");
  return paragraph(words + ", 95 % interval " + numberOf(mean.interval->low) + " to " + numberOf(mean.interval->high) +
                   " (" + std::string(mean.basis) + ").");
}

Markup differenceOf(const ComparedClass& first, const ComparedClass& second, const MetricComparison& compared,
                    const MetricMeaning& metric) {
  const std::string &a = first.cohort.name, &b = second.cohort.name;
  if (!compared.ranks || !compared.meanOfFirst || !compared.meanOfSecond)
    return paragraph("No comparison: each class needs at least " + std::to_string(kFewestCompared) +
                     " people with values. " + a + " has " + std::to_string(compared.first.size()) + ", " + b +
                     " has " + std::to_string(compared.second.size()) + ".");
  const RankComparison& ranks = *compared.ranks;
  Markup lines = meanLine(a, compared.first.size(), *compared.meanOfFirst, metric) +
                 meanLine(b, compared.second.size(), *compared.meanOfSecond, metric) +
                 paragraph("Effect size (Cliff's delta) " + formatted(ranks.effect == 0 ? 0 : ranks.effect, "%.2f") +
                           ": in " + formatted(100 * ranks.superiority, "%.0f") +
                           " % of the pairs of one person of each class, the person of " + a +
                           " has the higher value (equal values count half). p " +
                           (ranks.p < 0.001 ? "< 0.001" : "= " + formatted(ranks.p, "%.2g")) + " (Mann-Whitney, " +
                           (ranks.exact ? "exact" : "approximate") + ").");
  if (compared.inBoth > 0)
    lines += paragraph("People with values in both classes: " + std::to_string(compared.inBoth) +
                       ". The p-value counts them as different people.");
  return lines;
}

std::string curriculumText(const Cohort& cohort) {
  if (cohort.curriculum.empty()) return cohort.name + " has no curriculum";
  return cohort.name + " is taught by " + cohort.curriculum + ", version " + std::to_string(cohort.curriculumVersion);
}

Markup comparisonOf(const ComparedClass& first, const ComparedClass& second, std::size_t metric) {
  const MetricMeaning& meaning = MetricCatalog::instance().all()[metric];
  const MetricComparison compared = compareInMetric(first.heat, second.heat, metric);
  return drawBoxes(
             BoxChart{.title = meaning.title,
                      .unit = meaning.unit,
                      .groups = {{first.cohort.name, compared.first, {}}, {second.cohort.name, compared.second, {}}}}) +
         differenceOf(first, second, compared, meaning) +
         (first.cohort.curriculum == second.cohort.curriculum &&
                  first.cohort.curriculumVersion == second.cohort.curriculumVersion
              ? Markup()
              : paragraph("The classes have different curricula, whose levels may differ in difficulty: " +
                          curriculumText(first.cohort) + "; " + curriculumText(second.cohort) + "."));
}

Markup metricField(std::size_t chosen) {
  Choices metrics;
  for (std::size_t i = 0; i < MetricCatalog::instance().comparableCount(); ++i)
    metrics.emplace_back(MetricCatalog::instance().all()[i].id, MetricCatalog::instance().all()[i].title);
  return choiceField("Metric", "metric", metrics, metrics[chosen].first);
}

Markup choiceForm(const Cohort& own, const std::vector<Cohort>& others, const std::string& with, std::size_t metric) {
  Choices classes;
  for (const Cohort& one : others) classes.emplace_back(one.id, listedName(one));
  return element("form",
                 {{"method", "get"}, {"action", "/classes/" + encoded(own.id) + "/comparison"}, {"class", "line"}},
                 choiceField("Other class", "with", classes, with) + metricField(metric) +
                     element("button", {{"type", "submit"}}, "Compare"));
}

Markup placeOf(const Cohort& cohort, const HeatMap& heat, const std::string& person, std::size_t column) {
  const MetricMeaning& metric = MetricCatalog::instance().all()[column];
  const std::vector<double> values = valuesOf(heat, column);
  const auto row = heat.find(person);
  const auto own = row == heat.end() ? std::nullopt : row->second[column].value;
  if (!own) return paragraph("This person has no values in this metric.");
  if (values.size() < kFewestCompared)
    return paragraph("Fewer than " + std::to_string(kFewestCompared) +
                     " people of the class have values in this metric.");
  std::string words = "This person: " + withUnit(*own, metric) + ". ";
  if (metric.better == MetricMeaning::Better::Neither) {
    words += "Percentile " + std::to_string(std::lround(*percentileRank(values, *own))) + " in the class.";
  } else {
    const PlaceInClass place = placeAmong(values, *own, metric);
    words += "Better than " + percentText(place.worse, place.others) + " of the others in the class";
    words += place.equal > 0 ? ", equal to " + percentText(place.equal, place.others) + "." : ".";
  }
  return drawBoxes(BoxChart{.title = metric.title + " (cross: this person)",
                            .unit = metric.unit,
                            .groups = {{cohort.name, values, own}}}) +
         paragraph(words);
}

const std::string kMeans =
    "Each person is one value: the mean of the last " + std::to_string(kLastAttempts) + " attempts at levels.";

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
  const std::size_t metric = metricOf(valueOf(visit.request.query, "metric"));
  const auto with = std::ranges::find(*cohorts, valueOf(visit.request.query, "with"), &Cohort::id);
  Markup content = choiceForm(first.cohort, *cohorts, with == cohorts->end() ? cohorts->front().id : with->id, metric) +
                   note(kMeans);
  // Each look at a class is logged: without a choice, no other class is read.
  if (with == cohorts->end()) return page(visit, title, content);
  ComparedClass second{.cohort = *with};
  heat = heatOf(*visit.by, second.cohort);
  if (!heat) return refusal(visit, 403, heat.error().message);
  second.heat = std::move(*heat);
  return page(visit, title, content + comparisonOf(first, second, metric));
}

Response showPlaceInClass(const Visit& visit, const Parts& parts) {
  return withMember(visit, parts, [&](const Cohort& cohort) {
    const auto heat = heatOf(*visit.by, cohort);
    if (!heat) return refusal(visit, 403, heat.error().message);
    const auto person = PeopleStore(*visit.by).person(parts[1]);
    if (!person) return refusal(visit, 403, person.error().message);
    const std::size_t metric = metricOf(valueOf(visit.request.query, "metric"));
    const std::string address = "/classes/" + encoded(cohort.id) + "/people/" + encoded(parts[1]) + "/comparison";
    return page(visit, "Compare " + displayName(*person) + " with the class " + cohort.name,
                element("form", {{"method", "get"}, {"action", address}, {"class", "line"}},
                        metricField(metric) + element("button", {{"type", "submit"}}, "Show")) +
                    note(kMeans) + placeOf(cohort, *heat, parts[1], metric));
  });
}

}  // namespace insonate::web
