#include "Commands.h"

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace insonate::cli {

void refuse(Outcome& outcome, const Error& error) {
  std::cerr << "insonate-cli: " << error.message << '\n';
  outcome.status = 1;
}

void printJson(nlohmann::json object) {
  object["version"] = INSONATE_VERSION;
  std::cout << object.dump(2) << '\n';
}

Progress terminalProgress() {
  if (!::isatty(STDERR_FILENO)) return {};
  return [](std::string_view doing, double fraction) {
    std::fprintf(stderr, "\r\033[K%.*s %3.0f %%", static_cast<int>(doing.size()), doing.data(), fraction * 100);
    if (fraction >= 1) std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
    return true;
  };
}

}  // namespace insonate::cli
