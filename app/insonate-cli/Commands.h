#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace insonate::cli {

/// Exit status of the program: 0 success, 1 failure with an error message, 2 wrong usage, 130 or 143 cancelled by
/// Ctrl-C or SIGTERM.
struct Outcome {
  int status = 0;
  bool json = false;  ///< the command was called with --json; errors are then JSON, too
};

/// Each of these functions adds a command. The command prints a JSON object if --json is given; messages go to standard
/// error.
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

/// Prints the error message to standard error and sets the exit status. If JSON was requested, also prints {"error":
/// ...} with `fields`.
void refuse(Outcome& outcome, const Error& error, const nlohmann::json& fields);
void refuse(Outcome& outcome, const Error& error);
/// Prints one JSON object, with the program's version added, to standard output. Names need not be UTF-8.
void printJson(nlohmann::json object);
/// Returns an array of x, y and z.
nlohmann::json jsonArray(Vec3 v);
/// Writes a case. A case that the folder already contains is kept as an earlier version, for the attempts that were
/// made on it.
Result<void> writeOrReplace(const PatientCase& patient, const std::string& caseFolder);
/// Prints, to standard error, the possible next steps with a case that was just written.
void printNextSteps(const std::string& caseFolder);
/// Rejects an empty name as wrong usage.
CLI::Validator notEmpty();
/// Reports progress on standard error if that is a terminal, and requests cancellation after Ctrl-C or SIGTERM.
Progress terminalProgress();

}  // namespace insonate::cli
