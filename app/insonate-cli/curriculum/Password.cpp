#include "Password.h"

#include "../Interrupt.h"

#include <insonate/core/Progress.h>

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <optional>

namespace insonate::cli {
namespace {

/// The terminal that the program was started from, which does not show what is typed while this lives.
class SilentTerminal {
 public:
  SilentTerminal() : terminal_(::open("/dev/tty", O_RDWR | O_CLOEXEC)) {
    if (terminal_ < 0 || ::tcgetattr(terminal_, &before_) != 0) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ready_ = ::tcsetattr(terminal_, TCSAFLUSH, &silent) == 0;
  }
  ~SilentTerminal() {
    if (ready_) ::tcsetattr(terminal_, TCSAFLUSH, &before_);
    if (terminal_ >= 0) ::close(terminal_);
  }
  SilentTerminal(const SilentTerminal&) = delete;
  SilentTerminal& operator=(const SilentTerminal&) = delete;

  bool isThere() const { return ready_; }
  void say(const std::string& text) const { (void)!::write(terminal_, text.data(), text.size()); }
  /// None once it was interrupted or closed.
  std::optional<std::string> line() const {
    std::string typed;
    for (char letter = 0;;) {
      pollfd waiting{terminal_, POLLIN, 0};
      // Unlike read(), poll() comes back from a signal.
      if (::poll(&waiting, 1, -1) < 0 || interruptSignal() != 0 || ::read(terminal_, &letter, 1) != 1)
        return std::nullopt;
      if (letter == '\n') return typed;
      typed += letter;
    }
  }

 private:
  int terminal_ = -1;
  bool ready_ = false;
  termios before_{};
};

Result<std::string> ask(const PasswordSource& source) {
  const SilentTerminal terminal;
  if (!terminal.isThere())
    return fail("No password was given. Put it into the environment variable " + std::string(source.variable) +
                " or into a file (see --help), or run the command in a terminal, which asks for it.");
  const auto typed = [&](const std::string& prompt) {
    terminal.say(prompt + ": ");
    auto line = terminal.line();
    terminal.say("\n");
    return line;
  };
  auto password = typed(source.prompt);
  if (!password) return fail(std::string(kCancelled));
  if (source.twice) {
    const auto again = typed("Repeat the password");
    if (!again) return fail(std::string(kCancelled));
    if (*again != *password) return fail("The two passwords differ; nothing was changed.");
  }
  return *std::move(password);
}

}  // namespace

Result<std::string> readPassword(const PasswordSource& source) {
  if (source.file.empty()) {
    const char* given = std::getenv(source.variable);
    return given ? Result<std::string>(given) : ask(source);
  }
  std::ifstream stream(source.file);
  std::string line;
  if (!std::getline(stream, line)) return fail("No password can be read from " + source.file + ".");
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

}  // namespace insonate::cli
