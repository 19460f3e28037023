#include <insonate/cases/Phantom.h>
#include <insonate/procedure/AttemptMetrics.h>
#include <insonate/procedure/MetricTitle.h>
#include <insonate/teaching/TeachingHere.h>

#include <algorithm>

namespace insonate {
namespace {

/// Capitalizes a title: "Artery punctures".
std::string titleOf(const MetricDefinition& metric) {
  std::string title(metricTitle(metric.metric));
  title.front() = static_cast<char>(title.front() - 'a' + 'A');
  return title;
}

MetricMeaning::Better betterOf(const MetricDefinition& metric) {
  switch (metric.better) {
    case Better::Lower:
      return MetricMeaning::Better::Lower;
    case Better::Higher:
      return MetricMeaning::Better::Higher;
    case Better::Neither:
      break;
  }
  return MetricMeaning::Better::Neither;
}

ValueKind kindOf(const MetricDefinition& metric) {
  switch (metric.metric) {
    case Metric::TipInVein:
      return ValueKind::YesNo;
    case Metric::NearestArtery:  // negative inside
    case Metric::NearestLung:
      return ValueKind::Any;
    case Metric::NeedleInefficiency:  // a path can be more than twice as long as necessary
      return ValueKind::NotNegative;
    default:
      break;
  }
  if (metric.unit.empty()) return ValueKind::Count;
  return metric.unit == "%" ? ValueKind::Percent : ValueKind::NotNegative;
}

}  // namespace

std::vector<MetricMeaning> metricMeanings() {
  std::vector<MetricMeaning> meanings;
  for (const MetricDefinition& metric : metricTable()) {
    MetricMeaning meaning;
    meaning.id = metric.id, meaning.version = metric.version;
    meaning.title = titleOf(metric), meaning.unit = metric.unit;
    meaning.better = betterOf(metric), meaning.kind = kindOf(metric);
    meanings.push_back(std::move(meaning));
  }
  return meanings;
}

std::vector<MetricMeaning> metricMeanings(const Procedure& procedure) {
  std::vector<MetricMeaning> meanings = metricMeanings();
  for (const MetricNorm& norm : procedure.norms) {
    MetricMeaning& meaning = meanings[static_cast<std::size_t>(norm.metric)];
    meaning.novice = norm.novice, meaning.expert = norm.expert;
  }
  return meanings;
}

Result<TeachingNames> teachingNames(const std::vector<std::string>& caseTitles) {
  TeachingNames names;
  for (const PhantomVariant& variant : phantomVariants()) names.cases.emplace_back(variant.name);
  names.cases.insert(names.cases.end(), caseTitles.begin(), caseTitles.end());
  for (const std::string& name : procedurePresetNames()) {
    const auto procedure = builtInProcedure(name);
    if (!procedure) return tl::unexpected(procedure.error());
    TeachingNames::Procedure known{name, {}};
    for (const PatientPosition& position : procedure->positions) known.positions.push_back(position.name);
    names.procedures.push_back(std::move(known));
  }
  names.metrics = metricMeanings();
  return names;
}

}  // namespace insonate
