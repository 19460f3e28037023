#include <insonate/curriculum/Judgement.h>
#include <insonate/procedure/Procedure.h>
#include <insonate/teaching/MetricCatalog.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>

namespace insonate {
namespace {

constexpr const char* kPoints = "points";

}  // namespace

MetricCatalog::MetricCatalog() : all_(metricMeanings()) {
  for (const std::string& name : procedurePresetNames()) {
    const auto procedure = builtInProcedure(name);
    if (!procedure) continue;
    for (MetricMeaning& meaning : metricMeanings(*procedure))
      byProcedure_[name].emplace(meaning.id, std::move(meaning));
    for (const MetricNorm& norm : procedure->norms)
      sources_[name].emplace(std::string(definitionOf(norm.metric).id), norm.source);
  }
  const auto hasNorm = [this](const MetricMeaning& meaning) {
    return std::ranges::any_of(byProcedure_,
                               [&](const auto& one) { return one.second.at(meaning.id).expert.has_value(); });
  };
  const auto rest = std::stable_partition(all_.begin(), all_.end(), hasNorm);
  MetricMeaning points;
  points.id = kPoints, points.better = MetricMeaning::Better::Higher;
  points.kind = ValueKind::Percent;
  points.title = "Points";
  comparableCount_ = std::size_t(rest - all_.begin()) + 1;
  all_.insert(all_.begin(), std::move(points));
}

const MetricCatalog& MetricCatalog::instance() {
  static const MetricCatalog book;
  return book;
}

const MetricMeaning& MetricCatalog::withNormsOf(const std::string& procedure, const MetricMeaning& meaning) const {
  const auto known = byProcedure_.find(procedure);
  if (known == byProcedure_.end()) return meaning;
  const auto found = known->second.find(meaning.id);
  return found == known->second.end() ? meaning : found->second;
}

std::vector<MetricExplanation> MetricCatalog::explanationOf(const std::string& procedure,
                                                            const MetricMeaning& meaning) const {
  const auto metric = std::ranges::find(metricTable(), meaning.id, &MetricDefinition::id);
  if (metric == metricTable().end()) return {};
  const auto sources = sources_.find(procedure);
  if (sources == sources_.end()) return insonate::explanationOf(*metric, {});
  const auto source = sources->second.find(meaning.id);
  return insonate::explanationOf(*metric, source == sources->second.end() ? std::string() : source->second);
}

std::optional<double> valueIn(const AttemptFacts& attempt, const MetricMeaning& meaning) {
  return meaning.id == kPoints ? pointsOf(attempt) : valueOf(attempt, meaning.id, meaning.version);
}

std::optional<double> shareIn(const AttemptFacts& attempt, const MetricMeaning& meaning) {
  if (meaning.id == kPoints) return pointsOf(attempt);
  const auto value = valueIn(attempt, meaning);
  return value ? MetricCatalog::instance().withNormsOf(attempt.procedure, meaning).positionBetweenNorms(*value)
               : std::nullopt;
}

}  // namespace insonate
