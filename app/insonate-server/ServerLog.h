#pragma once

#include <insonate/web/WebServer.h>

namespace insonate {

/// Returns a log that writes one JSON object per line to the standard error: "time", "level" and what happened.
web::Log standardLog();

}  // namespace insonate
