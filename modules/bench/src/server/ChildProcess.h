#pragma once

#include <insonate/core/Result.h>

#include <sys/types.h>

#include <string>
#include <vector>

namespace insonate::bench {

/// Starts a program (file and arguments) as a child process, whose output goes to the file descriptor `output`; -1: to
/// the output of this process. The child has none of the other files and sockets of this process: it would keep
/// connections of the bench open, and a database with 1000 inherited descriptors refuses to start.
Result<pid_t> startProcess(std::vector<std::string> command, int output = -1);

/// Runs a command of the shell and waits for its end; fails if its exit status is not 0.
Result<void> runInShell(const std::string& command);

}  // namespace insonate::bench
