#pragma once

#include <insonate/core/Result.h>

#include <string>

namespace insonate::cli {

/// Sources from which a password is read: file, environment variable, terminal. (Other users of the computer could read
/// a password on the command line.)
struct PasswordSource {
  std::string file;      ///< file whose first line is the password; "/dev/fd/3" for a descriptor; "": no file
  const char* variable;  ///< name of the environment variable that contains the password; read if `file` is ""
  std::string prompt;    ///< prompt on the terminal, which asks without echo if neither file nor variable is given
  bool twice = false;    ///< true: the terminal asks twice, since typing is not shown
};

Result<std::string> readPassword(const PasswordSource& source);

}  // namespace insonate::cli
