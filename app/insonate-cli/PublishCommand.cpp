#include "Commands.h"

#include <insonate/cases/CaseCheck.h>
#include <insonate/cases/CaseVersions.h>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <memory>

namespace insonate::cli {
namespace {

struct PublishArguments {
  std::string folder;
  bool json = false;
};

/// Fails if a finding keeps trainees from working with the case; like the window's button, the command does not
/// override it.
Result<void> checkIsFit(const PatientCase& patient, const std::string& folder) {
  const auto findings = checkCase(patient, terminalProgress());
  if (!findings) return tl::unexpected(findings.error());
  if (isFitForTraining(*findings)) return {};
  std::string reasons;
  for (const Finding& finding : *findings)
    if (finding.severity == FindingSeverity::kError) reasons += "\n  " + finding.text;
  return fail("The case " + folder + " was not published, because it is not fit for training:" + reasons);
}

Result<void> publish(const PublishArguments& a) {
  if (const auto whole = caseOfVersion(a.folder))
    return fail(a.folder + " is an earlier version of " + whole->string() + ". Name that case.");
  const auto read = readCase(a.folder);
  if (!read) return tl::unexpected(read.error());
  if (auto ok = checkIsFit(read->patient, a.folder); !ok) return ok;
  const auto version = publishCase(read->patient, a.folder, today(), terminalProgress());
  if (!version) return tl::unexpected(version.error());
  if (a.json)
    printJson({{"case", a.folder}, {"published", version->number}, {"folder", caseForTraining(a.folder).string()}});
  else
    std::printf("Trainees get version %d of %s from now on.\n", version->number, a.folder.c_str());
  return {};
}

}  // namespace

void addPublishCommand(CLI::App& app, Outcome& outcome) {
  auto* command =
      app.add_subcommand("publish", "Publish the present state of a case for trainees; later changes do not affect it");
  auto a = std::make_shared<PublishArguments>();
  command->add_option("CASE", a->folder, "Folder of the case")->required()->check(notEmpty());
  command->add_flag("--json", a->json, "Print one JSON object");
  command->callback([a, &outcome] {
    outcome.json = a->json;
    if (auto done = publish(*a); !done) refuse(outcome, done.error());
  });
}

}  // namespace insonate::cli
