#include "PlainSocket.h"

#include <insonate/igtlink/LinkServer.h>

#include <gmock/gmock.h>

#include <algorithm>
#include <mutex>
#include <random>

namespace insonate {
namespace {

using test::Bytes;
using test::PlainSocket;
using testing::HasSubstr;
using testing::StartsWith;

std::unique_ptr<LinkServer> startedServer(LinkServer::CommandHandler handler = {}) {
  auto server = LinkServer::start({.port = 0}, std::move(handler));
  EXPECT_TRUE(server);
  return std::move(*server);
}

/// A frame whose gray values and x offset are `number`.
std::shared_ptr<const LinkFrame> numberedFrame(int number, int width = 64, int height = 48) {
  auto frame = std::make_shared<LinkFrame>();
  const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  frame->image = {"Image_Reference", width, height, {}, std::make_shared<const Bytes>(size, number % 256)};
  frame->transforms = {{"ProbeToReference", {{}, {double(number), 0, 0}}}};
  return frame;
}

LinkServer::CommandHandler echo() {
  return [](const LinkCommand& command, const LinkServer::Answer& answer) { answer({true, command.name, {}}); };
}

Bytes commandMessage(const std::string& device, const std::string& name = "Freeze") {
  return test::message(1, "STRING", device, test::stringBody("<Command Name=\"" + name + "\"/>"));
}

TEST(LinkServer, SendsTheLatestFrameToAProgramThatConnects) {
  const auto server = startedServer();
  server->post(numberedFrame(1));
  server->post(numberedFrame(2));
  const PlainSocket client = PlainSocket::connectedTo(server->port());
  const auto transform = client.readMessage(), image = client.readMessage();
  ASSERT_TRUE(transform && image);
  EXPECT_EQ(transform->version, 1);
  EXPECT_EQ(transform->type, "TRANSFORM");
  EXPECT_EQ(transform->device, "ProbeToReference");
  EXPECT_TRUE(transform->crcFits);
  EXPECT_EQ(transform->real(36), 2);
  EXPECT_EQ(image->type, "IMAGE");
  EXPECT_EQ(image->device, "Image_Reference");
  EXPECT_TRUE(image->crcFits);
  EXPECT_EQ(image->body.size(), 72U + 64 * 48);
  EXPECT_EQ(image->body.back(), 2);
  server->post(numberedFrame(3));
  const auto next = client.readMessage("IMAGE");
  ASSERT_TRUE(next);
  EXPECT_EQ(next->body.back(), 3);
}

TEST(LinkServer, ListensOnThisComputerOnlyUnlessToldOtherwise) {
  // The whole network 127.0.0.0/8 is this computer, but only 127.0.0.1 is the address of the server.
  const auto local = startedServer();
  EXPECT_TRUE(PlainSocket::connectedTo(local->port()).isOpen());
  EXPECT_FALSE(PlainSocket::connectedTo(local->port(), "127.0.0.2").isOpen());
  const auto any = LinkServer::start({.port = 0, .anyAddress = true});
  ASSERT_TRUE(any);
  EXPECT_TRUE(PlainSocket::connectedTo((*any)->port(), "127.0.0.2").isOpen());
}

TEST(LinkServer, SaysThatAPortIsInUse) {
  const auto server = startedServer();
  const auto second = LinkServer::start({.port = server->port()});
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().message,
            "The port " + std::to_string(server->port()) + " is used by another program. Choose another port.");
}

TEST(LinkServer, AnswersCommandsOfTwoProgramsEachItsOwn) {
  const auto server = startedServer(echo());
  const PlainSocket first = PlainSocket::connectedTo(server->port()), second = PlainSocket::connectedTo(server->port());
  ASSERT_TRUE(first.write(commandMessage("CMD_1", "First")));
  ASSERT_TRUE(second.write(commandMessage("CMD_abc", "Second")));
  ASSERT_TRUE(first.write(commandMessage("CMD")));
  const auto one = first.readMessage("STRING"), two = second.readMessage("STRING"), three = first.readMessage("STRING");
  ASSERT_TRUE(one && two && three);
  EXPECT_EQ(one->device, "ACK_1");
  EXPECT_EQ(one->version, 1);
  EXPECT_EQ(one->text(), "<CommandReply Status=\"SUCCESS\" Message=\"First\" />");
  EXPECT_EQ(two->device, "ACK_abc");
  EXPECT_THAT(two->text(), HasSubstr("Second"));
  EXPECT_EQ(three->device, "ACK");
  EXPECT_EQ(server->status().clients, 2);
  EXPECT_EQ(server->status().commands, 3U);
}

TEST(LinkServer, ReadsHeadersOfVersionTwoAndAnswersInVersionOne) {
  const auto server = startedServer(echo());
  const PlainSocket slicer = PlainSocket::connectedTo(server->port());
  // Messages of 3D Slicer that the server does not know, before its command.
  ASSERT_TRUE(slicer.write(test::message(2, "COMMAND", "Slicer", test::extendedBody(Bytes(300, 1)))));
  ASSERT_TRUE(slicer.write(test::message(2, "TRANSFORM", "LinearTransform", test::extendedBody(Bytes(48)))));
  ASSERT_TRUE(slicer.write(test::message(
      2, "STRING", "CMD_13", test::extendedBody(test::stringBody("<Command Name=\"RequestDeviceIds\"/>")))));
  const auto reply = slicer.readMessage("STRING");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->version, 1);
  EXPECT_EQ(reply->device, "ACK_13");
  EXPECT_THAT(reply->text(), HasSubstr("RequestDeviceIds"));
}

