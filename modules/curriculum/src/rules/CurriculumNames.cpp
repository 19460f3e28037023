#include <insonate/core/Words.h>
#include <insonate/curriculum/Curriculum.h>

#include <algorithm>

namespace insonate {
namespace {

std::vector<std::string_view> views(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

tl::unexpected<Error> unknown(const Level& level, const std::string& what, const std::string& name,
                              const std::vector<std::string_view>& known) {
  const std::string_view near = nearestWord(name, known);
  return fail(
      "level '" + level.name + "' names the unknown " + what + " '" + name + "'" +
      (near.empty() ? "; known names are " + quotedWords(known) + "." : "; did you mean '" + std::string(near) + "'?"));
}

Result<void> checkStandard(const Level& level, const MetricStandard& standard,
                           const std::vector<MetricMeaning>& metrics) {
  using enum MetricMeaning::Better;
  const auto metric = std::ranges::find(metrics, standard.metric, &MetricMeaning::id);
  if (metric == metrics.end()) {
    std::vector<std::string_view> ids;
    for (const MetricMeaning& m : metrics) ids.push_back(m.id);
    return unknown(level, "metric", standard.metric, ids);
  }
  const std::string where = "level '" + level.name + "', standard of '" + standard.metric + "', ";
  if (metric->version != standard.version)
    return fail(where + "is of version " + std::to_string(standard.version) + " of the metric's definition; it is " +
                std::to_string(metric->version) +
                " now. Check whether the limit is still right, and enter the present version.");
  if (metric->better == Lower && standard.minimum)
    return fail(where + "asks for a 'least' value where less is better; use 'most'.");
  if (metric->better == Higher && standard.maximum)
    return fail(where + "asks for a 'most' value where more is better; use 'least'.");
  return {};
}

Result<void> checkLevel(const Level& level, const TeachingNames& known) {
  if (std::ranges::find(known.cases, level.caseName) == known.cases.end())
    return unknown(level, "case", level.caseName, views(known.cases));
  const auto procedure = std::ranges::find(known.procedures, level.procedure, &TeachingNames::Procedure::name);
  if (procedure == known.procedures.end()) {
    std::vector<std::string_view> names;
    for (const TeachingNames::Procedure& p : known.procedures) names.push_back(p.name);
    return unknown(level, "procedure", level.procedure, names);
  }
  const auto& positions = procedure->positions;
  if (!level.position.empty() && std::ranges::find(positions, level.position) == positions.end())
    return unknown(level, "position", level.position, views(positions));
  for (const MetricStandard& standard : level.pass.standards)
    if (auto fine = checkStandard(level, standard, known.metrics); !fine) return fine;
  return {};
}

}  // namespace

const Level* Curriculum::level(std::string_view levelName) const {
  const auto found = std::ranges::find(levels, levelName, &Level::name);
  return found == levels.end() ? nullptr : &*found;
}

Result<void> checkNames(const Curriculum& curriculum, const TeachingNames& known) {
  for (const Level& level : curriculum.levels)
    if (auto fine = checkLevel(level, known); !fine)
      return fail("The curriculum cannot be used here: " + fine.error().message);
  return {};
}

}  // namespace insonate
