#include "HandsBench.h"
#include "hand/SkinSurface.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/LiveAttempt.h>

#include <gmock/gmock.h>
#include <support/Allocations.h>
#include <support/TestData.h>

namespace insonate {
namespace {

using namespace std::chrono_literals;
using test::eventually;
using test::pressedBy;

AttemptHeader header(const PatientCase& patient, const Procedure& procedure) {
  return headerOf(procedure, patient, *loadProbe("linear"), "insonate test");
}

class LiveAttemptTest : public testing::Test {
 protected:
  std::shared_ptr<LiveAttempt> begin() {
    const Procedure procedure = *loadProcedure("internal_jugular");
    auto attempt = LiveAttempt::start(file, header(*bench.patient, procedure), procedure);
    EXPECT_TRUE(attempt) << attempt.error().message;
    bench.hands.setAttempt(*attempt);
    return *attempt;
  }

  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / "attempt.insonate";
  std::unique_ptr<test::HandsBench> owned = std::make_unique<test::HandsBench>();
  test::HandsBench& bench = *owned;
};

struct Replayed {
  MetricValues metrics;
  std::vector<AttemptEvent> events;
  std::vector<AttemptSample> samples;
};

Replayed replayed(const AttemptRecording& recording, ProcedureRun& run) {
  Replayed all{*recording.metricsUntil(), {}, {}};
  const auto played = recording.play(recording.end_us(), [&](const RecordingSegment::Entry& entry) {
    std::visit([&](const auto& what) { run.add(what); }, entry);
    if (const auto* sample = std::get_if<AttemptSample>(&entry)) all.samples.push_back(*sample);
    if (const auto* event = std::get_if<AttemptEvent>(&entry)) all.events.push_back(*event);
  });
  EXPECT_TRUE(played);
  return all;
}

bool sameSteps(const std::vector<ProcedureRun::Step>& a, const std::vector<ProcedureRun::Step>& b) {
  return std::ranges::equal(a, b, [](const auto& one, const auto& other) {
    return one.state == other.state && one.time_us == other.time_us;
  });
}

TEST_F(LiveAttemptTest, HandsOfTheMouseFromStartToFinishReplayToTheLastBit) {
  const auto attempt = begin();
  bench.hands.assignMouse(kProbeTool, pressedBy(-2));
  NeedlePlacement needle = bench.takeNeedle();
  ASSERT_TRUE(eventually([&] { return bench.hands.snapshot().present[kNeedleTool]; }));
  attempt->recordEvent(AttemptEventKind::Positioned, 15);
  bench.push(needle, 12);
  EXPECT_TRUE(eventually([&] { return attempt->view().needle == NeedlePlace::Vein; }));
  attempt->setAspirating(true);
  EXPECT_TRUE(eventually([&] { return attempt->view().nextStep == 5; })) << "blood was drawn for a second";
  attempt->recordEvent(AttemptEventKind::Frozen);
  std::this_thread::sleep_for(50ms);
  attempt->recordEvent(AttemptEventKind::Released);
  attempt->setAspirating(false);
  bench.push(needle, 24);
  EXPECT_TRUE(eventually([&] { return attempt->view().needle == NeedlePlace::WrongPlace; }));
  bench.push(needle, -5);
  EXPECT_TRUE(eventually([&] { return attempt->view().needle == NeedlePlace::Used; }));
  attempt->recordEvent(AttemptEventKind::NeedleReplaced);
  const auto live = attempt->finish(AttemptStatus::Completed);
  ASSERT_TRUE(live) << live.error().message;
  const AttemptView view = attempt->view();

  const auto recording = AttemptRecording::open(file);
  ASSERT_TRUE(recording) << recording.error().message;
  EXPECT_EQ(recording->status(), AttemptStatus::Completed);
  ProcedureRun run(attempt->procedure(), recording->header().picture);
  const Replayed again = replayed(*recording, run);
  EXPECT_EQ(again.metrics, *live);
  EXPECT_EQ(again.metrics, view.metrics);
  EXPECT_EQ(again.events, view.events);
  EXPECT_TRUE(sameSteps(run.steps(), view.steps));
  EXPECT_EQ(run.findings().size(), view.findings.size());
  EXPECT_EQ(view.needle, NeedlePlace::Clean) << "a new one";
  EXPECT_EQ(computeScore(run).points, attempt->score().points);

  EXPECT_EQ((*live)[Metric::VeinPunctures], 1);
  EXPECT_EQ((*live)[Metric::PosteriorWallPunctures], 1);
  EXPECT_EQ((*live)[Metric::Passes], 1);
  EXPECT_TRUE((*live)[Metric::TimeToVein]);
  EXPECT_TRUE((*live)[Metric::VeinCenterDistance]);
  std::vector<AttemptEventKind> kinds;
  for (const AttemptEvent& event : again.events) kinds.push_back(event.kind);
  using enum AttemptEventKind;
  EXPECT_THAT(kinds, testing::ElementsAre(Positioned, Entered, Entered, Frozen, Released, Left, Withdrawn, Withdrawn,
                                          Withdrawn, NeedleReplaced));
  EXPECT_EQ(again.events[0].tilt_deg, 15);
}

TEST_F(LiveAttemptTest, ASampleForEachTickAndNoPictureWhileItStandsStill) {
  const auto attempt = begin();
  bench.hands.assignMouse(kProbeTool, pressedBy(-2));
  std::this_thread::sleep_for(400ms);
  attempt->recordEvent(AttemptEventKind::Frozen);
  std::this_thread::sleep_for(200ms);
  const TickTiming timing = bench.hands.tickTiming();
  ASSERT_TRUE(attempt->finish(AttemptStatus::Abandoned));
  const auto recording = AttemptRecording::open(file);
  EXPECT_EQ(recording->status(), AttemptStatus::Abandoned);
  ProcedureRun run(attempt->procedure(), recording->header().picture);
  const auto samples = replayed(*recording, run).samples;
  EXPECT_GE(samples.size() + 2, timing.ticks) << "all but what came as it began";
  EXPECT_TRUE(std::ranges::any_of(samples, [](const AttemptSample& one) { return one.imageDepth_mm == 25; }));
  EXPECT_EQ(samples.back().imageDepth_mm, 0);
  ASSERT_TRUE(samples.back().patientFromProbe);
  EXPECT_LT(norm(samples.back().patientFromProbe->offset - pressedBy(-2).offset), 0.002);
  EXPECT_FALSE(samples.back().patientFromNeedle);
}

TEST_F(LiveAttemptTest, LeftAloneItIsAbandonedAndKept) {
  auto attempt = begin();
  bench.takeNeedle();
  std::this_thread::sleep_for(100ms);
  attempt = nullptr;
  owned = nullptr;
  ASSERT_TRUE(std::filesystem::exists(file));
  EXPECT_EQ(AttemptRecording::open(file)->status(), AttemptStatus::Abandoned);
  EXPECT_FALSE(LiveAttempt::start(file, {}, *loadProcedure("internal_jugular"))) << "nothing is written over";
}

/// The servo's tick and what an attempt makes of it. The recorder's thread asks for memory now and then, so that the
/// quietest of many rounds tells.
TEST_F(LiveAttemptTest, ATickThatIsRecordedAllocatesNothing) {
  const Procedure procedure = *loadProcedure("internal_jugular");
  const auto attempt = LiveAttempt::start(file, header(*bench.patient, procedure), procedure);
  ASSERT_TRUE(attempt);
  const auto grid = *TissueGrid::fromLabels(bench.patient->labels, {}, 20);
  const auto veins = std::make_shared<const std::vector<CenterLine>>(*centerLines(bench.patient->labels, kVein));
  const auto skin = std::make_shared<const SkinSurface>(*SkinSurface::make(bench.patient->labels));
  (*attempt)->setSurroundings({grid, veins, skin, {}, 40});
  HapticServo servo;
  ServoSetup setup;
  setup.needle = *loadNeedleTable(needlePresetNames().front());
  servo.configure(setup);
  std::int64_t now_ns = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
  const auto tick = [&](double depth_mm) {
    now_ns += 1'000'000;
    ServoInput input{.now_ns = now_ns, .tools = {}, .present = {true, true}};
    input.tools[kProbeTool].deviceFromStylus = pressedBy(-2);
    input.tools[kNeedleTool].deviceFromStylus = {pressedBy(0).linear, {0, depth_mm, 0}};
    for (DeviceState& hand : input.tools) hand.time_ns = now_ns;
    (*attempt)->onTick({now_ns, input.tools, input.present, servo.tick(input)});
  };
  long least = 1000;
  std::size_t events = 0;
  for (int round = 0; round < 60; ++round) {
    servo.setLocalModel({.time_ns = now_ns, .grid = grid, .restFromPatient = {}, .patches = {}});
    const long before = test::allocations();
    for (int i = 0; i < 40; ++i) tick(-5 + 0.01 * (round * 40 + i));
    least = std::min(least, test::allocations() - before);
    std::this_thread::sleep_for(3ms);
    events = (*attempt)->view().events.size();
  }
  EXPECT_EQ(least, 0);
  EXPECT_GE(events, 2U) << "through skin and vein";
  EXPECT_TRUE((*attempt)->finish(AttemptStatus::Completed));
}

}  // namespace
}  // namespace insonate
