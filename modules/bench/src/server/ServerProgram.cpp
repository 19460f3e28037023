#include "server/ServerProgram.h"

#include "server/Browser.h"
#include "server/ChildProcess.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <thread>
#include <utility>

namespace insonate::bench {
namespace {

using Clock = std::chrono::steady_clock;

/// A port of loopback that is free now.
int freePort() {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* general = reinterpret_cast<sockaddr*>(&address);
  const bool found = socket >= 0 && ::bind(socket, general, size) == 0 && ::getsockname(socket, general, &size) == 0;
  if (socket >= 0) ::close(socket);
  return found ? ntohs(address.sin_port) : 8443;
}

std::string lastLineOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string last;
  for (std::string line; std::getline(in, line);) last = line;
  return last;
}

double secondsOf(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ServerProgram::ServerProgram(std::filesystem::path program, std::vector<std::string> arguments,
                             std::filesystem::path log)
    : program_(std::move(program)), log_(std::move(log)), arguments_(std::move(arguments)) {
  const std::string address = "127.0.0.1:" + std::to_string(freePort());
  arguments_.insert(arguments_.begin(), program_.string());
  arguments_.insert(arguments_.end(), {"--listen", address});
  url_ = "http://" + address;
}

ServerProgram::~ServerProgram() {
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  wait();
}

Result<void> ServerProgram::start() {
  const auto begun = Clock::now();
  const int log = ::open(log_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  const auto started = startProcess(arguments_, log);
  if (log >= 0) ::close(log);
  if (!started) return tl::unexpected(started.error());
  process_ = *started;
  constexpr std::chrono::seconds kLongest(60);
  Browser browser(url_, 0);
  while (Clock::now() - begun < kLongest) {
    if (::waitpid(process_, nullptr, WNOHANG) == process_) {
      process_ = -1;
      return fail(program_.string() + " does not start: " + lastLineOf(log_));
    }
    if (const auto answer = browser.get("/sign-in"); answer && answer->status == 200) {
      slowestStart_s_ = std::max(slowestStart_s_, std::chrono::duration<double>(Clock::now() - begun).count());
      return {};
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return fail(program_.string() + " does not answer at " + url_ + ".");
}

void ServerProgram::wait() {
  rusage used{};
  ::wait4(process_, nullptr, 0, &used);
  earlier_s_ += secondsOf(used.ru_utime) + secondsOf(used.ru_stime);
  process_ = -1;
}

void ServerProgram::kill() {
  if (process_ <= 0) return;
  ::kill(process_, SIGKILL);
  wait();
}

double ServerProgram::processor_s() const {
  std::ifstream in("/proc/" + std::to_string(process_) + "/stat");
  std::string text;
  std::getline(in, text);
  // Fields 14 and 15 (proc(5)) are counted from the name's closing parenthesis, since the name may contain spaces.
  constexpr int kBefore = 11;
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 2)));
  std::string skipped;
  for (int i = 0; i < kBefore; ++i) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return earlier_s_ + (user + system) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

double ServerProgram::memory_MB() const {
  std::ifstream in("/proc/" + std::to_string(process_) + "/status");
  for (std::string name; in >> name;) {
    double kB = 0;
    if (name == "VmHWM:" && in >> kB) return kB / 1024;
  }
  return 0;
}

}  // namespace insonate::bench
