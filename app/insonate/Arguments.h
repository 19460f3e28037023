#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace insonate::app {

struct Arguments {
  std::string caseFolder;            ///< or a DICOM folder, a file or a recorded attempt; empty for the built-in neck
  std::string workspace;             ///< empty for the one shown last
  std::filesystem::path screenshot;  ///< empty: no screenshot
  std::filesystem::path benchmark;   ///< folder for a table of speeds; empty: none
  std::string database;              ///< empty: the user's own
  std::string person;                ///< who signs in; empty: nobody
  bool quick = false;                ///< moments of benchmark instead of seconds
  bool untilImage = false;           ///< leave with the first live image
  int width_px = 1600, height_px = 1000;
};

/// The arguments, or the status to leave with: 0 after --help, 2 for wrong usage, which has been said.
std::variant<Arguments, int> parseArguments(int argc, char** argv);

}  // namespace insonate::app
