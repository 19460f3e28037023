#include "LevelOrder.h"
#include "PlainName.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/curriculum/Curriculum.h>
#include <insonate/curriculum/CurriculumDraft.h>
#include <insonate/embedded/curricula.h>

#include <nlohmann/json.hpp>

#include <limits>

namespace insonate {
namespace {

using nlohmann::json;

constexpr std::size_t kMaxLevels = 200;

/// In the order of Assistance.
const std::vector<std::string_view> kAssistances{"guided", "hints", "test"};

/// Reads a whole curriculum, which must be complete, or a draft, in which missing entries stay empty.
class Reader {
 public:
  explicit Reader(bool isWhole) : isWhole_(isWhole) {}

  Curriculum curriculum(JsonEntry& file) const;

 private:
  Level level(const json& object, const std::string& where, std::string& error) const;
  PassRule pass(const json& object, const std::string& where, std::string& error) const;
  MetricStandard standard(const json& object, const std::string& where, std::string& error) const;
  MasteryRule mastery(const json& object, const std::string& where, std::string& error) const;
  CusumRule cusum(const json& object, const std::string& where, std::string& error) const;
  FailureRule failures(const json& object, const std::string& where, std::string& error) const;

  const bool isWhole_;
};

MetricStandard Reader::standard(const json& object, const std::string& where, std::string& error) const {
  constexpr double kAny = std::numeric_limits<float>::max();
  JsonEntry entry(object, where, {"metric", "version", "least", "most", "otherwise", "source", "critical"}, error);
  MetricStandard standard;
  standard.metric = entry.text("metric");
  standard.version = entry.optionalInteger("version", 1, 1'000'000).value_or(1);
  standard.minimum = entry.optionalNumber("least", -kAny, kAny),
  standard.maximum = entry.optionalNumber("most", -kAny, kAny);
  if (standard.minimum.has_value() == standard.maximum.has_value()) entry.setError("needs one of 'least' and 'most'.");
  standard.otherwise = entry.text("otherwise", isWhole_), standard.source = entry.text("source", false);
  standard.critical = entry.flag("critical");
  return standard;
}

PassRule Reader::pass(const json& object, const std::string& where, std::string& error) const {
  JsonEntry entry(object, where + ", pass,", {"leastPoints", "standards", "mastery_percent"}, error);
  PassRule rule;
  rule.minPoints = entry.optionalNumber("leastPoints", 0, 100);
  rule.mastery_percent = entry.optionalNumber("mastery_percent", 1, 100).value_or(100);
  rule.standards = entry.list("standards", where + ", standard", [this](const auto& one, const auto& at, auto& wrong) {
    return standard(one, at, wrong);
  });
  return rule;
}

CusumRule Reader::cusum(const json& object, const std::string& where, std::string& error) const {
  JsonEntry entry(object, where + ", cusum,", {"acceptable", "unacceptable", "limit"}, error);
  CusumRule rule{entry.number("acceptable", 0.001, 0.999), entry.number("unacceptable", 0.001, 0.999),
                 entry.number("limit", 0.01, 100)};
  if (isWhole_ && entry.error().empty() && rule.acceptable >= rule.unacceptable)
    entry.setError("needs a rate of failure as 'acceptable' that is below the 'unacceptable' one.");
  return rule;
}

FailureRule Reader::failures(const json& object, const std::string& where, std::string& error) const {
  JsonEntry entry(object, where + ", lapsesAfter,", {"failures", "within"}, error);
  FailureRule rule{entry.integer("failures", 1, 1000), entry.integer("within", 1, 1000)};
  if (isWhole_ && entry.error().empty() && rule.failures > rule.within)
    entry.setError("asks for more 'failures' than there are attempts in 'within'; it would never lapse.");
  return rule;
}

MasteryRule Reader::mastery(const json& object, const std::string& where, std::string& error) const {
  JsonEntry entry(object, where + ", mastery,", {"passesInARow", "cusum", "lapsesAfter_days", "lapsesAfter", "source"},
                  error);
  MasteryRule rule;
  rule.consecutivePasses = entry.integer("passesInARow", 1, 100);
  rule.lapsesAfter_days = entry.optionalInteger("lapsesAfter_days", 1, 36'500);
  rule.source = entry.text("source", false);
  if (entry.has("cusum")) rule.cusum = cusum(entry.value("cusum"), where, error);
  if (entry.has("lapsesAfter")) rule.lapsesAfter = failures(entry.value("lapsesAfter"), where, error);
  return rule;
}

Level Reader::level(const json& object, const std::string& where, std::string& error) const {
  JsonEntry entry(
      object, where,
      {"name", "title", "about", "case", "procedure", "position", "assistance", "prerequisites", "pass", "mastery"},
      error);
  Level level;
  level.name = entry.text("name"), level.title = entry.text("title", isWhole_);
  level.about = entry.text("about", isWhole_);
  level.caseName = entry.text("case", isWhole_), level.procedure = entry.text("procedure", isWhole_);
  level.position = entry.text("position", false);
  level.assistance = static_cast<Assistance>(entry.word("assistance", kAssistances));
  level.prerequisites = entry.texts("prerequisites");
  if (!level.name.empty() && !isPlainName(level.name)) entry.setError(kPlainNameSentence);
  level.pass = pass(entry.value("pass"), where, error);
  level.mastery = mastery(entry.value("mastery"), where, error);
  return level;
}

Curriculum Reader::curriculum(JsonEntry& file) const {
  Curriculum curriculum;
  curriculum.name = file.text("name"), curriculum.title = file.text("title", isWhole_);
  curriculum.about = file.text("about", false);
  curriculum.version = file.integer("version", 1, 1'000'000);
  if (!curriculum.name.empty() && !isPlainName(curriculum.name)) file.setError(kPlainNameSentence);
  curriculum.levels = file.list("levels", "level",
                                [this](const auto& one, const auto& at, auto& wrong) { return level(one, at, wrong); });
  if (curriculum.levels.size() > kMaxLevels)
    file.setError("has " + std::to_string(curriculum.levels.size()) + " levels; " + std::to_string(kMaxLevels) +
                  " is the maximum.");
  if (isWhole_ && curriculum.levels.empty()) file.setError("has no levels; list at least one under 'levels'.");
  return curriculum;
}

/// With levels as they are written.
Result<Curriculum> read(std::string_view text, bool isWhole) {
  const auto object = parsedJson(text, "The curriculum");
  if (!object) return tl::unexpected(object.error());
  JsonEntry file(*object, "The curriculum", {"name", "title", "about", "version", "levels"});
  Curriculum curriculum = Reader(isWhole).curriculum(file);
  if (!file.error().empty()) return fail(file.error());
  return curriculum;
}

template <class T>
void put(nlohmann::ordered_json& object, const char* key, const std::optional<T>& value) {
  if (value) object[key] = *value;
}

void put(nlohmann::ordered_json& object, const char* key, const std::string& value) {
  if (!value.empty()) object[key] = value;
}

nlohmann::ordered_json written(const PassRule& rule) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  put(object, "leastPoints", rule.minPoints);
  object["mastery_percent"] = rule.mastery_percent;
  object["standards"] = nlohmann::ordered_json::array();
  for (const MetricStandard& standard : rule.standards) {
    nlohmann::ordered_json entry{{"metric", standard.metric}, {"version", standard.version}};
    put(entry, "least", standard.minimum), put(entry, "most", standard.maximum);
    put(entry, "otherwise", standard.otherwise), put(entry, "source", standard.source);
    if (standard.critical) entry["critical"] = true;
    object["standards"].push_back(std::move(entry));
  }
  return object;
}

nlohmann::ordered_json written(const MasteryRule& rule) {
  nlohmann::ordered_json object{{"passesInARow", rule.consecutivePasses}};
  if (const auto& cusum = rule.cusum)
    object["cusum"] = {
        {"acceptable", cusum->acceptable}, {"unacceptable", cusum->unacceptable}, {"limit", cusum->limit}};
  put(object, "lapsesAfter_days", rule.lapsesAfter_days);
  if (const auto& lapse = rule.lapsesAfter)
    object["lapsesAfter"] = {{"failures", lapse->failures}, {"within", lapse->within}};
  put(object, "source", rule.source);
  return object;
}

nlohmann::ordered_json written(const Level& level) {
  nlohmann::ordered_json object{{"name", level.name}};
  put(object, "title", level.title), put(object, "about", level.about);
  put(object, "case", level.caseName), put(object, "procedure", level.procedure);
  put(object, "position", level.position);
  object["assistance"] = nameOf(level.assistance);
  object["prerequisites"] = level.prerequisites;
  object["pass"] = written(level.pass), object["mastery"] = written(level.mastery);
  return object;
}

}  // namespace

std::vector<std::string> curriculumPresetNames() {
  return presetNames(embeddedPresets(embedded::curricula::files()));
}

Result<Curriculum> parseCurriculum(std::string_view text) {
  auto curriculum = read(text, true);
  if (!curriculum) return curriculum;
  auto ordered = inOrderOfLearning(std::move(curriculum->levels));
  if (!ordered) return fail("The curriculum cannot be used: " + ordered.error().message);
  curriculum->levels = std::move(*ordered);
  return curriculum;
}

Result<Curriculum> parseDraft(std::string_view text) {
  return read(text, false);
}

Result<Curriculum> loadCurriculum(std::string_view nameOrPath) {
  return presetOrFile("a curriculum", nameOrPath, embeddedPresets(embedded::curricula::files()), parseCurriculum);
}

std::string_view nameOf(Assistance assistance) {
  return kAssistances[static_cast<std::size_t>(assistance)];
}

std::string curriculumText(const Curriculum& curriculum) {
  nlohmann::ordered_json object{{"name", curriculum.name}};
  put(object, "title", curriculum.title), put(object, "about", curriculum.about);
  object["version"] = curriculum.version;
  object["levels"] = nlohmann::ordered_json::array();
  for (const Level& level : curriculum.levels) object["levels"].push_back(written(level));
  return object.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace insonate
