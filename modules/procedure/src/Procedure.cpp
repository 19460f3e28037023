#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>
#include <insonate/embedded/procedures.h>
#include <insonate/procedure/Procedure.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <limits>
#include <set>

namespace insonate {
namespace {

using nlohmann::json;

/// In the order of StateCondition::What and Severity.
const std::vector<std::string_view> kHoldings{
    "probe on skin",          "aspirating in vein", "performed",       "syringe off",        "wire seen in short axis",
    "wire seen in long axis", "lumens flushed",     "needle off wire", "skin nicked",        "dilator removed",
    "veins surveyed",         "wire in target",     "vessel dilated",  "catheter in target", "catheter without wire"};
const std::vector<std::string_view> kSeverities{"minor", "major", "critical"};

std::vector<std::string_view> labelNames() {
  std::vector<std::string_view> names;
  for (const LabelInfo& info : labelTable()) names.push_back(info.name);
  return names;
}

std::vector<std::string_view> kindNames() {
  return {attemptEventNames().begin(), attemptEventNames().end()};
}

std::vector<std::string_view> actNames() {
  return {lineActNames().begin(), lineActNames().end()};
}

std::vector<std::string_view> metricNames() {
  std::vector<std::string_view> names;
  for (const MetricDefinition& metric : metricTable()) names.push_back(metric.id);
  return names;
}

PatientPosition readPosition(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"name", "tilt_deg"}, error);
  PatientPosition position{entry.text("name"), entry.number("tilt_deg", -45, 45)};
  return position;
}

NeededStructure readNeed(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"label", "why"}, error);
  const auto label = static_cast<Label>(entry.word("label", labelNames()));
  NeededStructure need{label, entry.text("why")};
  return need;
}

std::variant<EventCondition, StateCondition> readUntil(const json& object, const std::string& where,
                                                       std::string& error) {
  JsonEntry entry(object, where + ", until,",
                  {"happens", "wall", "act", "instrument", "holds", "for_s", "veins", "wire_mm"}, error);
  std::variant<EventCondition, StateCondition> until;
  if (entry.has("happens") == entry.has("holds")) {
    entry.setError("needs one of 'happens' and 'holds'.");
  } else if (entry.has("holds")) {
    for (const char* key : {"wall", "instrument"})
      if (entry.has(key)) entry.setError("has a '" + std::string(key) + "', which goes with 'happens'.");
    StateCondition holding;
    holding.what = static_cast<StateCondition::What>(entry.word("holds", kHoldings));
    holding.for_s = entry.number("for_s", 0, 600);
    if (holding.what == StateCondition::What::Performed)
      holding.act = static_cast<LineAct>(entry.word("act", actNames()));
    const bool isSurvey = holding.what == StateCondition::What::VeinsSurveyed;
    if (isSurvey) holding.veins = entry.integer("veins", 1, 20);
    if (!isSurvey && entry.has("veins")) entry.setError("has 'veins', which goes with 'veins surveyed'.");
    const bool isWire = holding.what == StateCondition::What::WireInTarget;
    if (isWire) holding.wire_mm = entry.number("wire_mm", 0, 700);
    if (!isWire && entry.has("wire_mm")) entry.setError("has 'wire_mm', which goes with 'wire in target'.");
    until = holding;
  } else {
    for (const char* key : {"for_s", "veins", "wire_mm"})
      if (entry.has(key)) entry.setError("has '" + std::string(key) + "', which goes with 'holds'.");
    EventCondition happening;
    happening.kind = static_cast<AttemptEventKind>(entry.word("happens", kindNames()));
    if (entry.has("wall")) happening.wall = static_cast<Label>(entry.word("wall", labelNames()));
    if (entry.has("act")) happening.act = static_cast<LineAct>(entry.word("act", actNames()));
    if (entry.has("instrument"))
      happening.instrument =
          static_cast<Instrument>(entry.word("instrument", {instrumentNames().begin(), instrumentNames().end()}));
    until = happening;
  }
  return until;
}

ProcedureStep readStep(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"name", "title", "say", "optional", "until"}, error);
  ProcedureStep step;
  step.name = entry.text("name"), step.title = entry.text("title"), step.instruction = entry.text("say");
  step.optional = entry.flag("optional");
  step.until = readUntil(entry.value("until"), where, error);
  return step;
}

MetricLimit limitOf(JsonEntry& entry) {
  constexpr double kAny = std::numeric_limits<float>::max();
  MetricLimit limit;
  limit.metric = static_cast<Metric>(entry.word("metric", metricNames()));
  limit.over = entry.optionalNumber("over", -kAny, kAny), limit.under = entry.optionalNumber("under", -kAny, kAny);
  if (limit.over.has_value() == limit.under.has_value()) entry.setError("needs one of 'over' and 'under'.");
  return limit;
}

