#include "ManifestJson.h"

#include "LabelNames.h"

#include <insonate/core/JsonEntry.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace insonate {
namespace {

using nlohmann::json;

json toJson(Vec3 v) {
  return {v.x, v.y, v.z};
}

json labelToJson(std::uint8_t label) {
  return label < kLabelCount ? json(labelTable()[label].name) : json(label);
}

json toJson(const Target& target) {
  return {{"name", target.name}, {"label", labelToJson(target.label)}, {"position_mm", toJson(target.position_mm)}};
}

json toJson(const NamedVessel& vessel) {
  json course = json::array();
  for (const NamedVessel::Point& point : vessel.course) {
    json entry = toJson(point.position_mm);
    entry.push_back(point.radius_mm);
    course.push_back(std::move(entry));
  }
  json object{{"name", vessel.name}, {"label", labelToJson(vessel.label)}, {"course_mm", course}};
  for (const Vec3& click_mm : vessel.clicks_mm) object["clicks_mm"].push_back(toJson(click_mm));
  return object;
}

/// All entries of each label.
json structuresOf(const CaseManifest& m) {
  std::map<std::uint8_t, json> structures;
  for (const auto& [label, how] : m.shown)
    structures[label].update({{"opacity", how.opacity}, {"visible", how.visible}});
  for (const auto& [label, own] : m.ownLabels)
    structures[label].update({{"name", own.name}, {"tissue", labelTable()[own.tissue].name}});
  for (const auto& [label, state] : m.states) structures[label]["state"] = nameOf(state);
  json list = json::array();
  for (auto& [label, said] : structures) {
    said["label"] = labelToJson(label);
    list.push_back(std::move(said));
  }
  return list;
}

json toJson(const StartPose& pose) {
  return {{"name", pose.name},
          {"position_mm", toJson(pose.position_mm)},
          {"axial", toJson(pose.axial)},
          {"lateral", toJson(pose.lateral)}};
}

json toJson(const Landmark& landmark) {
  return {{"code", landmark.code}, {"name", landmark.name}, {"position_mm", toJson(landmark.position_mm)}};
}

json toJson(const CaseVersion& version) {
  return {{"number", version.number},
          {"content", version.content},
          {"voxels", version.voxels},
          {"date", version.date},
          {"author", version.author}};
}

/// Distance from the origin that no scanner reaches.
constexpr double kFarthest_mm = 1e6;

/// Entry of a list of case.json. Fields that are not known here are ignored, since newer programs may write them.
class Entry : public JsonEntry {
 public:
  Entry(const json& object, const std::string& where, std::string& error)
      : JsonEntry(object, where, jsonKeys(object), error) {}

