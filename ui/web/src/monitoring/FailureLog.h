#pragma once

#include <insonate/web/WebServer.h>

#include <string>

namespace insonate::web {

/// Logs a failure as an error: {"event":"video queue failed","message":"..."}. Bytes of the sentence that are not UTF-8
/// are replaced. An empty `log` receives nothing.
void logFailure(const Log& log, const std::string& event, const std::string& sentence);

}  // namespace insonate::web
