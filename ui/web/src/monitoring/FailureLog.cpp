#include "monitoring/FailureLog.h"

#include <nlohmann/json.hpp>

namespace insonate::web {

void logFailure(const Log& log, const std::string& event, const std::string& sentence) {
  if (!log) return;
  const nlohmann::ordered_json object{{"event", event}, {"message", sentence}};
  log(LogLevel::Error, object.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace insonate::web
