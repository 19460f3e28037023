#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <string>
#include <utility>

namespace {

/// A screen that nobody sees, for as long as the tests of this process run. It picks a number that no other screen has,
/// and goes with the process. With INSONATE_TEST_SCREEN set, the tests use the DISPLAY there is. Where Xvfb is not
/// installed, every test of the process is skipped.
class VirtualScreen : public testing::Environment {
 public:
  void SetUp() override {
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    if (std::getenv("INSONATE_TEST_SCREEN")) return;
    int ready[2];
    ASSERT_EQ(pipe(ready), 0);
    server_ = fork();
    ASSERT_GE(server_, 0);
    if (server_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGTERM);
      close(ready[0]);
      const std::string number = std::to_string(ready[1]);
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1920x1200x24", "-nolisten", "tcp",
             "-noreset", static_cast<char*>(nullptr));
      _exit(kNotInstalled);
    }
    close(ready[1]);
    std::string number;
    for (char digit = 0; read(ready[0], &digit, 1) == 1 && digit != '\n';) number += digit;
    close(ready[0]);
    if (number.empty()) {
      int status = 0;
      waitpid(std::exchange(server_, -1), &status, 0);
      if (WIFEXITED(status) && WEXITSTATUS(status) == kNotInstalled)
        GTEST_SKIP() << "no virtual screen: Xvfb is not installed (Debian: xvfb)";
      FAIL() << "no virtual screen: Xvfb did not start";
    }
    setenv("DISPLAY", (":" + number).c_str(), 1);
  }

  void TearDown() override {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }

 private:
  static constexpr int kNotInstalled = 127;

  pid_t server_ = -1;
};

[[maybe_unused]] const auto* const kScreen = testing::AddGlobalTestEnvironment(new VirtualScreen);

}  // namespace
