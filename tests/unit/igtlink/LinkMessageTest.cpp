#include "LinkBytes.h"

#include <insonate/igtlink/LinkMessage.h>
#include <insonate/igtlink/LinkParser.h>

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <random>

namespace insonate {
namespace {

using test::Bytes;
using testing::IsEmpty;
using testing::SizeIs;

// 2023-11-14 22:13:20.5 UTC; 0x6553F100'80000000 in a header.
constexpr std::int64_t kTime_ns = 1'700'000'000'500'000'000;
const Transform kPose{{{Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}}, {12.5, -40.25, 118}};

const Bytes kTransform = test::hex(
    "00 01 54 52 41 4E 53 46 4F 52 4D 00 00 00 50 72 6F 62 65 54 6F 52 65 66 65 72 65 6E 63 65 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 30 BA 9D B3 90 66 6C 91 CC 00 00 00 00 00 00"
    "00 00 BF 80 00 00 00 00 00 00 3F 80 00 00 00 00 00 00 3F 80 00 00 00 00 00 00 00 00 00 00 41 48"
    "00 00 C2 21 00 00 42 EC 00 00");
// Header of version 2, as 3D Slicer and PLUS send it: extended header of 12 bytes, metadata Status = OK.
const Bytes kTransform2 = test::hex(
    "00 02 54 52 41 4E 53 46 4F 52 4D 00 00 00 53 74 79 6C 75 73 54 6F 54 72 61 63 6B 65 72 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 4E 95 AE 96 9D 15 5E C5 EA 00 0C 00 0A 00 00"
    "00 08 00 00 00 4D 00 00 00 00 00 00 00 00 BF 80 00 00 00 00 00 00 3F 80 00 00 00 00 00 00 3F 80"
    "00 00 00 00 00 00 00 00 00 00 41 48 00 00 C2 21 00 00 42 EC 00 00 00 01 00 06 00 03 00 00 00 02"
    "53 74 61 74 75 73 4F 4B");
// Header of version 2 with an extended header of 16 bytes, which a later version of the protocol may have.
const Bytes kCommand2 = test::hex(
    "00 02 53 54 52 49 4E 47 00 00 00 00 00 00 43 4D 44 5F 31 33 00 00 00 00 00 00 00 00 00 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 63 42 02 80 20 FD D2 A4 9A 00 10 00 00 00 00"
    "00 00 00 00 00 4E DE AD BE EF 00 03 00 4F 3C 43 6F 6D 6D 61 6E 64 20 4E 61 6D 65 3D 22 53 65 74"
    "55 73 50 61 72 61 6D 65 74 65 72 22 3E 3C 50 61 72 61 6D 65 74 65 72 20 4E 61 6D 65 3D 22 44 65"
    "70 74 68 4D 6D 22 20 56 61 6C 75 65 3D 22 35 30 22 2F 3E 3C 2F 43 6F 6D 6D 61 6E 64 3E");
const Bytes kTracking = test::hex(
    "00 01 54 44 41 54 41 00 00 00 00 00 00 00 54 72 61 63 6B 65 72 00 00 00 00 00 00 00 00 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 8C CB BB DB 40 7D C4 A1 D1 50 72 6F 62 65 00"
    "00 00 00 00 00 00 00 00 00 00 00 00 00 00 02 00 00 00 00 00 00 00 00 00 BF 80 00 00 00 00 00 00"
    "3F 80 00 00 00 00 00 00 3F 80 00 00 00 00 00 00 00 00 00 00 41 48 00 00 C2 21 00 00 42 EC 00 00"
    "4E 65 65 64 6C 65 00 00 00 00 00 00 00 00 00 00 00 00 00 00 02 00 00 00 00 00 00 00 00 00 BF 80"
    "00 00 00 00 00 00 3F 80 00 00 00 00 00 00 3F 80 00 00 00 00 00 00 00 00 00 00 41 48 00 00 C2 21"
    "00 00 42 EC 00 00");
// A turn of 90 degrees about y at (1, 2, 3), as quaternion; POSITION without the quaternion's last component.
const Bytes kQuaternion = test::hex(
    "00 01 51 54 44 41 54 41 00 00 00 00 00 00 54 72 61 63 6B 65 72 00 00 00 00 00 00 00 00 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 32 31 79 9B 8C 8B 5B BA 9F 53 74 79 6C 75 73"
    "00 00 00 00 00 00 00 00 00 00 00 00 00 00 02 00 3F 80 00 00 40 00 00 00 40 40 00 00 00 00 00 00"
    "3F 35 04 F3 00 00 00 00 3F 35 04 F3");
const Bytes kImage = test::hex(
    "00 01 49 4D 41 47 45 00 00 00 00 00 00 00 49 6D 61 67 65 5F 52 65 66 65 72 65 6E 63 65 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 4E EC 68 65 B9 C8 91 53 4E 00 01 01 03 01 01"
    "00 03 00 02 00 01 3F 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 BE 80 00 00 00 00"
    "00 00 3F 00 00 00 00 00 00 00 41 28 00 00 41 A0 00 00 41 EF 00 00 00 00 00 00 00 00 00 03 00 02"
    "00 01 01 02 03 04 05 06");
const Bytes kString = test::hex(
    "00 01 53 54 52 49 4E 47 00 00 00 00 00 00 41 43 4B 5F 31 33 00 00 00 00 00 00 00 00 00 00 00 00"
    "00 00 65 53 F1 00 80 00 00 00 00 00 00 00 00 00 00 08 A3 43 B8 16 27 6C 80 6C 00 03 00 04 64 6F"
    "6E 65");

const std::vector<std::string> kAllTypes{"TRANSFORM", "TDATA", "QTDATA", "POSITION", "STRING", "IMAGE"};

std::vector<LinkMessage> parsed(const Bytes& bytes, LinkCounters* counters = nullptr) {
  LinkParser parser(kAllTypes);
  std::vector<LinkMessage> messages;
  EXPECT_TRUE(parser.feed(bytes, [&](LinkMessage&& m) { messages.push_back(std::move(m)); }));
  if (counters) *counters = parser.counters();
  return messages;
}

void expectPose(const Transform& pose, const Transform& expected) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_LT(norm(pose.linear.column[axis] - expected.linear.column[axis]), 1e-6);
  EXPECT_LT(norm(pose.offset - expected.offset), 1e-5);
}

TEST(LinkMessageBytes, EqualTheBytesOfThePublishedLayout) {
  Bytes bytes;
  appendTransform(bytes, {"ProbeToReference", kPose}, kTime_ns);
  EXPECT_EQ(bytes, kTransform);
  bytes.clear();
  const auto gray = std::make_shared<const Bytes>(Bytes{1, 2, 3, 4, 5, 6});
  const Transform place{{{Vec3{0.5, 0, 0}, Vec3{0, 0, -0.25}, Vec3{0, 0.5, 0}}}, {10, 20, 30}};
  appendImage(bytes, {"Image_Reference", 3, 2, place, gray}, kTime_ns);
  EXPECT_EQ(bytes, kImage);
  bytes.clear();
  appendString(bytes, "ACK_13", "done", kTime_ns);
  EXPECT_EQ(bytes, kString);
}

TEST(LinkMessageBytes, AreReadWithHeadersOfVersionOne) {
  const auto transform = parsed(kTransform);
  ASSERT_THAT(transform, SizeIs(1));
  EXPECT_EQ(transform[0].time_ns, kTime_ns);
  const auto poses = posesOf(transform[0]);
  ASSERT_THAT(poses, SizeIs(1));
  EXPECT_EQ(poses[0].name, "ProbeToReference");
  expectPose(poses[0].trackerFromTool, kPose);

  const auto tools = posesOf(parsed(kTracking).at(0));
  ASSERT_THAT(tools, SizeIs(2));
  EXPECT_EQ(tools[0].name, "Probe");
  EXPECT_EQ(tools[1].name, "Needle");
  expectPose(tools[1].trackerFromTool, kPose);

  EXPECT_EQ(textOf(parsed(kString).at(0)), "done");
}

TEST(LinkMessageBytes, AreReadWithHeadersOfVersionTwo) {
  const auto transform = parsed(kTransform2);
  ASSERT_THAT(transform, SizeIs(1));
  EXPECT_EQ(transform[0].version, 2);
  const auto poses = posesOf(transform[0]);
  ASSERT_THAT(poses, SizeIs(1));
  EXPECT_EQ(poses[0].name, "StylusToTracker");
  expectPose(poses[0].trackerFromTool, kPose);
  const auto command = parsed(kCommand2);
  ASSERT_THAT(command, SizeIs(1));
  EXPECT_EQ(command[0].device, "CMD_13");
  EXPECT_EQ(textOf(command[0]),
            "<Command Name=\"SetUsParameter\"><Parameter Name=\"DepthMm\" Value=\"50\"/></Command>");
}

TEST(LinkMessageBytes, OfQuaternionsBecomeRotations) {
  const Transform turned{{{Vec3{0, 0, -1}, Vec3{0, 1, 0}, Vec3{1, 0, 0}}}, {1, 2, 3}};
  const auto tools = posesOf(parsed(kQuaternion).at(0));
  ASSERT_THAT(tools, SizeIs(1));
  EXPECT_EQ(tools[0].name, "Stylus");
  expectPose(tools[0].trackerFromTool, turned);
  Bytes body;
  for (const float value : {1.F, 2.F, 3.F, 0.F, std::sqrt(0.5F), 0.F}) test::putReal(body, value);
  const auto position = posesOf(parsed(test::message(1, "POSITION", "StylusTip", body)).at(0));
  ASSERT_THAT(position, SizeIs(1));
  expectPose(position[0].trackerFromTool, turned);
}

TEST(LinkMessageBytes, AppendNothingForAnImageWithoutItsPixels) {
  Bytes bytes;
  appendImage(bytes, {"Image", 3, 2, {}, std::make_shared<const Bytes>(5)}, 0);
  appendImage(bytes, {"Image", 3, 2, {}, nullptr}, 0);
  appendImage(bytes, {"Image", 0, 0, {}, std::make_shared<const Bytes>()}, 0);
  EXPECT_THAT(bytes, IsEmpty());
}

TEST(LinkMessageBytes, CutLongNamesAndTexts) {
  Bytes bytes;
  appendString(bytes, "ANameOfMoreThanTwentyBytes", std::string(70'000, 'x'), 0);
  const auto messages = parsed(bytes);
  ASSERT_THAT(messages, SizeIs(1));
  EXPECT_EQ(messages[0].device, "ANameOfMoreThanTwent");
  EXPECT_EQ(textOf(messages[0]), std::string(65'535, 'x'));
}

TEST(LinkPoses, LeaveOutWhatIsNotRigid) {
  const auto posesWith = [](float first, float offset) {
    Bytes body = test::transformBody(offset, 0, 0), number;
    test::putReal(number, first);
    std::ranges::copy(number, body.begin());
    return posesOf(parsed(test::message(1, "TRANSFORM", "Tool", body)).at(0));
  };
  EXPECT_THAT(posesWith(1, 0), SizeIs(1));
  EXPECT_THAT(posesWith(1.005F, 0), SizeIs(1));
  EXPECT_THAT(posesWith(1.1F, 0), IsEmpty());
  EXPECT_THAT(posesWith(-1, 0), IsEmpty());  // mirrored
  EXPECT_THAT(posesWith(0, 0), IsEmpty());
  EXPECT_THAT(posesWith(std::numeric_limits<float>::quiet_NaN(), 0), IsEmpty());
  EXPECT_THAT(posesWith(1, std::numeric_limits<float>::infinity()), IsEmpty());
  const Mat3 rotation = posesWith(1.005F, 0)[0].trackerFromTool.linear;
  EXPECT_NEAR(norm(rotation.column[0]), 1, 1e-12);
}

TEST(LinkPoses, AreEmptyForContentOfAnotherLength) {
  for (const std::size_t size : {0, 1, 47, 49, 70, 96})
    EXPECT_THAT(posesOf(parsed(test::message(1, "TRANSFORM", "Tool", Bytes(size))).at(0)), IsEmpty());
  EXPECT_THAT(posesOf(parsed(test::message(1, "TDATA", "Tool", Bytes(69))).at(0)), IsEmpty());
  Bytes shortText = test::stringBody("text");
  shortText.pop_back();
  EXPECT_EQ(textOf(parsed(test::message(1, "STRING", "CMD_1", shortText)).at(0)), std::nullopt);
  EXPECT_EQ(textOf(parsed(test::message(1, "STRING", "CMD_1", {}))[0]), std::nullopt);
}

TEST(LinkParser, TakesBytesInAnyPortions) {
  Bytes stream = kTransform;
  for (const Bytes& more : {kCommand2, kTracking, kTransform2, kString}) test::append(stream, more);
  for (const std::size_t portion : {1, 7, 57, 58, 59, 1000}) {
    LinkParser parser(kAllTypes);
    std::vector<std::string> types;
    for (std::size_t i = 0; i < stream.size(); i += portion)
      ASSERT_TRUE(parser.feed(std::span(stream).subspan(i, std::min(portion, stream.size() - i)),
                              [&](const LinkMessage& m) { types.push_back(m.type); }));
    EXPECT_THAT(types, testing::ElementsAre("TRANSFORM", "STRING", "TDATA", "TRANSFORM", "STRING"));
  }
}

TEST(LinkParser, SkipsUnknownAndLargeMessagesByTheirSize) {
  LinkCounters counters;
  Bytes stream = test::message(2, "COMMAND", "Slicer", Bytes(1000, 7));
  test::append(stream, test::message(1, "GET_STATUS", "", {}));
  test::append(stream, test::message(1, "STRING", "CMD_1", Bytes(LinkParser::kMaxBody + 1)));
  test::append(stream, kString);
  const auto messages = parsed(stream, &counters);
  ASSERT_THAT(messages, SizeIs(1));
  EXPECT_EQ(messages[0].device, "ACK_13");
  EXPECT_EQ(counters.skipped, 3U);
}

TEST(LinkParser, LeavesOutDamagedMessages) {
  LinkCounters counters;
  Bytes damaged = kTransform;
  damaged.back() ^= 1;
  // Extended headers that are longer than the body, or too short for their own fields.
  Bytes longer = test::extendedBody(test::stringBody("x")), shorter = longer;
  longer[6] = 0xFF;
  shorter[1] = 11;
  Bytes stream = damaged;
  for (const Bytes& body : {longer, shorter, Bytes{}, Bytes(3)})
    test::append(stream, test::message(2, "STRING", "CMD_1", body));
  test::append(stream, kString);
  const auto messages = parsed(stream, &counters);
  ASSERT_THAT(messages, SizeIs(1));
  EXPECT_EQ(messages[0].device, "ACK_13");
  EXPECT_EQ(counters.damaged, 5U);
}

TEST(LinkParser, RefusesWhatIsNotOpenIgtLink) {
  const Bytes web = [] {
    Bytes bytes;
    test::putText(bytes, "GET / HTTP/1.1\r\nHost: localhost:18944\r\nUser-Agent: browser\r\n\r\n", 64);
    return bytes;
  }();
  for (const Bytes& bytes : {web, test::header(0, "STRING", "", 0, 0), test::header(4, "STRING", "", 0, 0),
                             test::header(1, "", "", 0, 0), test::header(1, "STRING", "", std::uint64_t{1} << 40, 0)}) {
    LinkParser parser(kAllTypes);
    const auto ok = parser.feed(bytes, [](const LinkMessage&) { ADD_FAILURE(); });
    ASSERT_FALSE(ok);
    EXPECT_EQ(ok.error().message, "The other program does not speak OpenIGTLink: it sent a header that is not valid.");
    EXPECT_FALSE(parser.feed(kString, [](const LinkMessage&) { ADD_FAILURE(); }));
  }
}

/// Feeds random bytes, and valid messages with random changes, in random portions. The sanitizers judge the run.
TEST(LinkParser, SurvivesRandomBytes) {
  std::mt19937 random(20261130);
  const auto below = [&](std::size_t limit) {
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(random);
  };
  const std::vector<Bytes> valid{kTransform, kTransform2, kCommand2, kTracking, kQuaternion, kImage, kString};
  std::size_t taken = 0;
  for (int round = 0; round < 20'000; ++round) {
    Bytes stream;
    for (std::size_t i = 0, count = 1 + below(3); i < count; ++i) {
      Bytes part = below(8) == 0 ? Bytes(below(200)) : valid[below(valid.size())];
      for (std::size_t change = below(4); change > 0 && !part.empty(); --change)
        part[below(part.size())] = static_cast<std::uint8_t>(random());
      // A CRC that fits lets the changed content reach the readers behind the CRC.
      if (part.size() > kLinkHeaderSize && below(2) == 0) {
        const std::uint64_t crc = test::slowCrc(std::span(part).subspan(kLinkHeaderSize));
        Bytes number;
        test::put(number, crc, 8);
        std::ranges::copy(number, part.begin() + 50);
      }
      test::append(stream, part);
    }
    LinkParser parser(kAllTypes);
    for (std::size_t i = 0; i < stream.size();) {
      const std::size_t portion = std::min(stream.size() - i, 1 + below(100));
      const auto ok = parser.feed(std::span(stream).subspan(i, portion), [&](const LinkMessage& message) {
        ++taken;
        for (const LinkPose& pose : posesOf(message)) ASSERT_TRUE(isFinite(pose.trackerFromTool.offset));
        [[maybe_unused]] const auto text = textOf(message);
      });
      if (!ok) break;
      i += portion;
    }
  }
  EXPECT_GT(taken, 10'000U);
}

}  // namespace
}  // namespace insonate
