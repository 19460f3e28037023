#include "Commands.h"

#include "Interrupt.h"

#include <insonate/cases/CaseVersions.h>

#include <nlohmann/json.hpp>
#include <unistd.h>

#include <cstdio>
#include <iostream>

namespace insonate::cli {

void refuse(Outcome& outcome, const Error& error, const nlohmann::json& fields) {
  const std::string sentence = error.message == kCancelled ? "Canceled: nothing was written." : error.message;
  if (::isatty(STDERR_FILENO)) std::cerr << "\r\033[K";  // a progress line that was left
  std::cerr << "insonate-cli: " << sentence << '\n';
  outcome.status = interruptSignal() ? 128 + interruptSignal() : 1;
  if (!outcome.json) return;
  nlohmann::json object = fields;
  object["error"] = sentence;
  printJson(std::move(object));
}

void refuse(Outcome& outcome, const Error& error) {
  refuse(outcome, error, nlohmann::json::object());
}

void printJson(nlohmann::json object) {
  object["version"] = INSONATE_VERSION;
  std::cout << object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

nlohmann::json jsonArray(Vec3 v) {
  return {v.x, v.y, v.z};
}

Result<void> writeOrReplace(const PatientCase& patient, const std::string& caseFolder) {
  if (checkCaseTarget(caseFolder, false)) return writeCase(patient, caseFolder, terminalProgress());
  const auto version = saveCaseVersion(patient, caseFolder, today(), {}, terminalProgress());
  if (!version) return tl::unexpected(version.error());
  return {};
}

void printNextSteps(const std::string& caseFolder) {
  const bool plain = caseFolder.find_first_of(" \t\n'\"\\$`&|;<>()*?!#~") == std::string::npos;
  const std::string word = plain ? caseFolder : "\"" + caseFolder + "\"";
  std::cerr << "Wrote " << caseFolder << "; next: insonate-cli check " << word << '\n';
}

CLI::Validator notEmpty() {
  return {[](std::string& text) { return text.empty() ? std::string("the name is empty") : std::string(); }, ""};
}

Progress terminalProgress() {
  const bool shown = ::isatty(STDERR_FILENO);
  return [shown](std::string_view doing, double fraction) {
    if (shown) {
      std::fprintf(stderr, "\r\033[K%.*s %3.0f %%", static_cast<int>(doing.size()), doing.data(), fraction * 100);
      if (fraction >= 1) std::fprintf(stderr, "\r\033[K");
      std::fflush(stderr);
    }
    return interruptSignal() == 0;
  };
}

}  // namespace insonate::cli
