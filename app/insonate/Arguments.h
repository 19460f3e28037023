#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace insonate::app {

struct Arguments {
  std::string caseFolder;  ///< data to open: a case folder, DICOM folder, volume file or recorded attempt; empty: the
                           ///< built-in neck
  std::string workspace;   ///< workspace to show; empty: the workspace shown last
  std::filesystem::path screenshot;  ///< file for a screenshot of the window; empty: none
  std::filesystem::path benchmark;   ///< folder for the results of the window benchmark; empty: no benchmark
  std::string database;              ///< file of the curriculum database; empty: the user's own database file
  std::string person;                ///< name of the user to sign in; empty: none
  bool quick = false;       ///< true: the benchmark takes less than a second per measurement, without meaningful values
  bool untilImage = false;  ///< true: the program exits after the first live image
  int width_px = 1600, height_px = 1000;
};

/// Parses the command line. Returns the arguments, or the exit status of the program: 0 after --help, 2 for wrong usage
/// (the message is already printed).
std::variant<Arguments, int> parseArguments(int argc, char** argv);

}  // namespace insonate::app
