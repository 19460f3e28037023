#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>

#include <string>

namespace insonate::cli {

/// Exit status of the program: 0 done, 1 refused with a clear reason, 2 wrong usage (ARCHITECTURE.md).
struct Outcome {
  int status = 0;
};

/// A command prints its JSON object when --json was given; messages go to standard error.
void addPhantomCommand(CLI::App& app, Outcome& outcome);
void addImportCommand(CLI::App& app, Outcome& outcome);
void addCheckCommand(CLI::App& app, Outcome& outcome);
void addRenderCommand(CLI::App& app, Outcome& outcome);
void addBenchCommand(CLI::App& app, Outcome& outcome);

/// Prints the error's sentence to standard error and sets status 1.
void refuse(Outcome& outcome, const Error& error);
/// Prints one JSON object, with the program's version added, to standard output.
void printJson(nlohmann::json object);
/// A progress line on standard error when that is a terminal, nothing otherwise.
Progress terminalProgress();

}  // namespace insonate::cli
