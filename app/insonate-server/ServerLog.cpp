#include "ServerLog.h"

#include <spdlog/sinks/stdout_sinks.h>
#include <spdlog/spdlog.h>

#include <memory>
#include <string>

namespace insonate {

web::Log standardLog() {
  auto logger = std::make_shared<spdlog::logger>("insonate-server", std::make_shared<spdlog::sinks::stderr_sink_mt>());
  // The message is a JSON object, whose opening brace the pattern replaces.
  logger->set_pattern(R"({"time":"%Y-%m-%dT%H:%M:%S.%e%z","level":"%l",%v)");
  return [logger](web::LogLevel level, const std::string& object) {
    logger->log(level == web::LogLevel::Info ? spdlog::level::info : spdlog::level::err,
                std::string_view(object).substr(1));
  };
}

}  // namespace insonate
