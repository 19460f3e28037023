#include "server/ChildProcess.h"

#include <linux/close_range.h>
#include <sys/wait.h>
#include <unistd.h>

#include <utility>

namespace insonate::bench {

Result<pid_t> startProcess(std::vector<std::string> command, int output) {
  // Allocated before fork(), after which only the calling thread goes on.
  std::vector<char*> arguments;
  for (std::string& argument : command) arguments.push_back(argument.data());
  arguments.push_back(nullptr);
  const pid_t process = ::fork();
  if (process < 0) return fail("No process can be started. Close other programs and try again.");
  if (process > 0) return process;
  if (output >= 0) ::dup2(output, STDOUT_FILENO), ::dup2(output, STDERR_FILENO);
  ::close_range(STDERR_FILENO + 1, ~0U, CLOSE_RANGE_CLOEXEC);
  ::execv(arguments.front(), arguments.data());
  ::_exit(127);
}

Result<void> runInShell(const std::string& command) {
  const auto process = startProcess({"/bin/sh", "-c", command});
  if (!process) return tl::unexpected(process.error());
  int status = 0;
  if (::waitpid(*process, &status, 0) == *process && WIFEXITED(status) && WEXITSTATUS(status) == 0) return {};
  return fail("The command failed: " + command);
}

}  // namespace insonate::bench
