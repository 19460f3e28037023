#include "Answer.h"
#include "Groups.h"
#include "Lookup.h"
#include "MetricSeries.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/CohortStore.h>
#include <insonate/curriculum/Comparison.h>

#include <memory>
#include <set>

namespace insonate::cli {
namespace {

struct StatisticsArguments {
  std::string first, second;
  int last = kLastAttempts;
};

/// The attempts of a class by procedure and person.
using ByPerson = std::map<std::string, Attempts>;
struct ClassAttempts {
  Cohort cohort;
  std::vector<AttemptFacts> facts;
  std::map<std::string, ByPerson> byProcedure;
};

Result<ClassAttempts> attemptsOf(const SignedIn& by, const std::string& name, int last) {
  auto cohort = classNamed(by, name);
  if (!cohort) return tl::unexpected(cohort.error());
  auto facts = AttemptStore(by).recentOfCohort(cohort->id, last);
  if (!facts) return tl::unexpected(facts.error());
  ClassAttempts all{std::move(*cohort), std::move(*facts), {}};
  for (const auto& [procedure, attempts] : figuresByProcedure(all.facts))
    for (const AttemptFacts* attempt : attempts) all.byProcedure[procedure][attempt->person].push_back(attempt);
  return all;
}

/// One value a person, so that who practiced more does not weigh more.
std::vector<double> mediansOf(const ByPerson& people, const MetricMeaning& metric) {
  std::vector<double> medians;
  for (const auto& [person, attempts] : people)
    if (const auto value = median(valuesOf(attempts, metric))) medians.push_back(*value);
  return medians;
}

Json boxRow(const MetricMeaning& metric, const std::vector<double>& values) {
  Json row{{"metric", metric.id}, {"unit", metric.unit}, {"n", values.size()}, {"expert", orNull(metric.expert)}};
  const auto box = boxPlotOf(values);
  const auto add = [&](const char* key, double BoxPlot::*part) { row[key] = box ? Json((*box).*part) : Json(nullptr); };
  add("lower_whisker", &BoxPlot::lowerWhisker);
  add("lower_quartile", &BoxPlot::lowerQuartile);
  add("median", &BoxPlot::median);
  add("upper_quartile", &BoxPlot::upperQuartile);
  add("upper_whisker", &BoxPlot::upperWhisker);
  row["outliers"] = box ? Json(box->outliers) : Json::array();
  return row;
}

Json personRow(const Member& member, const Attempts& attempts, const std::vector<MetricMeaning>& metrics) {
  const auto success = successOf(attempts);
  Json medians = Json::object();
  for (const MetricMeaning& metric : metrics) medians[metric.id] = orNull(median(valuesOf(attempts, metric)));
  const Json share = success ? Json(success->value) : Json(nullptr);
  // "success" and "success_share" are the names of earlier versions, which scripts read.
  return {{"name", member.person.name},
          {"full_name", member.person.fullName},
          {"n", attempts.size()},
          {"succeeded", toJson(success)},
          {"success", toJson(success)},
          {"succeeded_share", share},
          {"success_share", share},
          {"low", success && success->interval ? Json(success->interval->low) : Json(nullptr)},
          {"high", success && success->interval ? Json(success->interval->high) : Json(nullptr)},
          {"medians", std::move(medians)}};
}

Result<Answer> classStatistics(const SignedIn& by, const StatisticsArguments& a) {
  const auto all = attemptsOf(by, a.first, a.last);
  if (!all) return tl::unexpected(all.error());
  const auto members = CohortStore(by).members(all->cohort.id);
  if (!members) return tl::unexpected(members.error());
  Answer answer{{{"class", all->cohort.name}, {"last", a.last}, {"procedures", Json::array()}}, ""};
  for (const auto& [procedure, people] : all->byProcedure) {
    const auto metrics = meaningsFor(procedure);
    Json persons = Json::array(), boxes = Json::array();
    for (const Member& member : *members)
      if (const auto found = people.find(member.person.id); found != people.end())
        persons.push_back(personRow(member, found->second, metrics));
    for (const MetricMeaning& metric : metrics) boxes.push_back(boxRow(metric, mediansOf(people, metric)));
    answer.text += procedure + ", the last " + std::to_string(a.last) +
                   " attempts of each person at levels, without free practice; each person counts with the median\n" +
                   tableOf(boxes, {{"metric", "metric"},
                                   {"unit", "unit"},
                                   {"n", "people"},
                                   {"lower_whisker", "from"},
                                   {"lower_quartile", "quartile"},
                                   {"median", "median"},
                                   {"upper_quartile", "quartile"},
                                   {"upper_whisker", "to"},
                                   {"expert", "expert"}}) +
                   "\n" +
                   tableOf(persons, {{"name", "name"},
                                     {"full_name", "full name"},
                                     {"n", "attempts"},
                                     {"succeeded_share", "succeeded"},
                                     {"low", "95 % from"},
                                     {"high", "to"}});
    answer.object["procedures"].push_back(
        {{"procedure", procedure}, {"people", std::move(persons)}, {"metrics", std::move(boxes)}});
  }
  if (answer.text.empty()) answer.text = "'" + all->cohort.name + "' has no attempts that count yet.";
  return answer;
}

Json comparisonRow(const MetricMeaning& metric, const std::vector<double>& first, const std::vector<double>& second) {
  const auto ranks = compareRanks(first, second);
  Json row{{"metric", metric.id},
           {"unit", metric.unit},
           {"n_first", first.size()},
           {"n_second", second.size()},
           {"median_first", orNull(median(first))},
           {"median_second", orNull(median(second))}};
  for (const char* key : {"u", "superiority", "effect", "p", "exact"}) row[key] = nullptr;
  if (ranks)
    row.update({{"u", ranks->u},
                {"superiority", ranks->superiority},
                {"effect", ranks->effect},
                {"p", ranks->p},
                {"exact", ranks->exact}});
  return row;
}

/// Number of people who are in both groups and would be compared with themselves.
std::size_t peopleInBoth(const ClassAttempts& first, const ClassAttempts& second) {
  std::set<std::string> people, both;
  for (const AttemptFacts& facts : first.facts) people.insert(facts.person);
  for (const AttemptFacts& facts : second.facts)
    if (people.contains(facts.person)) both.insert(facts.person);
  return both.size();
}

Result<Answer> comparison(const SignedIn& by, const StatisticsArguments& a) {
  const auto first = attemptsOf(by, a.first, a.last), second = attemptsOf(by, a.second, a.last);
  if (!first) return tl::unexpected(first.error());
  if (!second) return tl::unexpected(second.error());
  std::string note = "Mann-Whitney test with one median for each person and " + std::to_string(kFewestCompared) +
                     " people or more in each class, from the last " + std::to_string(a.last) +
                     " attempts of each person at levels, without free practice. One in twenty comparisons has p below "
                     "0.05 by chance alone.";
  const std::size_t both = peopleInBoth(*first, *second);
  if (both > 0)
    note += " These people are in both classes, and the test counts them twice: " + std::to_string(both) + ".";
  Answer answer{{{"first", first->cohort.name},
                 {"second", second->cohort.name},
                 {"last", a.last},
                 {"people_in_both", both},
                 {"note", note},
                 {"procedures", Json::array()}},
                ""};
  for (const auto& [procedure, people] : first->byProcedure) {
    const auto others = second->byProcedure.find(procedure);
    if (others == second->byProcedure.end()) continue;
    Json rows = Json::array();
    for (const MetricMeaning& metric : meaningsFor(procedure))
      rows.push_back(comparisonRow(metric, mediansOf(people, metric), mediansOf(others->second, metric)));
    answer.text += procedure + "\n" +
                   tableOf(rows, {{"metric", "metric"},
                                  {"unit", "unit"},
                                  {"n_first", "n"},
                                  {"n_second", "n"},
                                  {"median_first", first->cohort.name.c_str()},
                                  {"median_second", second->cohort.name.c_str()},
                                  {"effect", "effect"},
                                  {"p", "p"}});
    answer.object["procedures"].push_back({{"procedure", procedure}, {"metrics", std::move(rows)}});
  }
  answer.text = answer.text.empty() ? "There is no procedure for which both classes have attempts that count."
                                    : answer.text + note;
  return answer;
}

void addLast(CLI::App& command, StatisticsArguments& a) {
  command.add_option("--last", a.last, "Number of latest attempts of each person at levels")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
}

}  // namespace

void addClassStatistics(CLI::App& group, Outcome& outcome) {
  auto a = std::make_shared<StatisticsArguments>();
  CLI::App* one = addSignedInCommand(group, outcome, "class",
                                     "Print statistics of a class: box plots of its metrics, and success rates",
                                     [a](const SignedIn& by) { return classStatistics(by, *a); });
  one->add_option("CLASS", a->first, "Name of the class")->required();
  addLast(*one, *a);
  auto b = std::make_shared<StatisticsArguments>();
  CLI::App* two = addSignedInCommand(group, outcome, "compare", "Compare two classes, metric by metric",
                                     [b](const SignedIn& by) { return comparison(by, *b); });
  two->add_option("FIRST", b->first, "Name of a class")->required();
  two->add_option("SECOND", b->second, "Name of the other class")->required();
  addLast(*two, *b);
}

}  // namespace insonate::cli
