#pragma once

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/procedure/AttemptScore.h>

#include <nlohmann/json_fwd.hpp>

#include <vector>

namespace insonate::cli {

/// Returns an attempt as JSON {"status", "metrics": {id: value or null}, "target", "events": [{"t_s", "kind", ...}]},
/// as `session --json` and `replay --json` print it. `vessels`: AttemptHeader::vessels.
nlohmann::json attemptReport(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                             const std::vector<std::string>& vessels);
/// Returns a score as JSON {"points", "succeeded", "advice", "critical_errors", "moments", "metrics": [{"metric",
/// "value", "novice", "expert", "share", "source"}]}; missing values, norms and points are null.
nlohmann::json scoreReport(const AttemptScore& score);
void printScore(const AttemptScore& score);
/// Prints the attempt as readable text to standard output.
void printAttempt(AttemptStatus status, const MetricValues& metrics, const std::vector<AttemptEvent>& events,
                  const std::vector<std::string>& vessels);

}  // namespace insonate::cli
