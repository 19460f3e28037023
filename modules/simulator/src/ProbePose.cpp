#include <insonate/cases/StartPose.h>
#include <insonate/core/Words.h>
#include <insonate/simulator/ProbePose.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace insonate {
namespace {

using nlohmann::json;

std::string shown(const json& value) {
  const std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  return text.size() > 60 ? text.substr(0, 60) + "..." : text;
}

Result<Vec3> readVector(const json& pose, const char* name, const std::string& where) {
  const auto found = pose.find(name);
  if (found == pose.end())
    return fail(where + " has no \"" + name + "\"; position_mm, axial and lateral are needed, each [x, y, z].");
  const bool three = found->is_array() && found->size() == 3 &&
                     std::all_of(found->begin(), found->end(), [](const json& number) { return number.is_number(); });
  if (!three) return fail(where + ": " + name + " must be three numbers [x, y, z], not " + shown(*found) + ".");
  return Vec3{(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
}

/// Reported from one degree on; less is rounding.
std::string straightened(const Transform& patientFromProbe, Vec3 lateral, const std::string& where) {
  constexpr double kRadiansToDegrees = 57.29577951308232;
  const Vec3 x = patientFromProbe.linear.column[0], z = patientFromProbe.linear.column[2];
  const double angle_deg = kRadiansToDegrees * std::abs(std::atan2(dot(lateral, z), dot(lateral, x)));
  if (angle_deg <= 1) return {};
  return where + ": lateral was turned by " + std::to_string(std::lround(angle_deg)) +
         " degrees, to be at right angles to axial.";
}

Result<Transform> readPose(const json& pose, const std::string& where, std::vector<std::string>& warnings) {
  if (!pose.is_object()) return fail(where + " must be a JSON object { ... }, not " + shown(pose) + ".");
  const std::vector<std::string_view> known{"name", "position_mm", "axial", "lateral"};
  for (const auto& [key, value] : pose.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string_view near = nearestWord(key, known);
    return fail(
        where + ": unknown field '" + key +
        (near.empty() ? "'; known are " + joinedWords(known) + "." : "'; did you mean '" + std::string(near) + "'?"));
  }
  const auto position_mm = readVector(pose, "position_mm", where);
  if (!position_mm) return tl::unexpected(position_mm.error());
  const auto axial = readVector(pose, "axial", where);
  if (!axial) return tl::unexpected(axial.error());
  const auto lateral = readVector(pose, "lateral", where);
  if (!lateral) return tl::unexpected(lateral.error());
  auto transform = patientFromProbe(*position_mm, *axial, *lateral);
  if (!transform) return fail(where + ": " + transform.error().message);
  if (std::string warning = straightened(*transform, *lateral, where); !warning.empty())
    warnings.push_back(std::move(warning));
  return transform;
}

Result<PosePath> readPath(const json& list, const std::string& where) {
  if (!list.is_array() || list.empty()) return fail(where + ": a list of at least one pose is needed.");
  PosePath path{{}, true, {}};
  for (const json& item : list) {
    auto pose = readPose(item, where + ", pose " + std::to_string(path.patientFromProbe.size()), path.warnings);
    if (!pose) return tl::unexpected(pose.error());
    path.patientFromProbe.push_back(*pose);
  }
  return path;
}

Result<PosePath> parsePoses(std::string_view text, const std::string& where) {
  json parsed;
  try {
    parsed = json::parse(text);
  } catch (const json::exception& error) {
    return fail(where + " is not valid JSON: " + jsonProblem(error.what()) + ".");
  }
  if (parsed.is_array()) return readPath(parsed, where);
  if (parsed.is_object() && parsed.contains("poses")) {
    if (parsed.size() > 1) return fail(where + ": no other field may stand beside \"poses\".");
    return readPath(parsed["poses"], where);
  }
  PosePath path;
  const auto pose = readPose(parsed, where, path.warnings);
  if (!pose) return tl::unexpected(pose.error());
  path.patientFromProbe = {*pose};
  return path;
}

Result<PosePath> single(const Result<StartPose>& pose) {
  if (!pose) return tl::unexpected(pose.error());
  auto transform = patientFromProbe(pose->position_mm, pose->axial, pose->lateral);
  if (!transform) return fail("Start pose '" + pose->name + "' of the case: " + transform.error().message);
  return PosePath{{*transform}, false, {}};
}

std::string neitherNameNorFile(std::string_view text, const PatientCase& patient) {
  std::vector<std::string_view> names{"auto"};
  for (const StartPose& pose : patient.manifest.startPoses) names.push_back(pose.name);
  return "'" + std::string(text) + "' is no pose: it is neither a readable JSON file nor one of " + quotedWords(names) +
         ", nor does it begin with { or [.";
}

}  // namespace

Result<Transform> patientFromProbe(Vec3 position_mm, Vec3 axial, Vec3 lateral) {
  if (!isFinite(position_mm) || !isFinite(axial) || !isFinite(lateral))
    return fail("position_mm, axial and lateral must be finite numbers.");
  // Scales first, so that squares of tiny or huge directions do not underflow or overflow.
  const auto largest = [](Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  if (largest(axial) == 0) return fail("axial must not be zero: it says where the probe looks.");
  if (largest(lateral) == 0) return fail("lateral must not be zero: it says where the probe's marker points.");
  const Vec3 z = normalized(axial / largest(axial));
  const Vec3 along = normalized(lateral / largest(lateral));
  const Vec3 across = along - z * dot(along, z);
  constexpr double kSinOneDegree = 0.01745;
  if (norm(across) < kSinOneDegree) return fail("axial and lateral are parallel; lateral must point along the array.");
  const Vec3 x = normalized(across);
  return Transform{{{x, cross(z, x), z}}, position_mm};
}

StartPose poseOf(const Transform& patientFromProbe) {
  return {"", patientFromProbe.offset, patientFromProbe.linear.column[2], patientFromProbe.linear.column[0]};
}

Result<PosePath> readPoses(std::string_view text, const PatientCase& patient) {
  if (text == "auto") {
    const auto pose = autoStartPose(patient);
    auto path = single(pose);
    if (path && patient.manifest.startPoses.empty())
      path->warnings.push_back("The pose was found automatically: " + pose->name +
                               ". Give --pose, or a start pose in case.json, to choose another.");
    return path;
  }
  for (const StartPose& pose : patient.manifest.startPoses)
    if (pose.name == text) return single(pose);
  if (const auto first = text.find_first_not_of(" \t\r\n");
      first != text.npos && (text[first] == '{' || text[first] == '['))
    return parsePoses(text, "The pose");
  const std::filesystem::path file(text);
  std::error_code error;
  std::ifstream stream(file, std::ios::binary);
  if (!stream || !std::filesystem::is_regular_file(file, error)) return fail(neitherNameNorFile(text, patient));
  return parsePoses(std::string{std::istreambuf_iterator<char>(stream), {}}, file.string());
}

}  // namespace insonate
