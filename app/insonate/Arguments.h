#pragma once

#include <filesystem>
#include <string>
#include <variant>

namespace insonate::app {

struct Arguments {
  std::string caseFolder;  ///< a case folder, DICOM folder, volume file or recorded attempt; empty: the built-in neck
  std::string workspace;   ///< empty: the workspace shown last
  std::filesystem::path screenshot;  ///< empty: no screenshot
  std::filesystem::path benchmark;   ///< folder for the benchmark's tables; empty: no benchmark
  std::string database;              ///< empty: the user's own store
  std::string person;                ///< name of the user who signs in; empty: nobody signs in
  bool quick = false;                ///< benchmark takes moments instead of seconds
  bool untilImage = false;           ///< exit after the first live image
  int width_px = 1600, height_px = 1000;
};

/// Returns the arguments, or the exit status: 0 after --help, 2 for wrong usage (the message is already printed).
std::variant<Arguments, int> parseArguments(int argc, char** argv);

}  // namespace insonate::app
