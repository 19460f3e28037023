#include "BlockAttempt.h"

#include <insonate/procedure/AttemptRecorder.h>
#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/EventCheck.h>

#include <gmock/gmock.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <string_view>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

namespace insonate {
namespace {

using ::testing::HasSubstr;

/// Attempts on the block, which another program may have changed afterward.
class EventCheckOnBlock : public test::BlockAttempt {
 protected:
  using Entry = RecordingSegment::Entry;

  /// Into the vein, through its far wall, out again, and beside it into the artery.
  void record() {
    play(R"({"probe": "across"}, )" + needle(0) + R"(, {"aspirate": true}, {"advance_mm": 34}, {"withdraw_mm": 34}, )" +
         needle(18) + R"(, {"advance_mm": 36}, {"withdraw_mm": 36})");
  }
  AttemptRecording recorded() const { return *AttemptRecording::open(folder / "attempt"); }

  /// Writes the recording again, as its header and each of its samples and events are after `change`; an entry is left
  /// out if `change` returns false.
  AttemptRecording forged(const std::function<bool(Entry&)>& change, const AttemptHeader& header) const {
    const auto file = folder / "forged";
    auto recorder = *AttemptRecorder::start(file, header);
    const auto played = recorded().play(std::numeric_limits<std::int64_t>::max(), [&](const Entry& original) {
      Entry entry = original;
      if (!change(entry)) return;
      while (recorder->freeSlots() == 0) std::this_thread::yield();
      std::visit([&](const auto& what) { recorder->record(what); }, entry);
    });
    EXPECT_TRUE(played);
    EXPECT_TRUE(recorder->finish(AttemptStatus::Completed));
    return *AttemptRecording::open(file);
  }
  AttemptRecording forged(const std::function<bool(Entry&)>& change) const {
    return forged(change, recorded().header());
  }

  void keepCase() const {
    std::filesystem::create_directory(folder / "cases");
    const auto written = writeCase(patient, folder / "cases" / "block");
    EXPECT_TRUE(written) << written.error().message;
  }
  std::vector<EventDifference> differences(const AttemptRecording& recording) {
    keepCase();
    EventCheck check({folder / "cases"});
    const auto found = check.compare(recording);
    EXPECT_TRUE(found) << found.error().message;
    return found.value_or(std::vector<EventDifference>());
  }

  static bool isEntered(const Entry& entry, Label wall) {
    const auto* event = std::get_if<AttemptEvent>(&entry);
    return event && event->kind == AttemptEventKind::Entered && event->wall == wall;
  }
};

TEST_F(EventCheckOnBlock, AnAttemptAgreesWithItsMotion) {
  record();
  const auto found = differences(recorded());
  for (const EventDifference& one : found) ADD_FAILURE() << one.what << one.recorded << one.expected;
}

TEST_F(EventCheckOnBlock, ARemovedPunctureOfTheArteryIsFound) {
  record();
  const auto found = differences(forged([](const Entry& entry) {
    const auto* event = std::get_if<AttemptEvent>(&entry);
    return !event || event->wall != kArtery;
  }));
  ASSERT_FALSE(found.empty());
  EXPECT_THAT(found[0].what, HasSubstr("needle event at"));
  EXPECT_EQ(found[0].recorded, "none");
  EXPECT_EQ(found[0].expected, "entered: artery");
}

TEST_F(EventCheckOnBlock, ARemovedPunctureOfTheFarWallIsFound) {
  record();
  const auto found = differences(forged([](const Entry& entry) {
    const auto* event = std::get_if<AttemptEvent>(&entry);
    return !event || event->wall != kVein || event->kind != AttemptEventKind::Left;
  }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].expected, "left: vein");
}

/// The needle stays in the tissue beside the vein.
TEST_F(EventCheckOnBlock, APunctureThatTheNeedleDidNotMakeIsFound) {
  play(R"({"probe": "across"}, )" + needle(-10) + R"(, {"aspirate": true}, {"advance_mm": 25}, {"wait_s": 1})");
  bool isAdded = false;
  const auto found = differences(forged([&](Entry& entry) {
    auto* sample = std::get_if<AttemptSample>(&entry);
    if (sample && sample->time_us > 2'400'000 && !std::exchange(isAdded, true))
      entry = AttemptEvent{.time_us = sample->time_us,
                           .kind = AttemptEventKind::Entered,
                           .wall = kVein,
                           .into = kVein,
                           .vessel = 1,
                           .tip_mm = {0, 17.5, 0},
                           .depth_mm = 12};
    return true;
  }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].recorded, "entered: vein");
  EXPECT_THAT(found[0].expected, HasSubstr("outside"));
}

/// The events are right, but the distances that metrics are computed from are not.
TEST_F(EventCheckOnBlock, AnotherDistanceToTheArteryIsFound) {
  play(R"({"probe": "across"}, )" + needle(8) + R"(, {"advance_mm": 25}, {"wait_s": 2})");
  const auto found = differences(forged([](Entry& entry) {
    if (auto* sample = std::get_if<AttemptSample>(&entry); sample && sample->toArtery_mm) *sample->toArtery_mm += 6;
    return true;
  }));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0].what, HasSubstr("distance to the artery"));
}

/// The name of the target is given to another vessel.
TEST_F(EventCheckOnBlock, AnotherNameOfAVesselIsFound) {
  record();
  AttemptHeader header = recorded().header();
  ASSERT_FALSE(header.vessels.empty());
  header.vessels[0] = "right internal jugular vein";
  const auto found = differences(forged([](const Entry&) { return true; }, header));
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].recorded, "entered: right internal jugular vein");
  EXPECT_EQ(found[0].expected, "entered: vein");
}

TEST_F(EventCheckOnBlock, WithoutTheCaseItSaysSo) {
  record();
  EventCheck check({folder / "none"});
  const auto found = check.compare(recorded());
  ASSERT_FALSE(found);
  EXPECT_THAT(found.error().message, HasSubstr("Block for attempts"));
}

TEST_F(EventCheckOnBlock, CanBeCancelled) {
  record();
  keepCase();
  EventCheck check({folder / "cases"});
  EXPECT_EQ(check.compare(recorded(), [](std::string_view, double) { return false; }).error().message, kCancelled);
  const auto found = check.compare(recorded());
  EXPECT_TRUE(found && found->empty()) << "the same object serves again";
}

}  // namespace
}  // namespace insonate
