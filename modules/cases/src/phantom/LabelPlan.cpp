#include "LabelPlan.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>

#include <nlohmann/json.hpp>

#include <charconv>

namespace insonate {
namespace {

using Json = nlohmann::json;

constexpr double kFarthest_mm = 1e5;

/// The name or the number of a label.
Label labelIn(JsonEntry& entry, std::string_view key) {
  const Json& value = entry.value(key);
  if (value.is_number()) return static_cast<Label>(entry.integer(key, 0, kLabelCount - 1));
  std::vector<std::string_view> names;
  for (const LabelInfo& info : labelTable()) names.push_back(info.name);
  return static_cast<Label>(entry.word(key, names));
}

Vec3 positionIn(JsonEntry& entry, std::string_view key) {
  const auto p = entry.numbers(key, 3, -kFarthest_mm, kFarthest_mm, "[x, y, z]");
  return {p[0], p[1], p[2]};
}

std::int32_t sourceNumber(JsonEntry& entry, std::string_view key) {
  std::int32_t value = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), value);
  if (error != std::errc() || end != key.data() + key.size())
    entry.setError("has the key '" + std::string(key) + "'; keys are the numbers of the label file.");
  return value;
}

TubePlan readTube(const Json& object, const std::string& where, std::string& trouble) {
  JsonEntry entry(object, where, {"label", "points_mm", "radius_mm", "wall", "wall_mm"}, trouble);
  TubePlan plan;
  plan.label = labelIn(entry, "label");
  if (entry.has("wall")) plan.wall = labelIn(entry, "wall");
  plan.wall_mm = entry.optionalNumber("wall_mm", 0, 20).value_or(plan.wall_mm);
  const Json &points = entry.value("points_mm"), &radii = entry.value("radius_mm");
  if (!points.is_array() || points.size() < 2) entry.setError("needs a list of two or more points as 'points_mm'.");
  const std::size_t count = points.size();
  const std::vector<double> radii_mm = radii.is_array()
                                           ? entry.numbers("radius_mm", count, 0.1, 100, "one for each point")
                                           : std::vector<double>(count, entry.number("radius_mm", 0.1, 100));
  for (std::size_t n = 0; trouble.empty() && n < count; ++n) {
    const Json point{{"point", points[n]}};
    JsonEntry knot(point, where + ", point " + std::to_string(n + 1) + ",", {"point"}, trouble);
    plan.knots.push_back({positionIn(knot, "point"), radii_mm[n]});
  }
  return plan;
}

CompletionPlan readCompletion(const Json& object, std::string& trouble) {
  JsonEntry entry(object, "The entry 'complete'", {"skin_mm", "fat_mm", "margin_mm"}, trouble);
  CompletionPlan plan;
  plan.skin_mm = entry.optionalNumber("skin_mm", 0.5, 5).value_or(plan.skin_mm);
  plan.fat_mm = entry.optionalNumber("fat_mm", 0, 60).value_or(plan.fat_mm);
  plan.margin_mm = entry.optionalNumber("margin_mm", 0, 30).value_or(plan.margin_mm);
  return plan;
}

TargetPlan readTarget(const Json& object, const std::string& where, std::string& trouble) {
  JsonEntry entry(object, where, {"name", "number", "z_mm"}, trouble);
  return {entry.text("name"), entry.integer("number", -1'000'000'000, 1'000'000'000),
          entry.number("z_mm", -kFarthest_mm, kFarthest_mm)};
}

std::pair<Vec3, Vec3> readCrop(const Json& object, std::string& trouble) {
  JsonEntry entry(object, "The entry 'crop_mm'", {"min", "max"}, trouble);
  return {positionIn(entry, "min"), positionIn(entry, "max")};
}

LabelPlan readPlan(const Json& object, std::string& trouble) {
  JsonEntry file(object, "The file",
                 {"labels", "others", "title", "crop_mm", "tubes", "complete", "targets", "vessels"}, trouble);
  LabelPlan plan;
  const Json& numbers = file.value("labels");
  JsonEntry labels(numbers, "The entry 'labels'", jsonKeys(numbers), trouble);
  for (const std::string_view key : jsonKeys(numbers)) plan.labels[sourceNumber(labels, key)] = labelIn(labels, key);
  if (file.has("others")) plan.others = labelIn(file, "others");
  plan.title = file.text("title", false);
  if (file.has("crop_mm")) plan.crop_mm = readCrop(file.value("crop_mm"), trouble);
  plan.tubes = file.list("tubes", "tube", readTube);
  if (file.has("complete")) plan.complete = readCompletion(file.value("complete"), trouble);
  plan.targets = file.list("targets", "target", readTarget, false);
  if (!file.has("vessels")) return plan;
  const Json& names = file.value("vessels");
  JsonEntry vessels(names, "The entry 'vessels'", jsonKeys(names), trouble);
  for (const std::string_view key : jsonKeys(names)) {
    const std::int32_t number = sourceNumber(vessels, key);
    if (!plan.labels.contains(number))
      vessels.setError("has '" + std::string(key) + "', which 'labels' does not list.");
    plan.vessels[number] = vessels.text(key);
  }
  return plan;
}

}  // namespace

Result<LabelPlan> readLabelPlan(const std::filesystem::path& file) {
  const std::string what = "The label map description '" + file.string() + "'";
  const auto text = readTextFile(file);
  if (!text) return fail("The label map description cannot be read: " + text.error().message);
  const auto object = parsedJson(*text, what);
  if (!object) return tl::unexpected(object.error());
  std::string trouble;
  LabelPlan plan = readPlan(*object, trouble);
  if (!trouble.empty()) return fail(what + ": " + trouble);
  return plan;
}

}  // namespace insonate
