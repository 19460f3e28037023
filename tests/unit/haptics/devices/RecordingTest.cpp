#include "FakeBus.h"

#include <insonate/haptics/DeviceHub.h>

#include <gmock/gmock.h>

#include <fstream>

using namespace insonate;
using namespace insonate::test;
using namespace std::chrono_literals;
using testing::HasSubstr;

namespace {

class RecordingTest : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    std::ofstream(file_) << text;
    return file_.string();
  }
  ~RecordingTest() override { std::filesystem::remove(file_); }

  const std::filesystem::path file_ =
      std::filesystem::path(testing::TempDir()) /
      (std::string("insonate-") + testing::UnitTest::GetInstance()->current_test_info()->name() + ".reports");
};

TEST_F(RecordingTest, WhatIsRecordedComesBackAsADevice) {
  const auto ports = std::make_shared<FakePorts>();
  DeviceHub hub(std::make_unique<FakeBus>(ports));
  const auto cable = ports->plug({"/dev/hidraw1", "VEC", "", "", 0x05f3, 0x00ff, 1, 0});
  ASSERT_TRUE(hub.recorder().start(file_));
  hub.scanOnce();
  const auto pedal = hub.devices().at(0);
  DeviceState state;
  for (const std::uint8_t buttons : {1, 3, 2}) {
    cable->say({buttons, 0});
    ASSERT_TRUE(eventually([&] { return pedal->pollState(state); }));
    std::this_thread::sleep_for(30ms);
  }
  ASSERT_TRUE(hub.recorder().stop());
  cable->say({7, 0});  // not recorded any more
  ASSERT_TRUE(eventually([&] { return pedal->pollState(state); }));

  const auto reports = readRecording(file_);
  ASSERT_TRUE(reports) << reports.error().message;
  ASSERT_EQ(reports->size(), 3U);
  EXPECT_EQ(reports->at(1).device, "05f3:00ff");
  EXPECT_EQ(reports->at(1).bytes, (Bytes{3, 0}));
  EXPECT_GE(reports->at(2).time_s - reports->at(1).time_s, 0.029);

  const auto replay = replayRecording(*reports);
  ASSERT_TRUE(replay) << replay.error().message;
  EXPECT_EQ((*replay)->info().kind, DeviceKind::kPedal);
  std::vector<std::uint32_t> buttons;
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(eventually([&] {
    if ((*replay)->pollState(state)) buttons.push_back(state.buttons);
    return buttons.size() == 3;
  }));
  EXPECT_THAT(buttons, testing::ElementsAre(1U, 3U, 2U));
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 50ms);  // at its pace
}

TEST_F(RecordingTest, ForcesAreRecordedToo) {
  const auto ports = std::make_shared<FakePorts>();
  DeviceHub hub(std::make_unique<FakeBus>(ports));
  const auto cable = ports->plug({"/dev/hidraw0", "", "", "", 0x16c0, 0x0486, 1, 0});
  ASSERT_TRUE(hub.recorder().start(file_));
  hub.scanOnce();
  cable->say(Bytes(14, 0));
  hub.devices().at(0)->push({{0, 0, 1}, {}});
  ASSERT_TRUE(eventually([&] { return !cable->heard().empty(); }));
  ASSERT_TRUE(hub.recorder().stop());
  const auto reports = readRecording(file_);
  ASSERT_TRUE(reports);
  const auto out = std::find_if(reports->begin(), reports->end(), [](const RecordedReport& r) { return !r.in; });
  ASSERT_NE(out, reports->end());
  EXPECT_EQ(out->bytes, cable->heard().at(0));
}

TEST_F(RecordingTest, ADiskThatIsFullIsSaidAtTheEnd) {
  ReportRecorder recorder;
  ASSERT_TRUE(recorder.start("/dev/full"));
  recorder.record("d", "t", true, Bytes(20, 1));
  const auto done = recorder.stop();
  ASSERT_FALSE(done);
  EXPECT_THAT(done.error().message, HasSubstr("/dev/full is not complete"));
  EXPECT_TRUE(recorder.start(file_));  // and all is well again
  EXPECT_TRUE(recorder.stop());
}

TEST_F(RecordingTest, AgainMeansAgain) {
  const std::vector<RecordedReport> reports{{0, "p", "VEC_Infinity_IN-USB-2", true, {1, 0}},
                                            {0.01, "p", "VEC_Infinity_IN-USB-2", true, {0, 0}}};
  const auto replay = replayRecording(reports, "p", true);
  ASSERT_TRUE(replay);
  EXPECT_TRUE(eventually([&] { return (*replay)->counters().reports > 6; }));
}

TEST_F(RecordingTest, RefusesWhatIsNoRecording) {
  EXPECT_THAT(readRecording("/nowhere/at.all").error().message, HasSubstr("/nowhere/at.all cannot be read"));
  EXPECT_THAT(readRecording(write("other\n")).error().message, HasSubstr("is not a recording"));
  const std::string heading = "insonate device reports 1\n0.5 d t in 00ff\n";
  EXPECT_TRUE(readRecording(write(heading)));
  for (const char* line : {"0.6 d t in 00f", "0.6 d t in 0x", "0.6 d t on 00", "0.6 d t in", "0.4 d t in 00",
                           "a b c in 00", "0.6 d t in 00 11"})
    EXPECT_THAT(readRecording(write(heading + line + "\n")).error().message, HasSubstr("line 3 is not a report"))
        << line;
  EXPECT_THAT(replayRecording({}).error().message, HasSubstr("no report of a device"));
  EXPECT_THAT(replayRecording({{0, "d", "t", true, {1}}}).error().message, HasSubstr("'t' is not in any device table"));
  EXPECT_THAT(replayRecording({{0, "d", "t", true, {1}}}, "e").error().message, HasSubstr("device 'e'"));
  EXPECT_THAT(ReportRecorder().start("/nowhere/at.all").error().message, HasSubstr("cannot be written"));
}

}  // namespace
