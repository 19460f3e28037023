#include "Commands.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/PatientCase.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace insonate::cli {
namespace {

struct CheckArguments {
  std::string folder;
  bool asJson = false;
};

nlohmann::json toJson(const std::vector<Finding>& findings) {
  nlohmann::json rows = nlohmann::json::array();
  for (const Finding& f : findings)
    rows.push_back({{"severity", nameOf(f.severity)}, {"code", f.code}, {"text", f.text}});
  return {{"fit", isFit(findings)}, {"findings", rows}};
}

void print(const std::vector<Finding>& findings, bool asJson) {
  if (!asJson) {
    for (const Finding& f : findings)
      std::printf("%-7s  %-18s %s\n", std::string(nameOf(f.severity)).c_str(), f.code.c_str(), f.text.c_str());
    std::printf("%s\n", isFit(findings) ? "This case is fit for training." : "This case is not fit for training.");
    return;
  }
  printJson(toJson(findings));
}

Result<void> check(const CheckArguments& a) {
  const auto read = readCase(a.folder);
  if (!read) return tl::unexpected(read.error());
  auto findings = checkCase(read->patient, terminalProgress());
  if (!findings) return tl::unexpected(findings.error());
  for (const std::string& note : read->notes) findings->push_back({Severity::kInfo, "read_note", note});
  print(*findings, a.asJson);
  return {};
}

}  // namespace

void addCheckCommand(CLI::App& app, Outcome& outcome) {
  auto* command = app.add_subcommand(
      "check", "Is this case fit for training, and what is missing (exit status 1 only when it cannot be read)");
  auto a = std::make_shared<CheckArguments>();
  command->add_option("CASE", a->folder, "Folder of the case")->required()->check(notEmpty());
  command->add_flag("--json", a->asJson, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->asJson;
    if (auto done = check(*a); !done)
      refuse(outcome, done.error(), toJson({{Severity::kError, "unreadable", done.error().message}}));
  });
}

}  // namespace insonate::cli