  Vec3 vector(std::string_view key) {
    const auto three = numbers(key, 3, -kFarthest_mm, kFarthest_mm, "[x, y, z]");
    return {three[0], three[1], three[2]};
  }
  /// Returns the label under "label": a name, also of another program, or a number.
  std::uint8_t label() {
    const json& given = value("label");
    if (given.is_string())
      if (const auto known = labelFromAnyName(given.get<std::string>())) return *known;
    if (given.is_number_integer() && given >= 1 && given <= 255) return given;
    setError("needs the name or number (1 to 255) of a label as 'label'.");
    return 0;
  }
};

Target targetFrom(const json& object, const std::string& where, std::string& error) {
  Entry entry(object, where, error);
  return {entry.text("name", false), entry.label(), entry.vector("position_mm")};
}

Landmark landmarkFrom(const json& object, const std::string& where, std::string& error) {
  Entry entry(object, where, error);
  return {entry.text("code", false), entry.text("name", false), entry.vector("position_mm")};
}

NamedVessel::Point pointFrom(const json& list, const std::string& where, std::string& error) {
  const bool numbers = list.is_array() && list.size() == 4 &&
                       std::ranges::all_of(list, [](const json& value) { return value.is_number(); });
  if (numbers) {
    const NamedVessel::Point point{{list[0], list[1], list[2]}, list[3]};
    if (isFinite(point.position_mm) && point.radius_mm >= 0 && point.radius_mm <= 100) return point;
  }
  error = where + " needs [x, y, z, radius] in mm, with a radius from 0 to 100.";
  return {};
}

Vec3 clickFrom(const json& list, const std::string& where, std::string& error) {
  const bool numbers = list.is_array() && list.size() == 3 &&
                       std::ranges::all_of(list, [](const json& value) { return value.is_number(); });
  if (const Vec3 click_mm = numbers ? Vec3{list[0], list[1], list[2]} : Vec3{}; numbers && isFinite(click_mm))
    return click_mm;
  error = where + " needs [x, y, z] in mm.";
  return {};
}

NamedVessel vesselFrom(const json& object, const std::string& where, std::string& error) {
  Entry entry(object, where, error);
  NamedVessel vessel{entry.text("name"), entry.label(), entry.list("course_mm", "point", pointFrom),
                     entry.list("clicks_mm", "click", clickFrom)};
  if (vessel.course.empty()) entry.setError("needs a list of points [x, y, z, radius] as 'course_mm', at least one.");
  return vessel;
}

void readStructure(const json& object, const std::string& where, std::string& error, CaseManifest& m) {
  Entry entry(object, where, error);
  const std::uint8_t label = entry.label();
  if (entry.has("opacity") || entry.has("visible")) {
    SurfaceAppearance& shown = m.shown[label];
    shown.opacity = entry.optionalNumber("opacity", 0, 1).value_or(shown.opacity);
    if (entry.has("visible")) shown.visible = entry.flag("visible");
  }
  if (isOwnLabel(label) && (entry.has("name") || entry.has("tissue"))) {
    const auto tissue = entry.has("tissue") ? labelFromName(entry.text("tissue")) : kSoftTissue;
    if (!tissue || *tissue == kBackground) entry.setError("needs a structure's name as 'tissue', e.g. \"vein\".");
    m.ownLabels[label] = {tidyLabelName(entry.text("name", false)), tissue.value_or(kSoftTissue)};
  }
  constexpr std::array kStates{LabelState::NotStarted, LabelState::InProgress, LabelState::Completed,
                               LabelState::Flagged};
  if (entry.has("state"))
    m.states[label] =
        kStates[entry.word("state", {nameOf(kStates[0]), nameOf(kStates[1]), nameOf(kStates[2]), nameOf(kStates[3])})];
}

StartPose poseFrom(const json& object, const std::string& where, std::string& error, std::vector<std::string>& notes) {
  Entry entry(object, where, error);
  StartPose pose{entry.text("name", false), entry.vector("position_mm"), entry.vector("axial"),
                 entry.vector("lateral")};
  if (norm(pose.axial) < 1e-6) entry.setError("needs a direction as 'axial', not [0, 0, 0].");
  if (!error.empty()) return pose;
  const Vec3 axial = normalized(pose.axial);
  const Vec3 across = pose.lateral - dot(pose.lateral, axial) * axial;
  if (norm(across) < 1e-3 * norm(pose.lateral) || norm(across) < 1e-6) {
    entry.setError("needs a direction as 'lateral' that is not along axial.");
    return pose;
  }
  const Vec3 lateral = normalized(across);
  if (norm(axial - pose.axial) > 1e-3 || norm(lateral - pose.lateral) > 1e-3)
    notes.push_back("The start pose \"" + pose.name +
                    "\" had directions that were not of length 1 or not at right angles; they were straightened.");
  pose.axial = axial;
  pose.lateral = lateral;
  return pose;
}

CaseVersion versionFrom(const json& object, std::string& error) {
  Entry entry(object, "case.json, version,", error);
  CaseVersion version;
  version.number = entry.integer("number", 0, std::numeric_limits<int>::max());
  version.content = entry.text("content", false), version.voxels = entry.text("voxels", false);
  version.date = entry.text("date", false), version.author = entry.text("author", false);
  return version;
}

/// Reads the lists of case.json. Two entries of a list may have one name.
void readLists(JsonEntry& file, CaseManifest& m, std::vector<std::string>& notes) {
  constexpr bool kNamesDiffer = false;
  m.targets = file.list("targets", "target", targetFrom, kNamesDiffer);
  m.vessels = file.list("vessels", "vessel", vesselFrom, kNamesDiffer);
  m.startPoses = file.list(
      "start_poses", "start pose",
      [&](const json& pose, const std::string& where, std::string& error) {
        return poseFrom(pose, where, error, notes);
      },
      kNamesDiffer);
  m.landmarks = file.list("landmarks", "landmark", landmarkFrom, kNamesDiffer);
  file.forEach(
      "structures", "structure",
      [&](const json& structure, const std::string& where, std::string& error) {
        readStructure(structure, where, error, m);
      },
      kNamesDiffer);
}

Result<CaseManifest> manifestFrom(const json& document, std::vector<std::string>& notes) {
  JsonEntry file(document, "case.json", jsonKeys(document));
  if (file.error().empty() && !file.has("schema_version"))
    file.setError("has no \"schema_version\"; add \"schema_version\": " + std::to_string(CaseManifest::kSchemaVersion) +
                  " to it.");
  CaseManifest m;
  m.schemaVersion = file.integer("schema_version", 1, CaseManifest::kSchemaVersion);
  m.title = file.has("title") ? file.text("title", false) : m.title;
  m.description = file.text("description", false), m.source = file.text("source", false);
  m.difficulty = file.text("difficulty", false);
  if (!m.difficulty.empty()) file.word("difficulty", {"easy", "moderate", "hard"});
  m.importNotes = file.texts("import_notes");
  readLists(file, m, notes);
  std::string error = file.error();
  if (file.has("version")) m.version = versionFrom(document["version"], error);
  if (!error.empty()) return fail(error);
  constexpr std::array<std::string_view, 12> kFields{"vessels",      "version",    "schema_version", "title",
                                                     "description",  "difficulty", "source",         "landmarks",
                                                     "import_notes", "targets",    "start_poses",    "structures"};
  for (const std::string_view key : jsonKeys(document))
    if (std::ranges::find(kFields, key) == kFields.end())
      notes.push_back("case.json has a field \"" + std::string(key) +
                      "\" that Insonate does not know; it was ignored.");
  return m;
}

}  // namespace

