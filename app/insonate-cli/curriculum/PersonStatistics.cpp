#include "Answer.h"
#include "Groups.h"
#include "LevelPath.h"
#include "Lookup.h"
#include "MetricSeries.h"

#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/Judgement.h>
#include <insonate/curriculum/LearningCurve.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>
#include <memory>

namespace insonate::cli {
namespace {

Json curveJson(const std::optional<LearningCurve>& curve) {
  if (!curve) return nullptr;
  return {{"shape", curve->shape == LearningCurve::Shape::Power ? "power" : "exponential"},
          {"plateau", toJson(std::optional(curve->plateau))},
          {"gain", toJson(std::optional(curve->gain))},
          {"rate", curve->rate},
          {"residual", curve->residual},
          {"attempts", curve->attempts}};
}

/// The number of values in the key "last_5" of earlier versions, which scripts read.
constexpr std::size_t kLastOfEarlierVersions = 5;

/// The last kLastAttempts attempts at levels that count, as AttemptStore::recentOfCohort() gives them of a class; in
/// their order.
std::vector<AttemptFacts> lastAtLevels(const std::vector<AttemptFacts>& history) {
  std::vector<AttemptFacts> last;
  for (auto it = history.rbegin(); it != history.rend() && last.size() < std::size_t{kLastAttempts}; ++it)
    if (isCountedAtLevels(*it)) last.push_back(*it);
  std::ranges::reverse(last);
  return last;
}

/// Attempts of one procedure.
struct PersonAttempts {
  Attempts all, last;  ///< isInFigures() of the whole history; of lastAtLevels()
};

/// The figures that a person reads stand in the row itself, the others below it.
Json rowOf(const MetricMeaning& metric, const PersonAttempts& of) {
  const Attempts& attempts = of.all;
  const auto series = seriesOf(attempts, metric);
  const std::vector<double> values = valuesOf(attempts, metric);
  const std::span<const double> all(values);
  const auto mean = meanOf(values, metric.kind);
  const auto curve = fitLearningCurve(series, metric.kind);
  const auto inBand = std::ranges::count_if(values, [&](double value) { return metric.inExpertBand(value); });
  return {{"metric", metric.id},
          {"unit", metric.unit},
          {"n", values.size()},
          {"mean", toJson(mean)},
          {"mean_value", mean ? Json(mean->value) : Json(nullptr)},
          {"low", mean && mean->interval ? Json(mean->interval->low) : Json(nullptr)},
          {"high", mean && mean->interval ? Json(mean->interval->high) : Json(nullptr)},
          {"interval_by", mean ? Json(mean->basis) : Json(nullptr)},
          {"median", orNull(median(values))},
          {"mean_of_last", orNull(meanValue(valuesOf(of.last, metric)))},
          {"last_5", orNull(meanValue(all.last(std::min(kLastOfEarlierVersions, all.size()))))},
          {"expert", orNull(metric.expert)},
          {"in_expert_band_percent", metric.expert && !values.empty() ? Json(100.0 * static_cast<double>(inBand) /
                                                                             static_cast<double>(values.size()))
                                                                      : Json(nullptr)},
          {"curve", curveJson(curve)},
          {"plateau", curve ? Json(curve->plateau.value) : Json(nullptr)}};
}

Json metricsOf(const std::string& procedure, const PersonAttempts& attempts, const std::string& only) {
  Json rows = Json::array();
  for (const MetricMeaning& metric : meaningsFor(procedure))
    if (only.empty() || metric.id == only) rows.push_back(rowOf(metric, attempts));
  return rows;
}

std::string percentText(const Json& estimate) {
  char text[80];
  std::snprintf(text, sizeof text, "%.0f %% succeeded (Wilson's 95 %% interval %.0f to %.0f)",
                100 * estimate["value"].get<double>(), 100 * estimate["low"].get<double>(),
                100 * estimate["high"].get<double>());
  return text;
}

Result<Answer> paths(const SignedIn& by, const Person& person) {
  Answer answer{Json::array(), ""};
  const auto classes = classesOf(by, person);
  if (!classes) return tl::unexpected(classes.error());
  for (const Cohort& cohort : *classes) {
    if (cohort.curriculum.empty()) continue;
    const auto curriculum = curriculumOf(by, cohort);
    if (!curriculum) return tl::unexpected(curriculum.error());
    const auto path = levelPath(by, *curriculum, person.id);
    if (!path) return tl::unexpected(path.error());
    Json rows = toJson(*curriculum, *path);
    for (Json& row : rows) row["cusum_score"] = row["cusum"].empty() ? Json(nullptr) : row["cusum"].back();
    answer.text += "\n" + cohort.name + "\n" +
                   tableOf(rows, {{"level", "level"},
                                  {"state", "state"},
                                  {"attempts", "n"},
                                  {"passes", "passed"},
                                  {"fewest_attempts", "attempts at least"},
                                  {"cusum_score", "LC-CUSUM"},
                                  {"cusum_limit", "limit"},
                                  {"cusum_signalled", "signalled"}});
    answer.object.push_back({{"class", cohort.name}, {"levels", std::move(rows)}});
  }
  return answer;
}

struct PersonArguments {
  std::string person, metric;
};

Result<Answer> statistics(const SignedIn& by, const PersonArguments& a) {
  const auto person = personNamed(by, a.person);
  if (!person) return tl::unexpected(person.error());
  const auto history = AttemptStore(by).history(person->id);
  if (!history) return tl::unexpected(history.error());
  auto levels = paths(by, *person);
  if (!levels) return levels;
  Answer answer{
      {{"person", toJson(*person)}, {"last", kLastAttempts}, {"procedures", Json::array()}, {"paths", levels->object}},
      ""};
  const std::string lastTitle = "mean of last " + std::to_string(kLastAttempts) + " at levels";
  const std::vector<AttemptFacts> last = lastAtLevels(*history);
  auto lastByProcedure = figuresByProcedure(last);
  const auto waiting = std::ranges::count_if(*history, waitsForAcceptance);
  for (const auto& [procedure, attempts] : figuresByProcedure(*history)) {
    const Json rows = metricsOf(procedure, {attempts, lastByProcedure[procedure]}, a.metric);
    const Json success = toJson(successOf(attempts));
    answer.text += procedure + ": " + std::to_string(attempts.size()) +
                   (attempts.size() == 1 ? " attempt" : " attempts") + " at levels and in free practice, " +
                   percentText(success) + "\n" +
                   tableOf(rows, {{"metric", "metric"},
                                  {"unit", "unit"},
                                  {"n", "n"},
                                  {"mean_value", "mean"},
                                  {"low", "95 % from"},
                                  {"high", "to"},
                                  {"interval_by", "by"},
                                  {"median", "median"},
                                  {"mean_of_last", lastTitle.c_str()},
                                  {"plateau", "plateau"},
                                  {"expert", "expert"},
                                  {"in_expert_band_percent", "in expert band, %"}});
    answer.object["procedures"].push_back({{"procedure", procedure},
                                           {"attempts", attempts.size()},
                                           {"succeeded", success},
                                           {"success", success},  // as earlier versions named it
                                           {"metrics", rows}});
  }
  if (answer.text.empty()) answer.text = "No attempts that count yet.\n";
  if (waiting) answer.text += "Left out until an instructor accepts them: " + std::to_string(waiting) + " unproven\n";
  answer.object["waiting_for_acceptance"] = waiting;
  answer.text += levels->text;
  return answer;
}

}  // namespace

void addPersonStatistics(CLI::App& group, Outcome& outcome) {
  auto a = std::make_shared<PersonArguments>();
  CLI::App* command = addSignedInCommand(group, outcome, "person",
                                         "Print a person's metrics with intervals, learning curves and LC-CUSUM",
                                         [a](const SignedIn& by) { return statistics(by, *a); });
  command->add_option("NAME", a->person, "Name of the person (default: you)");
  std::vector<std::string> ids;
  for (const MetricMeaning& metric : metricMeanings()) ids.push_back(metric.id);
  command->add_option("--metric", a->metric, "Only this metric")->check(CLI::IsMember(ids));
}

}  // namespace insonate::cli
