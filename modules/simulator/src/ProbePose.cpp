#include <insonate/cases/StartPose.h>
#include <insonate/core/JsonEntry.h>
#include <insonate/core/Preset.h>
#include <insonate/core/Words.h>
#include <insonate/simulator/ProbePose.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using nlohmann::json;

constexpr double kFarthest = 1e6;

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
  JsonEntry entry(pose, where, {"name", "position_mm", "axial", "lateral"});
  const auto vector = [&](const char* key) {
    const auto three = entry.numbers(key, 3, -kFarthest, kFarthest, "[x, y, z]");
    return Vec3{three[0], three[1], three[2]};
  };
  const Vec3 position_mm = vector("position_mm"), axial = vector("axial"), lateral = vector("lateral");
  if (!entry.error().empty()) return fail(entry.error());
  auto transform = patientFromProbe(position_mm, axial, lateral);
  if (!transform) return fail(where + ": " + transform.error().message);
  if (std::string warning = straightened(*transform, lateral, where); !warning.empty())
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
  const auto parsed = parsedJson(text, where);
  if (!parsed) return tl::unexpected(parsed.error());
  if (parsed->is_array()) return readPath(*parsed, where);
  if (parsed->is_object() && parsed->contains("poses")) {
    if (parsed->size() > 1) return fail(where + ": no other field is allowed beside \"poses\".");
    return readPath(parsed->at("poses"), where);
  }
  PosePath path;
  const auto pose = readPose(*parsed, where, path.warnings);
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
  return "'" + std::string(text) + "' is not a pose: it is neither a readable JSON file nor one of " +
         quotedWords(names) + ", nor does it begin with { or [.";
}

}  // namespace

Result<Transform> patientFromProbe(Vec3 position_mm, Vec3 axial, Vec3 lateral) {
  if (!isFinite(position_mm) || !isFinite(axial) || !isFinite(lateral))
    return fail("position_mm, axial and lateral must be finite numbers.");
  // Scales first, so that squares of tiny or huge directions do not underflow or overflow.
  const auto largest = [](Vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  if (largest(axial) == 0) return fail("axial must not be zero: it is the direction in which the probe points.");
  if (largest(lateral) == 0)
    return fail("lateral must not be zero: it is the direction in which the probe's marker points.");
  const Vec3 z = normalized(axial / largest(axial));
  const Vec3 along = normalized(lateral / largest(lateral));
  const Vec3 across = along - z * dot(along, z);
  constexpr double kSinOneDegree = 0.01745;
  if (norm(across) < kSinOneDegree) return fail("axial and lateral are parallel; lateral must point along the array.");
  const Vec3 x = normalized(across);
  return Transform{{{x, cross(z, x), z}}, position_mm};
}

StartPose toStartPose(const Transform& patientFromProbe) {
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
  const auto content = readTextFile(file);
  if (!content || !std::filesystem::is_regular_file(file, error)) return fail(neitherNameNorFile(text, patient));
  return parsePoses(*content, file.string());
}

}  // namespace insonate