TEST(LinkServer, AnswersWhatIsNotACommand) {
  const auto server = startedServer(), obeying = startedServer(echo());
  const PlainSocket client = PlainSocket::connectedTo(server->port()),
                    other = PlainSocket::connectedTo(obeying->port());
  ASSERT_TRUE(client.write(commandMessage("CMD_1")));
  EXPECT_EQ(client.readMessage("STRING")->text(),
            "<CommandReply Status=\"FAIL\" Message=\"This server takes no commands.\" />");
  ASSERT_TRUE(other.write(test::message(1, "STRING", "Note", test::stringBody("<Command Name=\"a\"/>"))));
  ASSERT_TRUE(other.write(test::message(1, "STRING", "CMD_2", test::stringBody("DepthMm 50"))));
  const auto reply = other.readMessage("STRING");
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->device, "ACK_2");
  EXPECT_THAT(reply->text(), StartsWith("<CommandReply Status=\"FAIL\" Message=\"The command is not an XML element"));
}

TEST(LinkServer, TakesRepliesLaterAndAfterItsEnd) {
  std::mutex mutex;
  std::vector<LinkServer::Answer> answers;
  auto server = startedServer([&](const LinkCommand&, const LinkServer::Answer& answer) {
    const std::scoped_lock lock(mutex);
    answers.push_back(answer);
  });
  const PlainSocket client = PlainSocket::connectedTo(server->port());
  ASSERT_TRUE(client.write(commandMessage("CMD_1")));
  ASSERT_TRUE(client.write(commandMessage("CMD_2")));
  ASSERT_TRUE(test::waitUntil([&] {
    const std::scoped_lock lock(mutex);
    return answers.size() == 2;
  }));
  answers[1]({true, "later", {}});
  EXPECT_EQ(client.readMessage("STRING")->device, "ACK_2");
  server.reset();
  answers[0]({true, "too late", {}});
}

/// A client that never reads has no effect on post() and on another client.
TEST(LinkServer, IsNotHeldUpByAProgramThatNeverReads) {
  const auto server = startedServer();
  const PlainSocket idle = PlainSocket::connectedTo(server->port(), "127.0.0.1", 4096);
  const PlainSocket reading = PlainSocket::connectedTo(server->port());
  ASSERT_TRUE(test::waitUntil([&] { return server->status().clients == 2; }));
  constexpr int kFrames = 60;
  for (int i = 1; i <= kFrames; ++i) {
    server->post(numberedFrame(i, 820, 616));
    const auto transform = reading.readMessage("TRANSFORM");
    ASSERT_TRUE(transform) << i;
    ASSERT_EQ(transform->real(36), static_cast<float>(i));
    ASSERT_TRUE(reading.readMessage("IMAGE")->crcFits);
  }
  ASSERT_TRUE(test::waitUntil([&] { return server->status().sent >= kFrames; }));
  // The kernel's buffers hold less than two of these frames for the client that does not read.
  EXPECT_LT(server->status().sent, kFrames + 3U);
  EXPECT_EQ(server->status().posted, static_cast<std::uint64_t>(kFrames));
}

/// A slow client gets whole frames, fewer than were posted, and the last one.
TEST(LinkServer, LetsASlowProgramMissFrames) {
  const auto server = startedServer();
  const PlainSocket slow = PlainSocket::connectedTo(server->port(), "127.0.0.1", 4096);
  ASSERT_TRUE(test::waitUntil([&] { return server->status().clients == 1; }));
  constexpr int kFrames = 100;
  for (int i = 1; i <= kFrames; ++i) server->post(numberedFrame(i, 820, 616));
  std::vector<int> seen;
  while (seen.empty() || seen.back() != kFrames) {
    const auto image = slow.readMessage("IMAGE");
    ASSERT_TRUE(image && image->crcFits);
    ASSERT_TRUE(std::ranges::all_of(image->body.begin() + 72, image->body.end(),
                                    [&](std::uint8_t gray) { return gray == image->body.back(); }));
    seen.push_back(image->body.back());
  }
  EXPECT_TRUE(std::ranges::is_sorted(seen));
  EXPECT_LT(seen.size(), kFrames / 2U);
}

