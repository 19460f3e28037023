#include "AttemptReport.h"

#include "Commands.h"

#include <insonate/procedure/MetricTitle.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <string>

namespace insonate::cli {
namespace {

const char* nameOf(AttemptStatus status) {
  switch (status) {
    case AttemptStatus::Completed:
      return "completed";
    case AttemptStatus::Abandoned:
      return "abandoned";
    case AttemptStatus::CutShort:
      break;
  }
  return "cut short";
}

/// Name of a kind of event as a JSON value: "wire_in_short_axis".
std::string keyOf(AttemptEventKind kind) {
  std::string key(nameOf(kind));
  std::ranges::replace(key, ' ', '_');
  return key;
}

const char* nameOf(Severity severity) {
  switch (severity) {
    case Severity::Minor:
      return "minor";
    case Severity::Major:
      return "major";
    case Severity::Critical:
      break;
  }
  return "critical";
}

/// Tells whether the event of the line states a vessel or tissue.
bool isAtVessel(const AttemptEvent& event) {
  using enum AttemptEventKind;
  return event.kind == WireInShortAxis || event.kind == WireInLongAxis || event.kind == BubblesSeen ||
         event.kind == InstrumentEntered;
}

bool isOfInstrument(const AttemptEvent& event) {
  using enum AttemptEventKind;
  return (event.kind >= InstrumentEntered && event.kind <= WireLost) || event.kind == WireKinked;
}

bool isOfWall(const AttemptEvent& event) {
  using enum AttemptEventKind;
  return event.kind <= Struck || event.kind == Centered || event.kind == Compressed || event.kind == ColorShown ||
         event.kind == Pneumothorax || isAtVessel(event);
}

nlohmann::json jsonOf(const AttemptEvent& event, const std::vector<std::string>& vessels) {
  nlohmann::json object{{"t_s", static_cast<double>(event.time_us) * 1e-6}, {"kind", keyOf(event.kind)}};
  if (event.kind == AttemptEventKind::Positioned) object["tilt_deg"] = event.tilt_deg;
  if (isOfWall(event))
    object.update({{"wall", labelTable()[event.wall].name},
                   {"into", labelTable()[event.into].name},
                   {"depth_mm", event.depth_mm},
                   {"tip_mm", jsonArray(event.tip_mm)},
                   {"axis", jsonArray(event.axis)}});
  if (event.kind == AttemptEventKind::Performed) object.update({{"act", nameOf(event.act)}, {"amount", event.amount}});
  if (event.kind == AttemptEventKind::AirEntered) object["amount_ml"] = event.amount;
  if (isOfInstrument(event)) object.update({{"instrument", nameOf(event.instrument)}, {"depth_mm", event.depth_mm}});
  if (const std::string vessel = vesselName(event, vessels); !vessel.empty()) object["vessel"] = vessel;
  return object;
}

}  // namespace

nlohmann::json attemptReport(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                             const std::vector<std::string>& vessels) {
  nlohmann::json values = nlohmann::json::object(), list = nlohmann::json::array();
  for (const MetricDefinition& metric : metricTable()) {
    const auto value = metrics[metric.metric];
    values[std::string(metric.id)] = value ? nlohmann::json(*value) : nlohmann::json(nullptr);
  }
  for (const AttemptEvent& event : events) list.push_back(jsonOf(event, vessels));
  return {{"status", nameOf(status)},
          {"metrics", values},
          {"target", vessels.empty() ? nlohmann::json(nullptr) : nlohmann::json(vessels.front())},
          {"events", list}};
}

nlohmann::json scoreReport(const AttemptScore& score) {
  const auto orNull = [](const auto& value) { return value ? nlohmann::json(*value) : nlohmann::json(nullptr); };
  const auto list = [](const std::vector<AttemptMoment>& moments) {
    nlohmann::json all = nlohmann::json::array();
    for (const AttemptMoment& moment : moments)
      all.push_back({{"t_s", static_cast<double>(moment.time_us) * 1e-6},
                     {"say", moment.description},
                     {"severity", moment.severity ? nlohmann::json(nameOf(*moment.severity)) : nullptr}});
    return all;
  };
  nlohmann::json metrics = nlohmann::json::array();
  for (const MetricScore& metric : score.metrics) {
    nlohmann::json entry{
        {"metric", definitionOf(metric.metric).id}, {"value", orNull(metric.value)}, {"share", orNull(metric.share)}};
    for (const char* key : {"novice", "expert", "source"}) entry[key] = nullptr;
    if (metric.norm)
      entry.update({{"novice", metric.norm->novice}, {"expert", metric.norm->expert}, {"source", metric.norm->source}});
    metrics.push_back(std::move(entry));
  }
  return {{"points", orNull(score.points)}, {"succeeded", score.succeeded},
          {"advice", score.advice},         {"critical_errors", list(score.criticalErrors)},
          {"moments", list(score.moments)}, {"metrics", metrics}};
}

void printScore(const AttemptScore& score) {
  if (score.points)
    std::printf("score %.0f of 100%s\n", *score.points, score.succeeded ? "" : ", did not succeed");
  else
    std::printf("no score\n");
  for (const AttemptMoment& error : score.criticalErrors) std::printf("critical: %s\n", error.description.c_str());
  std::printf("%s\n", score.advice.c_str());
}

void printAttempt(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                  const std::vector<std::string>& vessels) {
  std::printf("%s\n", status == AttemptStatus::CutShort ? "abandoned: the recording stopped early" : nameOf(status));
  for (const AttemptEvent& event : events) {
    const std::string vessel = vesselName(event, vessels);
    const std::string wall = isOfWall(event) ? std::string(labelTable()[event.wall].name) : "";
    const std::string subject = event.kind == AttemptEventKind::Performed ? std::string(nameOf(event.act)) + " "
                                : isOfInstrument(event)                   ? std::string(nameOf(event.instrument)) + " "
                                                                          : "";
    std::printf("%9.3f s  %s %s%s\n", static_cast<double>(event.time_us) * 1e-6, keyOf(event.kind).c_str(),
                subject.c_str(), (vessel.empty() ? wall : vessel).c_str());
  }
  for (const MetricDefinition& metric : metricTable())
    if (const auto value = metrics[metric.metric])
      std::printf("%10.2f %-3s  %s (%s)\n", *value, std::string(metric.unit).c_str(),
                  std::string(metricTitle(metric.metric)).c_str(), std::string(metric.id).c_str());
}

}  // namespace insonate::cli
