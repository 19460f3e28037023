#include <insonate/core/JsonEntry.h>
#include <insonate/core/Words.h>
#include <insonate/simulator/ProbePose.h>
#include <insonate/simulator/ScriptedSession.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace insonate {
namespace {

using nlohmann::json;
using What = decltype(ScriptAction::what);

const std::vector<std::string_view> kActs{"probe",       "move_probe_mm", "needle",   "advance_mm",
                                          "withdraw_mm", "wait_s",        "aspirate", "replace_needle",
                                          "freeze",      "tilt_deg",      "perform",  "instrument"};

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
Vec3 pointIn(JsonEntry& needle, std::string_view key, const Place& place) {
  const json& value = needle.value(key);
  if (const auto point_mm = vectorIn(value)) return *point_mm;
  const std::string name(key);
  if (value.is_object() && value.size() == 1 && value.contains("in_probe_mm"))
    if (const auto point_mm = vectorIn(value["in_probe_mm"])) {
      if (place.patientFromProbe) return *place.patientFromProbe * *point_mm;
      needle.setError("has '" + name + "' in the probe's frame, but no probe is on the patient. Put the probe first.");
    }
  std::vector<std::string_view> names;
  for (const Target& target : place.patient.manifest.targets) {
    if (value == target.name) return target.position_mm;
    names.push_back(target.name);
  }
  needle.setError("needs [x, y, z] in mm, {\"in_probe_mm\": [x, y, z]} or one of the case's targets (" +
                  quotedWords(names) + ") as '" + name + "'.");
  return {};
}

What probeAct(JsonEntry& act, Place& place) {
  const json& value = act.value("probe");
  place.patientFromProbe.reset();
  if (value.is_null()) return ScriptAction::LiftProbe{};
  const auto poses = readPoses(value.is_string() ? value.get<std::string>() : value.dump(), place.patient);
  if (poses)
    place.patientFromProbe = poses->patientFromProbe.front();
  else
    act.setError("has a probe that cannot be put there: " + poses.error().message);
  return ScriptAction::PlaceProbe{place.patientFromProbe.value_or(Transform{})};
}

double speedIn(JsonEntry& act) {
  return act.optionalNumber("speed_mmps", 0.1, 500).value_or(10);
}

What performAct(JsonEntry& act) {
  const auto& names = lineActNames();
  const auto which = static_cast<LineAct>(act.word("perform", {names.begin(), names.end()}));
  const bool isAtLumen = which == LineAct::AspirateLumen || which == LineAct::FlushLumen;
  return ScriptAction::PerformAct{which, isAtLumen ? static_cast<int>(act.number("lumen", 1, kCatheterLumens)) : 1};
}

What instrumentAct(JsonEntry& act) {
  ScriptAction::MoveInstrument move;
  move.instrument =
      static_cast<Instrument>(act.word("instrument", {instrumentNames().begin(), instrumentNames().end()}));
  if (move.instrument == Instrument::Needle)
    act.setError("moves the needle, for which there are advance_mm and withdraw_mm.");
  move.by_mm = act.number("by_mm", -600, 600);
  move.speed_mmps = act.optionalNumber("speed_mmps", 0.1, 500).value_or(move.speed_mmps);
  return move;
}

What moveProbeAct(JsonEntry& act, Place& place) {
  const auto by = act.numbers("move_probe_mm", 3, -200, 200, "[x, y, z] in the probe's frame");
  if (!place.patientFromProbe) {
    act.setError("moves a probe, but no probe is on the patient. Put the probe first.");
    return {};
  }
  Transform& at = *place.patientFromProbe;
  at.offset = at * Vec3{by[0], by[1], by[2]};
  return ScriptAction::MoveProbe{at.offset, speedIn(act)};
}

What needleAct(JsonEntry& act, const Place& place, std::string& error) {
  JsonEntry needle(act.value("needle"), act.where() + ", needle,", {"from_mm", "to"}, error);
  const Vec3 from_mm = pointIn(needle, "from_mm", place), to_mm = pointIn(needle, "to", place);
  if (norm(to_mm - from_mm) < 1) needle.setError("has 'from_mm' and 'to' less than 1 mm apart.");
  return ScriptAction::PlaceNeedle{from_mm, to_mm};
}

What freezeAct(JsonEntry& act, Place& place) {
  place.frozen = act.flag("freeze");
  return ScriptAction::ReportEvent{place.frozen ? AttemptEventKind::Frozen : AttemptEventKind::Released};
}

What whatOf(std::string_view name, JsonEntry& act, Place& place, std::string& error) {
  if (name == "probe") return probeAct(act, place);
  if (name == "move_probe_mm") return moveProbeAct(act, place);
  if (place.frozen && (name == "needle" || name == "advance_mm" || name == "withdraw_mm"))
    act.setError("moves a needle that is frozen. Release it first with {\"freeze\": false}.");
  if (name == "needle") return needleAct(act, place, error);
  if (name == "advance_mm") return ScriptAction::MoveNeedle{act.number("advance_mm", 0, 200), speedIn(act)};
  if (name == "withdraw_mm") return ScriptAction::MoveNeedle{-act.number("withdraw_mm", 0, 200), speedIn(act)};
  if (name == "wait_s") return ScriptAction::Wait{act.number("wait_s", 0, 600)};
  if (name == "aspirate") return ScriptAction::Aspirate{act.flag("aspirate")};
  if (name == "freeze") return freezeAct(act, place);
  if (name == "tilt_deg")
    return ScriptAction::ReportEvent{AttemptEventKind::Positioned, act.number("tilt_deg", -45, 45)};
  if (name == "perform") return performAct(act);
  if (name == "instrument") return instrumentAct(act);
  if (!act.flag("replace_needle")) act.setError("needs true as 'replace_needle'.");
  return ScriptAction::ReportEvent{AttemptEventKind::NeedleReplaced};
}

ScriptAction readAct(const json& object, const std::string& where, std::string& error, Place& place) {
  std::vector<std::string_view> known = kActs;
  known.insert(known.end(), {"speed_mmps", "by_mm", "lumen"});
  JsonEntry act(object, where, known, error);
  const bool moves =
      act.has("advance_mm") || act.has("withdraw_mm") || act.has("move_probe_mm") || act.has("instrument");
  const std::size_t details = (moves && act.has("speed_mmps")) + (act.has("instrument") && act.has("by_mm")) +
                              (act.has("perform") && act.has("lumen"));
  if (error.empty() && object.size() != 1 + details)
    act.setError("must be an object with one of " + joinedWords(kActs) +
                 "; advance_mm, withdraw_mm, move_probe_mm and instrument also take a speed_mmps, instrument a by_mm, "
                 "and perform a lumen.");
  const auto name = std::ranges::find_if(kActs, [&](std::string_view one) { return act.has(one); });
  if (name == kActs.end()) act.setError("has a 'speed_mmps' but no move.");
  return error.empty() ? ScriptAction{whatOf(*name, act, place, error)} : ScriptAction{};
}

}  // namespace

Result<SessionScript> readSessionScript(std::string_view text, const PatientCase& patient) {
  const auto object = parsedJson(text, "The script");
  if (!object) return tl::unexpected(object.error());
  JsonEntry file(*object, "The script", {"procedure", "probe", "abandoned", "description", "acts"});
  SessionScript script;
  if (file.has("procedure")) script.procedure = file.text("procedure");
  if (file.has("probe")) script.probe = file.text("probe");
  script.abandoned = file.flag("abandoned");
  file.value("acts");
  Place place{patient};
  script.actions = file.list("acts", "act", [&](const json& act, const std::string& where, std::string& error) {
    return readAct(act, where, error, place);
  });
  if (!file.error().empty()) return fail(file.error());
  return script;
}

}  // namespace insonate
