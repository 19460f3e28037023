#include "ManifestJson.h"

#include "LabelNames.h"

#include <insonate/core/Words.h>
#include <insonate/tissue/Labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>

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
  return {{"name", vessel.name}, {"label", labelToJson(vessel.label)}, {"course_mm", course}};
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

/// Thrown within this file only: the place in the document, and the expected value.
struct Wrong {
  std::string where, expected;
};
struct Missing {};

std::string textAt(const json& object, const char* key, const std::string& where) {
  if (!object.contains(key)) return {};
  if (!object[key].is_string()) throw Wrong{where + key, "text"};
  return object[key];
}

Vec3 vectorAt(const json& object, const char* key, const std::string& where) {
  const Wrong wrong{where + key, "three numbers"};
  if (!object.contains(key) || !object[key].is_array() || object[key].size() != 3) throw wrong;
  Vec3 v;
  for (int a = 0; a < 3; ++a) {
    if (!object[key][a].is_number()) throw wrong;
    v[a] = object[key][a];
  }
  if (!isFinite(v)) throw wrong;
  return v;
}

std::uint8_t labelAt(const json& object, const std::string& where) {
  const Wrong wrong{where + "label", "the name or number (1 to 255) of a label"};
  if (!object.contains("label")) throw wrong;
  const json& label = object["label"];
  if (label.is_string()) {
    const auto known = labelFromAnyName(label.get<std::string>());
    if (!known) throw wrong;
    return *known;
  }
  if (!label.is_number_integer() || label < 1 || label > 255) throw wrong;
  return label;
}

Target targetFrom(const json& object, const std::string& where) {
  return {textAt(object, "name", where), labelAt(object, where), vectorAt(object, "position_mm", where)};
}

NamedVessel vesselFrom(const json& object, const std::string& where) {
  NamedVessel vessel{textAt(object, "name", where), labelAt(object, where), {}};
  if (vessel.name.empty()) throw Wrong{where + "name", "the vessel's name"};
  const Wrong wrong{where + "course_mm", "a list of [x, y, z, radius], one at least"};
  if (!object.contains("course_mm") || !object["course_mm"].is_array() || object["course_mm"].empty()) throw wrong;
  for (const json& entry : object["course_mm"]) {
    const bool numbers = entry.is_array() && entry.size() == 4 &&
                         std::ranges::all_of(entry, [](const json& value) { return value.is_number(); });
    if (!numbers) throw wrong;
    const NamedVessel::Point point{{entry[0], entry[1], entry[2]}, entry[3]};
    if (!isFinite(point.position_mm) || !(point.radius_mm >= 0 && point.radius_mm <= 100)) throw wrong;
    vessel.course.push_back(point);
  }
  return vessel;
}

StructureShown shownFrom(const json& object, const std::string& where) {
  StructureShown shown;
  if (object.contains("opacity")) {
    const json& opacity = object["opacity"];
    if (!opacity.is_number() || !(opacity >= 0 && opacity <= 1)) throw Wrong{where + "opacity", "a number from 0 to 1"};
    shown.opacity = opacity;
  }
  if (object.contains("visible")) {
    if (!object["visible"].is_boolean()) throw Wrong{where + "visible", "true or false"};
    shown.visible = object["visible"];
  }
  return shown;
}

OwnLabel ownFrom(const json& object, const std::string& where) {
  const auto tissue = object.contains("tissue") ? labelFromName(textAt(object, "tissue", where)) : kSoftTissue;
  if (!tissue || *tissue == kBackground) throw Wrong{where + "tissue", "a structure's name, e.g. \"vein\""};
  return {tidyLabelName(textAt(object, "name", where)), *tissue};
}

LabelState stateFrom(const json& object, const std::string& where) {
  const std::string text = textAt(object, "state", where);
  for (const LabelState state :
       {LabelState::NotStarted, LabelState::InProgress, LabelState::Completed, LabelState::Flagged})
    if (text == nameOf(state)) return state;
  throw Wrong{where + "state", "\"not started\", \"in progress\", \"completed\" or \"flagged\""};
}

void readStructure(const json& object, const std::string& where, CaseManifest& m) {
  const std::uint8_t label = labelAt(object, where);
  if (object.contains("opacity") || object.contains("visible")) m.shown[label] = shownFrom(object, where);
  if (isOwnLabel(label) && (object.contains("name") || object.contains("tissue")))
    m.ownLabels[label] = ownFrom(object, where);
  if (object.contains("state")) m.states[label] = stateFrom(object, where);
}

StartPose poseFrom(const json& object, const std::string& where, std::vector<std::string>& notes) {
  StartPose pose{textAt(object, "name", where), vectorAt(object, "position_mm", where),
                 vectorAt(object, "axial", where), vectorAt(object, "lateral", where)};
  if (norm(pose.axial) < 1e-6) throw Wrong{where + "axial", "a direction"};
  const Vec3 axial = normalized(pose.axial);
  const Vec3 across = pose.lateral - dot(pose.lateral, axial) * axial;
  if (norm(across) < 1e-3 * norm(pose.lateral) || norm(across) < 1e-6)
    throw Wrong{where + "lateral", "a direction that is not along axial"};
  const Vec3 lateral = normalized(across);
  if (norm(axial - pose.axial) > 1e-3 || norm(lateral - pose.lateral) > 1e-3)
    notes.push_back("The start pose \"" + pose.name +
                    "\" had directions that were not of length 1 or not at right angles; they were straightened.");
  pose.axial = axial;
  pose.lateral = lateral;
  return pose;
}

