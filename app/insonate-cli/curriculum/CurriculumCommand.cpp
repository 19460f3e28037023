#include "Groups.h"

namespace insonate::cli {

void addCurriculumCommand(CLI::App& app, Outcome& outcome) {
  CLI::App& curriculum =
      *app.add_subcommand("curriculum", "Manage people, classes, levels and attempts, and print their statistics");
  curriculum.require_subcommand(1);
  addPeopleCommands(curriculum, outcome);
  addClassCommands(curriculum, outcome);
  addCurriculaCommands(curriculum, outcome);
  addLevelsCommand(curriculum, outcome);
  addTestCommands(curriculum, outcome);
  addAttemptCommands(curriculum, outcome);
  CLI::App& statistics = *curriculum.add_subcommand("statistics", "Print statistics of people and classes");
  statistics.require_subcommand(1);
  addPersonStatistics(statistics, outcome);
  addClassStatistics(statistics, outcome);
  addFormCommands(curriculum, outcome);
  addExportCommands(curriculum, outcome);
  addSendCommand(curriculum, outcome);
  addUpkeepCommands(curriculum, outcome);
  addRetentionCommands(curriculum, outcome);
  addWorkstationCommands(curriculum, outcome);
  addUploadCommand(curriculum, outcome);
  addDemoCommand(curriculum, outcome);
}

}  // namespace insonate::cli
