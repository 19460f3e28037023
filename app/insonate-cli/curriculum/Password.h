#pragma once

#include <insonate/core/Result.h>

#include <string>

namespace insonate::cli {

/// Source of a password: never the command line, which others can read.
struct PasswordSource {
  std::string file;      ///< its first line; "/dev/fd/3" for a descriptor; "": none named
  const char* variable;  ///< of the environment, where no file is named
  std::string prompt;    ///< on the terminal, without echo, where there is neither
  bool twice = false;    ///< since nobody sees what they type
};

Result<std::string> readPassword(const PasswordSource& source);

}  // namespace insonate::cli