TEST(LinkServer, DisconnectsAProgramThatDoesNotSpeakOpenIgtLink) {
  const auto server = startedServer(echo());
  const PlainSocket good = PlainSocket::connectedTo(server->port()), web = PlainSocket::connectedTo(server->port());
  Bytes request;
  test::putText(request, "GET / HTTP/1.1\r\nHost: localhost\r\nAccept: */*\r\nConnection: keep-alive\r\n\r\n", 72);
  ASSERT_TRUE(web.write(request));
  EXPECT_FALSE(web.read(1));
  ASSERT_TRUE(test::waitUntil([&] { return server->status().clients == 1; }));
  EXPECT_EQ(server->status().lastError,
            "The other program does not speak OpenIGTLink: it sent a header that is not valid.");
  ASSERT_TRUE(good.write(commandMessage("CMD_1")));
  EXPECT_TRUE(good.readMessage("STRING"));
}

TEST(LinkServer, SkipsOversizeAndPartialMessages) {
  const auto server = startedServer(echo());
  // A large image of another program is skipped, and a command in two parts is taken.
  const PlainSocket client = PlainSocket::connectedTo(server->port());
  ASSERT_TRUE(client.write(test::header(2, "IMAGE", "CT", 20'000'000, 1)));
  for (int i = 0; i < 200; ++i) ASSERT_TRUE(client.write(Bytes(100'000)));
  const Bytes command = commandMessage("CMD_5");
  ASSERT_TRUE(client.write(std::span(command).first(70)));
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  ASSERT_TRUE(client.write(std::span(command).subspan(70)));
  EXPECT_EQ(client.readMessage("STRING")->device, "ACK_5");
  // Connections that end within a header and within a body.
  for (const std::size_t size : {30, 70})
    ASSERT_TRUE(PlainSocket::connectedTo(server->port()).write(std::span(command).first(size)));
  ASSERT_TRUE(test::waitUntil([&] { return server->status().clients == 1; }));
}

TEST(LinkServer, AcceptsEightPrograms) {
  const auto server = startedServer();
  server->post(numberedFrame(1));
  std::vector<PlainSocket> clients;
  for (int i = 0; i < LinkServer::kMaxClients; ++i) clients.push_back(PlainSocket::connectedTo(server->port()));
  for (const PlainSocket& client : clients) EXPECT_TRUE(client.readMessage("IMAGE"));
  EXPECT_FALSE(PlainSocket::connectedTo(server->port()).readMessage());
  clients.pop_back();
  ASSERT_TRUE(test::waitUntil([&] { return server->status().clients == LinkServer::kMaxClients - 1; }));
  EXPECT_TRUE(PlainSocket::connectedTo(server->port()).readMessage("IMAGE"));
}

/// A program that sends commands without reading the replies is no longer read, and takes no more memory.
TEST(LinkServer, StopsReadingAProgramWithManyOpenCommands) {
  const auto server = startedServer([](const LinkCommand&, const LinkServer::Answer&) {});
  const PlainSocket client = PlainSocket::connectedTo(server->port());
  for (int i = 0; i < 3 * LinkServer::kMaxOpenCommands; ++i)
    ASSERT_TRUE(client.write(commandMessage("CMD_" + std::to_string(i))));
  ASSERT_TRUE(
      test::waitUntil([&] { return server->status().commands >= std::uint64_t{LinkServer::kMaxOpenCommands}; }));
  const PlainSocket second = PlainSocket::connectedTo(server->port());
  server->post(numberedFrame(1));
  EXPECT_TRUE(second.readMessage("IMAGE"));
}

/// Clients that send random bytes and damaged messages come and go; the server serves on.
TEST(LinkServer, SurvivesRandomClients) {
  const auto server = startedServer(echo());
  std::mt19937 random(4711);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  for (int round = 0; round < 300; ++round) {
    const PlainSocket client = PlainSocket::connectedTo(server->port());
    ASSERT_TRUE(client.isOpen());
    for (std::size_t i = below(6); i > 0; --i) {
      Bytes bytes = below(4) == 0 ? Bytes(below(2000)) : commandMessage("CMD_1");
      for (std::size_t change = below(5); change > 0 && !bytes.empty(); --change)
        bytes[below(bytes.size())] = static_cast<std::uint8_t>(random());
      if (!client.write(bytes)) break;
    }
    if (below(10) == 0) server->post(numberedFrame(round));
  }
  // Connections that still wait to be accepted may fill the eight places for a moment.
  EXPECT_TRUE(test::waitUntil([&] {
    const PlainSocket last = PlainSocket::connectedTo(server->port());
    if (!last.write(commandMessage("CMD_9"))) return false;
    const auto reply = last.readMessage("STRING");
    return reply && reply->device == "ACK_9";
  }));
}

}  // namespace
}  // namespace insonate
