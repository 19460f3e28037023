#pragma once

#include <insonate/core/Result.h>

#include <sys/types.h>

#include <filesystem>
#include <string>
#include <vector>

namespace insonate::bench {

/// insonate-server as a child process, which can be killed and started again at the same address. For one thread.
class ServerProgram {
 public:
  /// `program`: file of insonate-server; `arguments`: its arguments without --listen; `log`: file for its log.
  ServerProgram(std::filesystem::path program, std::vector<std::string> arguments, std::filesystem::path log);
  /// Asks the process to end, and waits for it.
  ~ServerProgram();
  ServerProgram(const ServerProgram&) = delete;
  ServerProgram& operator=(const ServerProgram&) = delete;

  /// Starts the process, and waits until it serves. Fails with the last line of its log if it ends instead, or does not
  /// serve within 60 s.
  Result<void> start();
  /// Ends the process at once (SIGKILL).
  void kill();

  const std::string& url() const { return url_; }
  /// Processor time of the process and of its killed predecessors.
  double processor_s() const;
  /// Largest resident memory of the process.
  double memory_MB() const;
  double slowestStart_s() const { return slowestStart_s_; }

 private:
  void wait();

  const std::filesystem::path program_, log_;
  std::vector<std::string> arguments_;
  std::string url_;
  pid_t process_ = -1;
  double earlier_s_ = 0;  ///< processor time of killed processes
  double slowestStart_s_ = 0;
};

}  // namespace insonate::bench
