#include "integration/CommandLine.h"
#include "support/SmallCase.h"
#include "support/TestData.h"
#include "unit/igtlink/PlainSocket.h"

#include <gmock/gmock.h>

#include <csignal>
#include <string>

namespace insonate::test {
namespace {

using testing::HasSubstr;

/// `insonate-cli link serve` in the background, until the end of the test.
class ServingCommand {
 public:
  ServingCommand(const std::string& arguments, const std::string& errorFile)
      : pipe_(::popen(
            (INSONATE_CLI " link serve " + arguments + " --port 0 2>" + shellWord(errorFile) + " & echo $!; wait $!")
                .c_str(),
            "r")),
        process_(std::stoi(readLine())) {}
  ServingCommand(const ServingCommand&) = delete;
  ServingCommand& operator=(const ServingCommand&) = delete;
  ~ServingCommand() { stop(); }

  /// Port that the command prints; 0 if it ends before.
  int port() {
    const std::string line = readLine();
    const std::size_t at = line.find("127.0.0.1:");
    return at == std::string::npos ? 0 : std::stoi(line.substr(at + 10));
  }
  /// Sends SIGTERM, and returns the exit status.
  int stop() {
    if (!pipe_) return -1;
    kill(process_, SIGTERM);
    const int status = ::pclose(std::exchange(pipe_, nullptr));
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

 private:
  std::string readLine() {
    std::string line;
    for (int c = std::fgetc(pipe_); c != EOF && c != '\n'; c = std::fgetc(pipe_)) line += static_cast<char>(c);
    return line;
  }

  std::FILE* pipe_;
  pid_t process_;
};

TEST(LinkCommand, ServesLiveImagesAndObeysCommands) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeCase(smallCase(), folder / "case"));
  ServingCommand command(shellWord(folder / "case") + " --orbit", folder / "errors.txt");
  const int port = command.port();
  ASSERT_GT(port, 0) << bytesOf(folder / "errors.txt");
  const PlainSocket client = PlainSocket::connectedTo(port);
  ASSERT_TRUE(client.isOpen());
  const auto first = client.readMessage("TRANSFORM");
  ASSERT_TRUE(first);
  EXPECT_EQ(first->device, "ProbeToReference");
  const auto image = client.readMessage("IMAGE");
  ASSERT_TRUE(image);
  EXPECT_EQ(image->body.size(), 72U + 820 * 616);
  // The probe moves.
  auto later = client.readMessage("TRANSFORM");
  for (int i = 0; i < 60 && later->body == first->body; ++i) later = client.readMessage("TRANSFORM");
  EXPECT_NE(later->body, first->body);
  ASSERT_TRUE(client.write(message(2, "STRING", "CMD_3",
                                   extendedBody(stringBody("<Command Name=\"SetUsParameter\"><Parameter "
                                                           "Name=\"DepthMm\" Value=\"55\"/></Command>")))));
  const auto reply = client.readMessage("STRING");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->device, "ACK_3");
  EXPECT_THAT(reply->text(), HasSubstr("Status=\"SUCCESS\" Message=\"DepthMm is 55.\""));
  EXPECT_EQ(command.stop(), 128 + SIGTERM);
}

TEST(LinkCommand, RefusesAPortInUseAndWrongOptions) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeCase(smallCase(), folder / "case"));
  const PlainSocket taken = PlainSocket::listening();
  const auto used = runCommand("link serve " + shellWord(folder / "case") + " --port " + std::to_string(taken.port()),
                               folder / "errors.txt");
  EXPECT_EQ(used.status, 1);
  EXPECT_THAT(used.errors, HasSubstr("is used by another program. Choose another port."));
  EXPECT_EQ(
      runCommand("link serve " + shellWord(folder / "case") + " --orbit --script a", folder / "errors.txt").status, 2);
  EXPECT_EQ(runCommand("link serve " + shellWord(folder / "case") + " --port 70000", folder / "errors.txt").status, 2);
  EXPECT_EQ(runCommand("link", folder / "errors.txt").status, 2);
}

}  // namespace
}  // namespace insonate::test
