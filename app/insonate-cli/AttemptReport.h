#pragma once

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/AttemptScore.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace insonate::cli {

/// {"status", "metrics": {id: value or null}, "target", "events": [{"t_s", "kind", ...}]}, as `session --json` and
/// `replay
/// --json` print it; `vessels` as in AttemptHeader.
nlohmann::json attemptReport(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                             const std::vector<std::string>& vessels);
/// {"points", "succeeded", "advice", "critical_errors", "moments", "metrics": [{"metric", "value", "novice", "expert",
/// "share", "source"}]}, null where a value, a norm or the points are missing.
nlohmann::json scoreReport(const AttemptScore& score);
void printScore(const AttemptScore& score);
/// The same for a person, on standard output.
void printAttempt(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                  const std::vector<std::string>& vessels);

}  // namespace insonate::cli
