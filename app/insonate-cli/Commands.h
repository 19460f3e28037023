#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace insonate::cli {

/// Exit status of the program: 0 done, 1 refused with a clear reason, 2 wrong usage, 130 or 143 cancelled by Ctrl-C or
/// SIGTERM.
struct Outcome {
  int status = 0;
  bool json = false;  ///< the command was asked for JSON, which it gives also when it refuses
};

/// A command prints its JSON object when --json was given; messages go to standard error.
void addPhantomCommand(CLI::App& app, Outcome& outcome);
void addImportCommand(CLI::App& app, Outcome& outcome);
void addImportLabelsCommand(CLI::App& app, Outcome& outcome);
void addExportCommand(CLI::App& app, Outcome& outcome);
void addCropCommand(CLI::App& app, Outcome& outcome);
void addCheckCommand(CLI::App& app, Outcome& outcome);
void addPublishCommand(CLI::App& app, Outcome& outcome);
void addRenderCommand(CLI::App& app, Outcome& outcome);
void addBenchCommand(CLI::App& app, Outcome& outcome);
void addSurfacesCommand(CLI::App& app, Outcome& outcome);
void addFitCommand(CLI::App& app, Outcome& outcome);
void addDevicesCommand(CLI::App& app, Outcome& outcome);
void addMachinesCommand(CLI::App& app, Outcome& outcome);
void addSessionCommand(CLI::App& app, Outcome& outcome);
void addReplayCommand(CLI::App& app, Outcome& outcome);
void addLabelCommand(CLI::App& app, Outcome& outcome);
void addCurriculumCommand(CLI::App& app, Outcome& outcome);

/// Prints the error's sentence to standard error, sets the status, and prints {"error": ...} with `fields` where JSON
/// was asked for.
void refuse(Outcome& outcome, const Error& error, const nlohmann::json& fields);
void refuse(Outcome& outcome, const Error& error);
/// Prints one JSON object, with the program's version added, to standard output. Names need not be UTF-8.
void printJson(nlohmann::json object);
/// Array of x, y and z.
nlohmann::json jsonArray(Vec3 v);
/// Writes a case; where one is there already, that stays as an earlier version, for attempts that were made on it.
Result<void> writeOrReplace(const PatientCase& patient, const std::string& caseFolder);
/// Prints the possible next steps with a case that was just written, to standard error.
void printNextSteps(const std::string& caseFolder);
/// Refuses an empty name as wrong usage.
CLI::Validator notEmpty();
/// Asks for cancellation after Ctrl-C; a progress line on standard error when that is a terminal.
Progress terminalProgress();

}  // namespace insonate::cli
