#include "StandingError.h"

#include <insonate/simulator/LiveAttempt.h>

#include <algorithm>

namespace insonate::train {

std::optional<std::size_t> StandingError::find(const Procedure& procedure, const AttemptView& view) const {
  const auto isWithdrawnAfter = [&view](std::int64_t time_us) {
    return std::ranges::any_of(view.events, [time_us](const AttemptEvent& event) {
      return event.kind == AttemptEventKind::Withdrawn && event.wall == kSkin && event.time_us > time_us;
    });
  };
  const auto severityOf = [&](std::size_t k) { return procedure.rules[view.findings[k].rule].severity; };
  std::optional<std::size_t> worst;
  for (std::size_t k = 0; k < view.findings.size(); ++k) {
    if (severityOf(k) == Severity::Minor || dismissed_.contains(k) || isWithdrawnAfter(view.findings[k].time_us))
      continue;
    if (!worst || severityOf(k) >= severityOf(*worst)) worst = k;
  }
  return worst;
}

}  // namespace insonate::train