std::string manifestToJson(const CaseManifest& m) {
  json vessels = json::array(), targets = json::array(), poses = json::array(), landmarks = json::array();
  for (const Target& t : m.targets) targets.push_back(toJson(t));
  for (const NamedVessel& v : m.vessels) vessels.push_back(toJson(v));
  for (const StartPose& p : m.startPoses) poses.push_back(toJson(p));
  for (const Landmark& l : m.landmarks) landmarks.push_back(toJson(l));
  const json document{{"schema_version", CaseManifest::kSchemaVersion},
                      {"title", m.title},
                      {"description", m.description},
                      {"difficulty", m.difficulty},
                      {"source", m.source},
                      {"import_notes", m.importNotes},
                      {"targets", targets},
                      {"vessels", vessels},
                      {"start_poses", poses},
                      {"landmarks", landmarks},
                      {"version", toJson(m.version)},
                      {"structures", structuresOf(m)}};
  // Replaces invalid UTF-8, since texts of other programs must not make writing throw.
  return document.dump(2, ' ', false, json::error_handler_t::replace) + "\n";
}

Result<CaseManifest> manifestFromJson(const std::string& text, std::vector<std::string>& notes) {
  const auto document = parsedJson(text, "case.json");
  if (!document) return tl::unexpected(document.error());
  const json schema = document->is_object() ? document->value("schema_version", json()) : json();
  if (schema.is_number_integer() && schema > CaseManifest::kSchemaVersion)
    return fail("case.json has schema version " + schema.dump() + ", but this program can read versions up to " +
                std::to_string(CaseManifest::kSchemaVersion) + ". Use a newer version of the program.");
  return manifestFrom(*document, notes);
}

}  // namespace insonate