ProcedureRule readRule(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"name", "metric", "over", "under", "severity", "say", "advice"}, error);
  ProcedureRule rule;
  rule.name = entry.text("name"), rule.text = entry.text("say"), rule.advice = entry.text("advice", false);
  rule.limit = limitOf(entry);
  rule.severity = static_cast<Severity>(entry.word("severity", kSeverities));
  return rule;
}

MetricLimit readSuccess(const json& object, const std::string& where, std::string& error) {
  JsonEntry entry(object, where, {"metric", "over", "under"}, error);
  const MetricLimit limit = limitOf(entry);
  return limit;
}

MetricNorm readNorm(const json& object, const std::string& where, std::string& error) {
  constexpr double kAny = std::numeric_limits<float>::max();
  JsonEntry entry(object, where, {"metric", "novice", "expert", "source", "advice"}, error);
  MetricNorm norm;
  norm.metric = static_cast<Metric>(entry.word("metric", metricNames()));
  norm.novice = entry.number("novice", -kAny, kAny), norm.expert = entry.number("expert", -kAny, kAny);
  norm.source = entry.text("source"), norm.advice = entry.text("advice");
  const Better better = definitionOf(norm.metric).better;
  if (better == Better::Neither)
    entry.setError("is of a metric without a better direction; leave it out.");
  else if (better == Better::Lower ? norm.expert >= norm.novice : norm.expert <= norm.novice)
    entry.setError("has an 'expert' that is no better than the 'novice'.");
  return norm;
}

Procedure readProcedure(const json& object, std::string& error) {
  JsonEntry file(object, "The procedure",
                 {"name", "title", "version", "description", "needs", "target", "positions", "steps", "passBegins",
                  "rules", "success", "norms"},
                 error);
  Procedure procedure;
  procedure.name = file.text("name"), procedure.title = file.text("title");
  file.text("description", false);
  procedure.version = static_cast<int>(file.number("version", 1, 1e6));
  procedure.target = file.text("target", false);
  procedure.needs = file.list("needs", "need", readNeed);
  procedure.positions = file.list("positions", "position", readPosition);
  procedure.steps = file.list("steps", "step", readStep);
  procedure.rules = file.list("rules", "rule", readRule);
  procedure.success = file.list("success", "condition of success", readSuccess);
  procedure.norms = file.list("norms", "norm", readNorm);
  std::set<Metric> normed;
  for (const MetricNorm& norm : procedure.norms)
    if (!normed.insert(norm.metric).second)
      file.setError("cannot be used: '" + std::string(definitionOf(norm.metric).id) + "' has two norms.");
  if (procedure.steps.empty()) file.setError("has no steps; list at least one under 'steps'.");
  std::vector<std::string_view> steps;
  for (const ProcedureStep& step : procedure.steps) steps.push_back(step.name);
  procedure.passBegins = file.word("passBegins", steps);
  return procedure;
}

}  // namespace

bool hasLine(const Procedure& procedure) {
  return std::ranges::any_of(procedure.success, [](const MetricLimit& limit) { return isOfLine(limit.metric); });
}

std::vector<std::string> procedurePresetNames() {
  return presetNames(embeddedPresets(embedded::procedures::files()));
}

Result<Procedure> parseProcedure(std::string_view text) {
  const auto file = parsedJson(text, "The procedure");
  if (!file) return tl::unexpected(file.error());
  std::string error;
  Procedure procedure = readProcedure(*file, error);
  if (!error.empty()) return fail(std::move(error));
  return procedure;
}

Result<Procedure> builtInProcedure(std::string_view name) {
  const std::vector<Preset> presets = embeddedPresets(embedded::procedures::files());
  const auto found = std::ranges::find(presets, name, &Preset::name);
  if (found != presets.end()) return parseProcedure(found->text);
  std::vector<std::string_view> names;
  for (const Preset& preset : presets) names.push_back(preset.name);
  const std::string_view near = nearestWord(name, names);
  return fail("'" + std::string(name) + "' is not a built-in procedure (" + joinedWords(names) + ")" +
              (near.empty() ? "." : "; did you mean '" + std::string(near) + "'?"));
}

Result<Procedure> loadProcedure(std::string_view nameOrPath) {
  return presetOrFile("a procedure", nameOrPath, embeddedPresets(embedded::procedures::files()), parseProcedure);
}

}  // namespace insonate
