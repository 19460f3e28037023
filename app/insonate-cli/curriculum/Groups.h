#pragma once

#include "../Commands.h"

namespace insonate::cli {

// These functions add groups of commands to `insonate-cli curriculum`.
void addPeopleCommands(CLI::App& curriculum, Outcome& outcome);
void addClassCommands(CLI::App& curriculum, Outcome& outcome);
void addClassImport(CLI::App& classes, Outcome& outcome);
void addTestCommands(CLI::App& curriculum, Outcome& outcome);
void addLevelsCommand(CLI::App& curriculum, Outcome& outcome);
void addCurriculaCommands(CLI::App& curriculum, Outcome& outcome);
void addCommentCommands(CLI::App& attempts, Outcome& outcome);
void addAttemptCommands(CLI::App& curriculum, Outcome& outcome);
void addPersonStatistics(CLI::App& statistics, Outcome& outcome);
void addClassStatistics(CLI::App& statistics, Outcome& outcome);
void addFormCommands(CLI::App& curriculum, Outcome& outcome);
void addJudgementCommands(CLI::App& forms, Outcome& outcome);
void addExportCommands(CLI::App& curriculum, Outcome& outcome);
void addUpkeepCommands(CLI::App& curriculum, Outcome& outcome);
void addVerifyCommand(CLI::App& curriculum, Outcome& outcome);
void addSendCommand(CLI::App& curriculum, Outcome& outcome);
void addRetentionCommands(CLI::App& curriculum, Outcome& outcome);
void addWorkstationCommands(CLI::App& curriculum, Outcome& outcome);
void addUploadCommand(CLI::App& curriculum, Outcome& outcome);
void addDemoCommand(CLI::App& curriculum, Outcome& outcome);

}  // namespace insonate::cli
