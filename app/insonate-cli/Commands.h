#pragma once

#include <insonate/cases/PatientCase.h>
#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>
#include <insonate/core/Vec3.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace insonate::cli {

/// Exit status of the program: 0 success, 1 failure with an error message, 2 wrong usage, 3 done in part (see
/// curriculum/Answer.h), 130 or 143 cancelled by Ctrl-C or SIGTERM.
struct Outcome {
  int status = 0;
  bool json = false;  ///< true: the command was called with --json; errors are then printed as JSON, too
};

/// Adds the subcommand `phantom` to the command line; each function below adds one subcommand. With --json a subcommand
/// prints a JSON object; messages go to standard error.
void addPhantomCommand(CLI::App& app, Outcome& outcome);
void addImportCommand(CLI::App& app, Outcome& outcome);
void addImportLabelsCommand(CLI::App& app, Outcome& outcome);
void addExportCommand(CLI::App& app, Outcome& outcome);
void addCropCommand(CLI::App& app, Outcome& outcome);
void addCheckCommand(CLI::App& app, Outcome& outcome);
void addPrepareCommand(CLI::App& app, Outcome& outcome);
void addPublishCommand(CLI::App& app, Outcome& outcome);
void addRenderCommand(CLI::App& app, Outcome& outcome);
void addSpectrumCommand(CLI::App& app, Outcome& outcome);
void addBenchCommand(CLI::App& app, Outcome& outcome);
void addSurfacesCommand(CLI::App& app, Outcome& outcome);
void addFitCommand(CLI::App& app, Outcome& outcome);
void addDevicesCommand(CLI::App& app, Outcome& outcome);
void addMachinesCommand(CLI::App& app, Outcome& outcome);
void addSessionCommand(CLI::App& app, Outcome& outcome);
void addReplayCommand(CLI::App& app, Outcome& outcome);
void addVideoCommand(CLI::App& app, Outcome& outcome);
void addHandsCommand(CLI::App& app, Outcome& outcome);
void addLinkCommand(CLI::App& app, Outcome& outcome);
void addWireCommand(CLI::App& app, Outcome& outcome);
void addLabelCommand(CLI::App& app, Outcome& outcome);
void addCurriculumCommand(CLI::App& app, Outcome& outcome);

/// Ends a command with an error: prints the message to standard error and sets the exit status. With --json, also
/// prints {"error": ...} with `fields`.
void refuse(Outcome& outcome, const Error& error, const nlohmann::json& fields);
void refuse(Outcome& outcome, const Error& error);
/// Prints one JSON object, with the program's version added, to standard output. File names in it need not be UTF-8.
void printJson(nlohmann::json object);
/// Returns a vector as a JSON array of x, y and z.
nlohmann::json jsonArray(Vec3 v);
/// Writes a case to a folder. A case that the folder already contains is kept as an earlier version, since attempts may
/// have been made on it.
Result<void> writeOrReplace(const PatientCase& patient, const std::string& caseFolder);
/// Prints to standard error which commands can be used next on a case that was just written.
void printNextSteps(const std::string& caseFolder);
/// Returns a check of an option's value that rejects an empty text as wrong usage.
CLI::Validator notEmpty();
/// Returns a Progress that reports on standard error if that is a terminal, and cancels after Ctrl-C or SIGTERM.
Progress terminalProgress();

}  // namespace insonate::cli
