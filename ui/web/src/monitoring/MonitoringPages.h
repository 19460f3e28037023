#pragma once

#include "page/Page.h"

namespace insonate::web {

/// Answers "ok" if the database answers, else with status 503; for load balancers.
Response showHealth(const Visit& visit, const Parts& parts);
/// Shows the counts of Metrics and the number of sessions, for Prometheus.
Response showMetrics(const Visit& visit, const Parts& parts);

/// Tells whether a request may see showHealth() and showMetrics(): the request was made on this computer, or contains
/// the token of WebOptions::monitoringToken as "Authorization: Bearer TOKEN".
bool mayMonitor(const Request& request, const WebOptions& options);

}  // namespace insonate::web
