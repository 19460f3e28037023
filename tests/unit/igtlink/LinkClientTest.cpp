#include "PlainSocket.h"

#include <insonate/igtlink/LinkClient.h>

#include <gmock/gmock.h>

#include <mutex>
#include <random>

namespace insonate {
namespace {

using test::Bytes;
using test::PlainSocket;

/// Collects the poses that a client reports.
class PoseLog {
 public:
  LinkClient::Listener listener() {
    return [this](const std::vector<LinkToolPose>& poses, const std::string&) {
      const std::scoped_lock lock(mutex_);
      poses_.insert(poses_.end(), poses.begin(), poses.end());
      ++calls_;
    };
  }
  std::vector<LinkToolPose> poses() const {
    const std::scoped_lock lock(mutex_);
    return poses_;
  }
  int calls() const {
    const std::scoped_lock lock(mutex_);
    return calls_;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<LinkToolPose> poses_;
  int calls_ = 0;
};

bool becomesConnected(const LinkClient& client) {
  return test::waitUntil([&] { return client.status().phase == LinkPhase::kConnected; });
}

TEST(LinkClient, TakesPosesOfAllKindsOfMessages) {
  const PlainSocket listening = PlainSocket::listening();
  PoseLog log;
  const LinkClient client("localhost", listening.port(), log.listener());
  const PlainSocket server = listening.accepted();
  ASSERT_TRUE(server.isOpen());
  const auto request = server.readMessage();
  ASSERT_TRUE(request);
  EXPECT_EQ(request->type, "STT_TDATA");
  EXPECT_EQ(request->body.size(), 36U);
  EXPECT_TRUE(request->crcFits);
  Bytes tool;
  test::putText(tool, "Needle", 20);
  test::put(tool, 0x0200, 2);
  test::append(tool, test::transformBody(4, 5, 6));
  ASSERT_TRUE(server.write(test::message(1, "TRANSFORM", "ProbeToTracker", test::transformBody(1, 2, 3))));
  ASSERT_TRUE(server.write(test::message(1, "VIDEO", "Video", Bytes(500'000))));
  ASSERT_TRUE(server.write(test::message(2, "TDATA", "Tracker", test::extendedBody(tool))));
  ASSERT_TRUE(test::waitUntil([&] { return log.poses().size() == 2; }));
  EXPECT_EQ(log.poses()[0].name, "ProbeToTracker");
  EXPECT_EQ(log.poses()[0].trackerFromTool.offset, (Vec3{1, 2, 3}));
  EXPECT_EQ(log.poses()[1].name, "Needle");
  EXPECT_EQ(log.poses()[1].trackerFromTool.offset, (Vec3{4, 5, 6}));
  const LinkClientStatus status = client.status();
  EXPECT_EQ(status.phase, LinkPhase::kConnected);
  EXPECT_EQ(status.counters.skipped, 1U);
  ASSERT_EQ(status.tools.size(), 2U);
  EXPECT_EQ(status.tools[0].name, "ProbeToTracker");
  EXPECT_EQ(status.tools[0].rate_Hz, 1);
}

TEST(LinkClient, ConnectsAgain) {
  auto listening = std::make_unique<PlainSocket>(PlainSocket::listening());
  const int port = listening->port();
  PoseLog log;
  const LinkClient client("127.0.0.1", port, log.listener());
  {
    const PlainSocket server = listening->accepted();
    ASSERT_TRUE(becomesConnected(client));
    ASSERT_TRUE(server.write(test::message(1, "TRANSFORM", "A", test::transformBody(1, 0, 0))));
    ASSERT_TRUE(test::waitUntil([&] { return log.poses().size() == 1; }));
    listening.reset();
  }
  ASSERT_TRUE(test::waitUntil([&] { return client.status().error.starts_with("No program accepts connections at"); }));
  EXPECT_TRUE(client.status().tools.empty());
  listening = std::make_unique<PlainSocket>(PlainSocket::listening(port));
  ASSERT_TRUE(listening->isOpen());
  const PlainSocket server = listening->accepted();
  ASSERT_TRUE(becomesConnected(client));
  EXPECT_EQ(client.status().connections, 2);
  ASSERT_TRUE(server.write(test::message(1, "TRANSFORM", "B", test::transformBody(1, 0, 0))));
  ASSERT_TRUE(test::waitUntil([&] { return log.poses().size() == 2; }));
}

TEST(LinkClient, SaysWhyThereIsNoConnection) {
  const int port = PlainSocket::listening().port();  // closed again
  const LinkClient closed("127.0.0.1", port, [](const std::vector<LinkToolPose>&, const std::string&) {});
  const LinkClient unknown("no-such-host.invalid", port, [](const std::vector<LinkToolPose>&, const std::string&) {});
  ASSERT_TRUE(test::waitUntil([&] { return !closed.status().error.empty(); }));
  EXPECT_EQ(closed.status().error, "No program accepts connections at 127.0.0.1:" + std::to_string(port) +
                                       ". Start the tracker's server there, or check the port.");
  ASSERT_TRUE(test::waitUntil([&] { return !unknown.status().error.empty(); }));
  EXPECT_EQ(unknown.status().error, "The computer 'no-such-host.invalid' is not known. Check its name or address.");
}

TEST(LinkClient, CallsItsListenerWhenPosesStop) {
  const PlainSocket listening = PlainSocket::listening();
  PoseLog log;
  const LinkClient client("127.0.0.1", listening.port(), log.listener());
  const PlainSocket server = listening.accepted();
  ASSERT_TRUE(becomesConnected(client));
  const int calls = log.calls();
  EXPECT_TRUE(test::waitUntil([&] { return log.calls() > calls + 2; }));
}

TEST(LinkClient, ReportsAServerThatDoesNotSpeakOpenIgtLink) {
  const PlainSocket listening = PlainSocket::listening();
  const LinkClient client("127.0.0.1", listening.port(), [](const std::vector<LinkToolPose>&, const std::string&) {});
  const PlainSocket server = listening.accepted();
  Bytes page;
  test::putText(page, "HTTP/1.1 400 Bad Request\r\nContent-Length: 0\r\nConnection: close\r\n\r\n", 70);
  ASSERT_TRUE(server.write(page));
  EXPECT_TRUE(test::waitUntil([&] {
    return client.status().error == "The other program does not speak OpenIGTLink: it sent a header that is not valid.";
  }));
}

/// Names that never repeat do not fill the memory, and random bytes do not end the client.
TEST(LinkClient, SurvivesARandomServer) {
  const PlainSocket listening = PlainSocket::listening();
  PoseLog log;
  const LinkClient client("127.0.0.1", listening.port(), log.listener());
  {
    const PlainSocket server = listening.accepted();
    for (int i = 0; i < 1000; ++i)
      ASSERT_TRUE(
          server.write(test::message(1, "TRANSFORM", "Tool" + std::to_string(i), test::transformBody(1, 0, 0))));
    ASSERT_TRUE(test::waitUntil([&] { return log.poses().size() == 1000; }));
    EXPECT_LE(client.status().tools.size(), 64U);
  }
  std::mt19937 random(99);
  for (int round = 0; round < 3; ++round) {
    const PlainSocket server = listening.accepted();
    ASSERT_TRUE(server.isOpen());
    for (int i = 0; i < 200; ++i) {
      Bytes bytes = test::message(1 + i % 2, "TDATA", "T", Bytes(70 + i % 3));
      if (i > 20) bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      if (!server.write(bytes)) break;
    }
  }
  const PlainSocket server = listening.accepted();
  ASSERT_TRUE(server.write(test::message(1, "TRANSFORM", "Last", test::transformBody(1, 0, 0))));
  EXPECT_TRUE(test::waitUntil([&] { return log.poses().back().name == "Last"; }));
}

}  // namespace
}  // namespace insonate
