#include "monitoring/MonitoringPages.h"

#include "http/ClientAddress.h"
#include "monitoring/Metrics.h"

#include <insonate/curriculum/BrowserSessions.h>
#include <insonate/curriculum/VerificationQueue.h>

namespace insonate::web {

Response showHealth(const Visit& visit, const Parts& /*parts*/) {
  const bool answers = visit.store.hasPeople().has_value();
  return {.status = answers ? 200 : 503,
          .type = "text/plain; charset=utf-8",
          .body = answers ? "ok\n" : "The database does not answer.\n"};
}

Response showMetrics(const Visit& visit, const Parts& /*parts*/) {
  std::string text = visit.metrics.text();
  if (const auto sessions = BrowserSessions(visit.store).count())
    text +=
        "# HELP insonate_sessions Sessions of people who are signed in\n# TYPE insonate_sessions gauge\n"
        "insonate_sessions " +
        std::to_string(*sessions) + "\n";
  if (const auto waiting = VerificationQueue(visit.store).waiting())
    text +=
        "# HELP insonate_verifications_waiting Attempts of workstations that wait to be verified\n# TYPE "
        "insonate_verifications_waiting gauge\ninsonate_verifications_waiting " +
        std::to_string(*waiting) + "\n";
  return {.type = "text/plain; version=0.0.4; charset=utf-8", .body = std::move(text)};
}

bool mayMonitor(const Request& request, const WebOptions& options) {
  if (isFromHere(request)) return true;
  return !options.monitoringToken.empty() &&
         areEqual("Bearer " + options.monitoringToken, valueOf(request.headers, "authorization"));
}

}  // namespace insonate::web
