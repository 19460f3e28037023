// Both ways against an independent process that is built only on the library of OpenIGTLink.
#include "PlainSocket.h"

#include <insonate/igtlink/LinkClient.h>
#include <insonate/igtlink/LinkServer.h>

#include <gmock/gmock.h>

#include <cstdio>
#include <map>
#include <mutex>
#include <sstream>

namespace insonate {
namespace {

using test::Bytes;

/// Output of a program.
class Program {
 public:
  explicit Program(const std::string& command) : pipe_(popen(command.c_str(), "r")) {}
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;
  ~Program() { wait(); }

  bool readLine(std::string& line) {
    line.clear();
    for (int c = std::fgetc(pipe_); c != EOF; c = std::fgetc(pipe_)) {
      if (c == '\n') return true;
      line += static_cast<char>(c);
    }
    return false;
  }
  int wait() { return pipe_ ? pclose(std::exchange(pipe_, nullptr)) : 0; }

 private:
  FILE* pipe_;
};

TEST(LibraryOfOpenIgtLink, ReceivesImagesTransformsAndReplies) {
  auto server = LinkServer::start({.port = 0}, [](const LinkCommand& command, const LinkServer::Answer& answer) {
    answer({true, command.name + " " + command.parameters.at(0).name + " " + command.parameters.at(0).value, {}});
  });
  ASSERT_TRUE(server);
  // An oblique plane: 0.2 mm per column, 0.3 mm per row.
  const Transform place{{{Vec3{0.12, 0.16, 0}, Vec3{0, 0, -0.3}, Vec3{-0.16, 0.12, 0}}}, {-31.5, 210.25, 1250.125}};
  Program peer(std::string(IGTLINK_LIBRARY_PEER) + " receive " + std::to_string((*server)->port()) + " 3");
  ASSERT_TRUE(test::waitUntil([&] { return (*server)->status().commands == 1; }));
  for (int i = 1; i <= 30; ++i) {
    auto frame = std::make_shared<LinkFrame>();
    Bytes gray(300 * 200, 7);
    gray.back() = 9;
    frame->image = {"Image_Reference", 300, 200, place, std::make_shared<const Bytes>(std::move(gray))};
    frame->transforms = {{"ProbeToReference", {{{Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, 0, 1}}}, {1, 2, 3}}}};
    (*server)->post(std::move(frame));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  std::map<std::string, std::string> lines;
  for (std::string line; peer.readLine(line);) lines[line.substr(0, line.find(' '))] = line;
  EXPECT_EQ(peer.wait(), 0);
  EXPECT_EQ(lines["STRING"], "STRING ACK_42 <CommandReply Status=\"SUCCESS\" Message=\"SetUsParameter DepthMm 50\" />");
  EXPECT_EQ(
      lines["TRANSFORM"],
      "TRANSFORM ProbeToReference 0.000000 1.000000 0.000000 -1.000000 0.000000 0.000000 0.000000 0.000000 1.000000 "
      "1.000000 2.000000 3.000000");
  std::istringstream image(lines["IMAGE"]);
  std::string type, name;
  int width = 0, height = 0, depth = 0, scalar = 0, coordinates = 0, first = 0, last = 0;
  std::array<double, 3> spacing{};
  std::array<double, 12> m{};
  image >> type >> name >> width >> height >> depth >> scalar >> coordinates;
  for (double& value : spacing) image >> value;
  for (double& value : m) image >> value;
  image >> first >> last;
  EXPECT_EQ(name, "Image_Reference");
  EXPECT_EQ((std::array{width, height, depth, scalar, coordinates, first, last}),
            (std::array{300, 200, 1, 3, 1, 7, 9}));  // unsigned 8-bit, RAS
  // Pixel to Reference as 3D Slicer computes it: from directions, spacing and the middle of the image.
  for (const Vec3 pixel : {Vec3{0, 0, 0}, Vec3{299, 0, 0}, Vec3{0, 199, 0}, Vec3{299, 199, 0}, Vec3{120, 33, 0}}) {
    const double column = (pixel.x - 149.5) * spacing[0], row = (pixel.y - 99.5) * spacing[1];
    const Vec3 there = Vec3{m[0], m[1], m[2]} * column + Vec3{m[3], m[4], m[5]} * row + Vec3{m[9], m[10], m[11]};
    EXPECT_LT(norm(there - place * pixel), 1e-3);
  }
}

TEST(LibraryOfOpenIgtLink, SendsPosesOfEachKind) {
  Program peer(std::string(IGTLINK_LIBRARY_PEER) + " serve 60 60");
  std::string line;
  ASSERT_TRUE(peer.readLine(line) && line.starts_with("PORT "));
  std::mutex mutex;
  std::map<std::string, std::vector<LinkToolPose>> tools;
  const LinkClient client("127.0.0.1", std::stoi(line.substr(5)),
                          [&](const std::vector<LinkToolPose>& poses, const std::string&) {
                            const std::scoped_lock lock(mutex);
                            for (const LinkToolPose& pose : poses) tools[pose.name].push_back(pose);
                          });
  const auto seen = [&](const std::string& name) {
    const std::scoped_lock lock(mutex);
    return tools[name];
  };
  ASSERT_TRUE(test::waitUntil([&] { return seen("Tip").size() == 60; }));
  for (const char* name : {"ProbeToTracker", "Needle", "Stylus", "Tip"}) {
    const auto poses = seen(name);
    ASSERT_EQ(poses.size(), 60U) << name;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      EXPECT_EQ(poses[i].trackerFromTool.offset, (Vec3{double(i + 1), 2, 3})) << name;
      EXPECT_GT(poses[i].time_ns, i > 0 ? poses[i - 1].time_ns : 0) << name;
    }
  }
  const Vec3 turnedAxis = seen("Stylus")[0].trackerFromTool.linear.column[0];
  EXPECT_LT(norm(turnedAxis - Vec3{0, 0, -1}), 1e-6);
  EXPECT_EQ(peer.wait(), 0);
  EXPECT_TRUE(test::waitUntil([&] { return client.status().phase == LinkPhase::kConnecting; }));
}

}  // namespace
}  // namespace insonate