CaseVersion versionFrom(const json& document) {
  if (!document.contains("version")) return {};
  const json& object = document["version"];
  if (!object.is_object()) throw Wrong{"version", "an object"};
  CaseVersion version;
  if (!object.contains("number") || !object["number"].is_number_integer() || object["number"] < 0)
    throw Wrong{"version.number", "a whole number from 0"};
  version.number = object["number"];
  version.content = textAt(object, "content", "version."), version.voxels = textAt(object, "voxels", "version.");
  version.date = textAt(object, "date", "version."), version.author = textAt(object, "author", "version.");
  return version;
}

std::vector<std::string> textsAt(const json& object, const char* key) {
  std::vector<std::string> texts;
  if (!object.contains(key)) return texts;
  const Wrong wrong{key, "a list of texts"};
  if (!object[key].is_array()) throw wrong;
  for (const json& text : object[key]) {
    if (!text.is_string()) throw wrong;
    texts.push_back(text);
  }
  return texts;
}

template <class Read>
void forEach(const json& document, const char* key, const Read& read) {
  if (!document.contains(key)) return;
  if (!document[key].is_array()) throw Wrong{key, "a list"};
  for (std::size_t n = 0; n < document[key].size(); ++n) {
    const std::string where = std::string(key) + "[" + std::to_string(n) + "].";
    if (!document[key][n].is_object()) throw Wrong{where, "an object"};
    read(document[key][n], where);
  }
}

CaseManifest manifestFrom(const json& document, std::vector<std::string>& notes) {
  if (!document.is_object()) throw Wrong{"the document", "an object"};
  if (!document.contains("schema_version")) throw Missing{};
  if (!document["schema_version"].is_number_integer()) throw Wrong{"schema_version", "a whole number"};
  CaseManifest m;
  m.schemaVersion = document["schema_version"];
  if (m.schemaVersion < 1) throw Wrong{"schema_version", "1 or above"};
  if (document.contains("title")) m.title = textAt(document, "title", "");
  m.description = textAt(document, "description", "");
  m.difficulty = textAt(document, "difficulty", "");
  m.source = textAt(document, "source", "");
  m.importNotes = textsAt(document, "import_notes");
  constexpr std::array<std::string_view, 4> kDifficulties{"", "easy", "moderate", "hard"};
  if (std::ranges::find(kDifficulties, m.difficulty) == kDifficulties.end())
    throw Wrong{"difficulty", "\"easy\", \"moderate\" or \"hard\""};
  forEach(document, "targets", [&](const json& o, const std::string& w) { m.targets.push_back(targetFrom(o, w)); });
  forEach(document, "vessels", [&](const json& o, const std::string& w) { m.vessels.push_back(vesselFrom(o, w)); });
  forEach(document, "start_poses",
          [&](const json& o, const std::string& w) { m.startPoses.push_back(poseFrom(o, w, notes)); });
  forEach(document, "landmarks", [&](const json& o, const std::string& w) {
    m.landmarks.push_back({textAt(o, "code", w), textAt(o, "name", w), vectorAt(o, "position_mm", w)});
  });
  m.version = versionFrom(document);
  forEach(document, "structures", [&](const json& o, const std::string& w) { readStructure(o, w, m); });
  constexpr std::array<std::string_view, 12> kFields{"vessels",      "version",    "schema_version", "title",
                                                     "description",  "difficulty", "source",         "landmarks",
                                                     "import_notes", "targets",    "start_poses",    "structures"};
  for (const auto& [key, value] : document.items())
    if (std::ranges::find(kFields, key) == kFields.end())
      notes.push_back("case.json has a field \"" + key + "\" that Insonate does not know; it was ignored.");
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
  try {
    const json document = json::parse(text);
    if (document.is_object() && document.contains("schema_version") && document["schema_version"].is_number_integer() &&
        document["schema_version"] > CaseManifest::kSchemaVersion)
      return fail("case.json has schema version " + document["schema_version"].dump() +
                  ", but this program can read versions up to " + std::to_string(CaseManifest::kSchemaVersion) +
                  ". Use a newer version of the program.");
    return manifestFrom(document, notes);
  } catch (const Wrong& wrong) {
    return fail("case.json: " + wrong.where + " must be " + wrong.expected + ".");
  } catch (const Missing&) {
    return fail("case.json has no \"schema_version\"; add \"schema_version\": " +
                std::to_string(CaseManifest::kSchemaVersion) + " to it.");
  } catch (const json::exception& e) {
    return fail("case.json is not valid JSON: " + jsonProblem(e.what()) + ".");
  }
}

}  // namespace insonate
