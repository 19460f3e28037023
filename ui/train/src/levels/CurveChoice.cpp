#include "CurveChoice.h"

#include <insonate/curriculum/Judgement.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/teaching/TeachingHere.h>
#include <insonate/ui/Text.h>

#include <algorithm>

namespace insonate::train {
namespace {

const std::string kPointsCurve = "points";

bool isOf(const AttemptFacts& attempt, const Curriculum* curriculum, const CurveChoice& which) {
  if (attempt.procedure != which.procedure || !isInFigures(attempt)) return false;
  return which.level.empty() || (curriculum && attempt.curriculum == curriculum->name && attempt.level == which.level);
}

}  // namespace

std::vector<CurveChoice> curveChoices(const Curriculum* curriculum, std::span<const AttemptFacts> history) {
  std::vector<std::string> procedures;
  const auto add = [&](const std::string& name) {
    if (std::ranges::find(procedures, name) == procedures.end()) procedures.push_back(name);
  };
  for (const AttemptFacts& one : history)
    if (isCounted(one)) add(one.procedure);
  if (procedures.empty() && curriculum && !curriculum->levels.empty()) add(curriculum->levels.front().procedure);
  std::vector<CurveChoice> choices;
  for (const std::string& name : procedures) {
    const auto procedure = builtInProcedure(name);
    const QString title = QString::fromStdString(procedure ? procedure->title : name);
    choices.push_back({tr("All: %1").arg(title), name, {}});
    if (!curriculum) continue;
    for (const Level& level : curriculum->levels)
      if (level.procedure == name) choices.push_back({QString::fromStdString(level.title), name, level.name});
  }
  return choices;
}

std::vector<MetricMeaning> curveMetrics(const std::string& procedure) {
  MetricMeaning points;
  points.id = kPointsCurve, points.title = tr("Points (maximum 100)").toStdString();
  points.better = MetricMeaning::Better::Higher;
  points.kind = ValueKind::Percent;
  std::vector<MetricMeaning> all{points};
  const auto known = builtInProcedure(procedure);
  const auto metrics = known ? metricMeanings(*known) : metricMeanings();
  all.insert(all.end(), metrics.begin(), metrics.end());
  return all;
}

std::vector<std::optional<double>> curveValues(const Curriculum* curriculum, std::span<const AttemptFacts> history,
                                               const CurveChoice& which, const MetricMeaning& meaning) {
  std::vector<std::optional<double>> values;
  for (const AttemptFacts& attempt : history)
    if (isOf(attempt, curriculum, which))
      values.push_back(meaning.id == kPointsCurve ? pointsOf(attempt) : valueOf(attempt, meaning.id, meaning.version));
  return values;
}

}  // namespace insonate::train
