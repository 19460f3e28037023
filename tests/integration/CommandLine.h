#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace insonate::test {

/// Outcome of a run of insonate-cli.
struct CommandResult {
  int status = -1;
  std::string output;  ///< standard output
  std::string errors;  ///< standard error
};

/// One word for the shell, whatever is in it.
inline std::string shellWord(const std::string& text) {
  std::string result = "'";
  for (const char c : text) c == '\'' ? result += "'\\''" : result += c;
  return result + "'";
}

inline std::string readAll(std::FILE* stream) {
  std::string text;
  char buffer[4096];
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, stream)) > 0;) text.append(buffer, n);
  return text;
}

/// Runs `prefix insonate-cli arguments` in a shell; `errorFile` takes standard error.
inline CommandResult runCommand(const std::string& arguments, const std::string& errorFile,
                                const std::string& prefix = "") {
  CommandResult result;
  std::FILE* pipe = ::popen((prefix + INSONATE_CLI " " + arguments + " 2>" + shellWord(errorFile)).c_str(), "r");
  if (!pipe) {
    ADD_FAILURE() << "no shell";
    return result;
  }
  result.output = readAll(pipe);
  const int status = ::pclose(pipe);
  result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (std::FILE* errors = std::fopen(errorFile.c_str(), "r")) {
    result.errors = readAll(errors);
    std::fclose(errors);
  }
  return result;
}

}  // namespace insonate::test
