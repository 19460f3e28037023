#include "LabelPlan.h"

#include <insonate/core/Words.h>

#include <nlohmann/json.hpp>

#include <charconv>
#include <fstream>
#include <initializer_list>
#include <stdexcept>

namespace insonate {
namespace {

using Json = nlohmann::json;

/// Carries a sentence to readLabelPlan, which converts it to an error with the name of the file.
struct BadEntry : std::runtime_error {
  using std::runtime_error::runtime_error;
};

void allowOnly(const Json& object, const std::string& where, std::initializer_list<const char*> known) {
  if (!object.is_object()) throw BadEntry(where + " is not an object.");
  std::string names;
  for (const char* name : known) names += (names.empty() ? "" : ", ") + std::string(name);
  for (const auto& [key, value] : object.items()) {
    bool found = false;
    for (const char* name : known) found = found || key == name;
    if (!found) throw BadEntry(where + " has an unknown entry '" + key + "'; known are " + names + ".");
  }
}

const Json& needed(const Json& object, const std::string& where, const char* key) {
  if (!object.contains(key)) throw BadEntry(where + " lacks '" + key + "'.");
  return object.at(key);
}

double number(const Json& value, const std::string& where, double low, double high) {
  if (value.is_number()) {
    const double x = value.get<double>();
    if (x >= low && x <= high) return x;
  }
  throw BadEntry(where + " must be a number from " + std::to_string(low) + " to " + std::to_string(high) + ", not " +
                 value.dump() + ".");
}

Vec3 position(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 3) throw BadEntry(where + " must be three numbers [x, y, z].");
  return {number(value[0], where, -1e5, 1e5), number(value[1], where, -1e5, 1e5), number(value[2], where, -1e5, 1e5)};
}

Label label(const Json& value, const std::string& where) {
  if (value.is_number_integer() && value.get<long>() >= 0 && value.get<long>() < kLabelCount)
    return static_cast<Label>(value.get<int>());
  if (value.is_string())
    if (const auto known = labelFromName(value.get<std::string>())) return *known;
  std::string names;
  for (const LabelInfo& info : labelTable()) names += (names.empty() ? "" : ", ") + std::string(info.name);
  throw BadEntry(where + " is " + value.dump() + ", which is no label. Use a number from 0 to " +
                 std::to_string(kLabelCount - 1) + " or one of: " + names + ".");
}

std::int32_t sourceNumber(const std::string& key) {
  std::int32_t value = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), value);
  if (error != std::errc() || end != key.data() + key.size())
    throw BadEntry("\"labels\" has the key '" + key + "'; keys are the numbers of the label file.");
  return value;
}

TubePlan tube(const Json& json) {
  const std::string where = "A tube";
  allowOnly(json, where, {"label", "points_mm", "radius_mm", "wall", "wall_mm"});
  TubePlan plan;
  plan.label = label(needed(json, where, "label"), "A tube's label");
  if (json.contains("wall")) plan.wall = label(json["wall"], "A tube's wall");
  if (json.contains("wall_mm")) plan.wall_mm = number(json["wall_mm"], "A tube's wall_mm", 0, 20);
  const Json& points = needed(json, where, "points_mm");
  const Json& radius = needed(json, where, "radius_mm");
  if (!points.is_array() || points.size() < 2) throw BadEntry("A tube needs at least two points_mm.");
  if (radius.is_array() && radius.size() != points.size())
    throw BadEntry("A tube has " + std::to_string(points.size()) + " points_mm and " + std::to_string(radius.size()) +
                   " values of radius_mm.");
  for (std::size_t n = 0; n < points.size(); ++n)
    plan.knots.push_back({position(points[n], "A point of a tube"),
                          number(radius.is_array() ? radius[n] : radius, "A tube's radius_mm", 0.1, 100)});
  return plan;
}

CompletionPlan completion(const Json& json) {
  allowOnly(json, "\"complete\"", {"skin_mm", "fat_mm", "margin_mm"});
  CompletionPlan plan;
  if (json.contains("skin_mm")) plan.skin_mm = number(json["skin_mm"], "skin_mm", 0.5, 5);
  if (json.contains("fat_mm")) plan.fat_mm = number(json["fat_mm"], "fat_mm", 0, 60);
  if (json.contains("margin_mm")) plan.margin_mm = number(json["margin_mm"], "margin_mm", 0, 30);
  return plan;
}

TargetPlan target(const Json& json) {
  const std::string where = "A target";
  allowOnly(json, where, {"name", "number", "z_mm"});
  const Json& name = needed(json, where, "name");
  if (!name.is_string()) throw BadEntry("A target's name must be text.");
  return {name.get<std::string>(),
          static_cast<std::int32_t>(number(needed(json, where, "number"), "A target's number", -1e9, 1e9)),
          number(needed(json, where, "z_mm"), "A target's z_mm", -1e5, 1e5)};
}

LabelPlan plan(const Json& json) {
  allowOnly(json, "The file", {"labels", "others", "title", "crop_mm", "tubes", "complete", "targets", "vessels"});
  LabelPlan p;
  const Json& labels = needed(json, "The file", "labels");
  if (!labels.is_object()) throw BadEntry("\"labels\" is not an object.");
  for (const auto& [key, value] : labels.items())
    p.labels[sourceNumber(key)] = label(value, "The entry '" + key + "' of \"labels\"");
  if (json.contains("others")) p.others = label(json["others"], "\"others\"");
  if (json.contains("title")) {
    if (!json["title"].is_string()) throw BadEntry("\"title\" must be text.");
    p.title = json["title"].get<std::string>();
  }
  if (json.contains("crop_mm")) {
    const Json& crop = json["crop_mm"];
    allowOnly(crop, "\"crop_mm\"", {"min", "max"});
    p.crop_mm = {position(needed(crop, "\"crop_mm\"", "min"), "crop_mm min"),
                 position(needed(crop, "\"crop_mm\"", "max"), "crop_mm max")};
  }
  for (const Json& t : json.value("tubes", Json::array())) p.tubes.push_back(tube(t));
  if (json.contains("complete")) p.complete = completion(json["complete"]);
  for (const Json& t : json.value("targets", Json::array())) p.targets.push_back(target(t));
  const Json vessels = json.value("vessels", Json::object());
  if (!vessels.is_object()) throw BadEntry("\"vessels\" is not an object.");
  for (const auto& [key, name] : vessels.items()) {
    if (!name.is_string()) throw BadEntry("The name of the vessel '" + key + "' must be text.");
    const std::int32_t number = sourceNumber(key);
    if (p.labels.count(number) == 0) throw BadEntry("The vessel '" + key + "' is not listed under \"labels\".");
    p.vessels[number] = name.get<std::string>();
  }
  return p;
}

}  // namespace

Result<LabelPlan> readLabelPlan(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    return fail("The label map description '" + file.string() + "' is a folder; name a JSON file.");
  if (!stream) return fail("The label map description '" + file.string() + "' cannot be read.");
  try {
    return plan(Json::parse(stream));
  } catch (const Json::exception& e) {
    return fail("The label map description '" + file.string() + "' is not valid JSON: " + jsonProblem(e.what()) + ".");
  } catch (const BadEntry& e) {
    return fail("The label map description '" + file.string() + "': " + e.what());
  }
}

}  // namespace insonate
