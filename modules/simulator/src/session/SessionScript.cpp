#include <insonate/core/Words.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>

namespace insonate {
namespace {

using nlohmann::json;

const std::vector<std::string_view> kActs{"probe",  "move_probe_mm", "needle",         "advance_mm", "withdraw_mm",
                                          "wait_s", "aspirate",      "replace_needle", "freeze",     "tilt_deg"};

std::string shown(const json& value) {
  constexpr std::size_t kMost = 40;
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  return text.size() <= kMost ? text : text.substr(0, kMost) + "...";
}

Result<double> numberIn(const json& value, const std::string& name, double low, double high) {
  if (value.is_number() && value >= low && value <= high) return value.get<double>();
  return fail("needs a number from " + json(low).dump() + " to " + json(high).dump() + " as '" + name + "', not " +
              shown(value) + ".");
}

std::optional<Vec3> vectorIn(const json& value) {
  if (!value.is_array() || value.size() != 3 ||
      !std::ranges::all_of(value, [](const json& v) { return v.is_number(); }))
    return std::nullopt;
  return Vec3{value[0], value[1], value[2]};
}

/// Positions of the tools while acts are read in order.
struct Place {
  const PatientCase& patient;
  std::optional<Transform> patientFromProbe{};
  bool frozen = false;
};

/// A point as [x, y, z], in the probe's frame, or the name of one of the case's targets.
Result<Vec3> pointIn(const json& value, const std::string& name, const Place& place) {
  if (const auto point_mm = vectorIn(value)) return *point_mm;
  if (value.is_object() && value.size() == 1 && value.contains("in_probe_mm"))
    if (const auto point_mm = vectorIn(value["in_probe_mm"])) {
      if (place.patientFromProbe) return *place.patientFromProbe * *point_mm;
      return fail("has '" + name + "' in the frame of a probe, and none is on the patient.");
    }
  std::vector<std::string_view> names;
  for (const Target& target : place.patient.manifest.targets) {
    if (value == target.name) return target.position_mm;
    names.push_back(target.name);
  }
  return fail("needs [x, y, z] in mm, {\"in_probe_mm\": [x, y, z]} or one of the case's targets (" +
              quotedWords(names) + ") as '" + name + "', not " + shown(value) + ".");
}

Result<SessionAct> probeAct(const json& value, Place& place) {
  place.patientFromProbe.reset();
  if (value.is_null()) return SessionAct{SessionAct::LiftProbe{}};
  const auto poses = readPoses(value.is_string() ? value.get<std::string>() : value.dump(), place.patient);
  if (!poses) return fail("has a probe that cannot be put there: " + poses.error().message);
  place.patientFromProbe = poses->patientFromProbe.front();
  return SessionAct{SessionAct::PutProbe{*place.patientFromProbe}};
}

Result<SessionAct> moveProbeAct(const json& act, Place& place) {
  const auto by_mm = vectorIn(act["move_probe_mm"]);
  if (!by_mm || norm(*by_mm) > 200)
    return fail("needs [x, y, z] in the probe's frame, 200 mm at most, as 'move_probe_mm', not " +
                shown(act["move_probe_mm"]) + ".");
  if (!place.patientFromProbe) return fail("moves a probe, and none is on the patient.");
  const auto speed = numberIn(act.value("speed_mmps", json(10)), "speed_mmps", 0.1, 500);
  if (!speed) return tl::unexpected(speed.error());
  Transform& at = *place.patientFromProbe;
  at.offset = at * *by_mm;
  return SessionAct{SessionAct::MoveProbe{at.offset, *speed}};
}

Result<SessionAct> needleAct(const json& value, const Place& place) {
  if (!value.is_object() || value.size() != 2 || !value.contains("from_mm") || !value.contains("to"))
    return fail("needs {\"from_mm\": [x, y, z], \"to\": target} as 'needle', not " + shown(value) + ".");
  const auto from = pointIn(value["from_mm"], "from_mm", place), to = pointIn(value["to"], "to", place);
  if (!from || !to) return tl::unexpected(from ? to.error() : from.error());
  if (norm(*to - *from) < 1) return fail("has a needle whose 'from_mm' and 'to' are less than 1 mm apart.");
  return SessionAct{SessionAct::PutNeedle{*from, *to}};
}

Result<SessionAct> moveAct(const json& act, const char* name, double sign) {
  const auto by = numberIn(act[name], name, 0, 200);
  const auto speed = numberIn(act.value("speed_mmps", json(10)), "speed_mmps", 0.1, 500);
  if (!by || !speed) return tl::unexpected(by ? speed.error() : by.error());
  return SessionAct{SessionAct::MoveNeedle{sign * *by, *speed}};
}

Result<bool> flagIn(const json& value, const std::string& name) {
  if (value.is_boolean()) return value.get<bool>();
  return fail("needs true or false as '" + name + "', not " + shown(value) + ".");
}

Result<SessionAct> freezeAct(const json& value, Place& place) {
  const auto on = flagIn(value, "freeze");
  if (!on) return tl::unexpected(on.error());
  place.frozen = *on;
  return SessionAct{SessionAct::Tell{*on ? AttemptEventKind::Frozen : AttemptEventKind::Released}};
}

Result<SessionAct> readAct(const json& act, Place& place) {
  const bool moves =
      act.is_object() && (act.contains("advance_mm") || act.contains("withdraw_mm") || act.contains("move_probe_mm"));
  if (!act.is_object() || act.size() != (moves && act.contains("speed_mmps") ? 2u : 1u))
    return fail("must be an object with one of " + joinedWords(kActs) +
                "; advance_mm, withdraw_mm and move_probe_mm also take a speed_mmps.");
  const std::string name = act.begin().key() == "speed_mmps" ? std::next(act.begin()).key() : act.begin().key();
  const json& value = act[name];
  if (name == "probe") return probeAct(value, place);
  if (name == "move_probe_mm") return moveProbeAct(act, place);
  if (place.frozen && (name == "needle" || name == "advance_mm" || name == "withdraw_mm"))
    return fail("moves a needle that is frozen; let it go before, with {\"freeze\": false}.");
  if (name == "needle") return needleAct(value, place);
  if (name == "advance_mm") return moveAct(act, "advance_mm", 1);
  if (name == "withdraw_mm") return moveAct(act, "withdraw_mm", -1);
  if (name == "wait_s")
    return numberIn(value, name, 0, 600).map([](double s) { return SessionAct{SessionAct::Wait{s}}; });
  if (name == "aspirate") return flagIn(value, name).map([](bool on) { return SessionAct{SessionAct::Aspirate{on}}; });
  if (name == "freeze") return freezeAct(value, place);
  if (name == "tilt_deg")
    return numberIn(value, name, -45, 45).map([](double deg) {
      return SessionAct{SessionAct::Tell{AttemptEventKind::Positioned, deg}};
    });
  if (name == "replace_needle" && value == true) return SessionAct{SessionAct::Tell{AttemptEventKind::NeedleReplaced}};
  if (name == "replace_needle") return fail("needs true as 'replace_needle', not " + shown(value) + ".");
  const std::string_view near = nearestWord(name, kActs);
  return fail(
      "is of no known kind, '" + name + "'" +
      (near.empty() ? "; known are " + joinedWords(kActs) + "." : "; did you mean '" + std::string(near) + "'?"));
}

}  // namespace

Result<SessionScript> readSessionScript(std::string_view text, const PatientCase& patient) {
  json file;
  try {
    file = json::parse(text);
  } catch (const json::exception& e) {
    return fail("The script is not JSON: " + jsonProblem(e.what()));
  }
  if (!file.is_object() || !file.contains("acts") || !file["acts"].is_array())
    return fail("The script must be an object with a list of 'acts'.");
  SessionScript script;
  for (const auto& [key, value] : file.items()) {
    const bool isText = key == "procedure" || key == "probe";
    if (!isText && key != "abandoned" && key != "acts" && key != "description")
      return fail("The script has an unknown '" + key +
                  "'; it may have procedure, probe, abandoned, description, acts.");
    if (isText && !value.is_string())
      return fail("The script needs a name as '" + key + "', not " + shown(value) + ".");
  }
  script.procedure = file.value("procedure", script.procedure), script.probe = file.value("probe", script.probe);
  const auto abandoned = flagIn(file.value("abandoned", json(false)), "abandoned");
  if (!abandoned) return fail("The script " + abandoned.error().message);
  script.abandoned = *abandoned;
  Place place{patient};
  for (const json& entry : file["acts"]) {
    const auto act = readAct(entry, place);
    if (!act) return fail("Act " + std::to_string(script.acts.size() + 1) + " " + act.error().message);
    script.acts.push_back(*act);
  }
  return script;
}

}  // namespace insonate
