#include "HandsBench.h"
#include "hand/SkinSurface.h"

#include <insonate/procedure/AttemptRecording.h>
#include <insonate/simulator/AttemptOrigin.h>
#include <insonate/simulator/LiveAttempt.h>

#include <gmock/gmock.h>
#include <support/Allocations.h>
#include <support/TestData.h>

#include <cmath>
#include <numbers>

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

/// Images over a round vein of 10 mm, whose center is 12 mm deep.
class VeinUnderTheProbe : public testing::Test {
 protected:
  void SetUp() override {
    CaseManifest manifest;
    manifest.targets = {{"right internal jugular vein", kVein, {0, 12, 0}}};
    manifest.vessels = {{"right internal jugular vein", kVein, {{{0, 12, -50}, 5}, {{0, 12, 50}, 5}}}};
    const Procedure procedure = *loadProcedure("internal_jugular");
    const VesselLocator names(manifest, procedure, {0, 0, 0});
    AttemptHeader start = headerOf(procedure, *test::wideCase(), *loadProbe("linear"), "insonate test");
    start.vessels = names.names();
    attempt_ = *LiveAttempt::start(folder_ / "attempt", start, procedure, names);
    VolumeGeometry geometry;
    geometry.size = {41, 41, 21};
    geometry.origin_mm = {-20, -6, -10};
    LabelMap labels(geometry);
    for (int k = 0; k < geometry.size[2]; ++k)
      for (int j = 0; j < geometry.size[1]; ++j)
        for (int i = 0; i < geometry.size[0]; ++i)
          labels.at(i, j, k) = std::hypot(i - 20, j - 18) < 5 ? kVein : kSoftTissue;
    around_.grid = *TissueGrid::fromLabels(labels);
  }

  /// An image of the probe `deeper_mm` into the body and `slid_mm` beside its first place, whose middle line passes
  /// `beside_mm` beside the vein's center. `isFlat`: the lumen is not seen between its walls.
  void see(double deeper_mm, double slid_mm, double beside_mm, bool isFlat = false) {
    Transform pose = pressedBy(deeper_mm);
    pose.offset.x += slid_mm;
    see(pose, beside_mm, isFlat);
  }
  void see(const Transform& pose, double beside_mm, bool isFlat = false) {
    auto frame = std::make_shared<LiveFrame>();
    frame->patientFromProbe = pose;
    frame->press.force_N = 1;
    for (double y = 0; y < 30; y += kMiddleStep_mm)
      if (!isFlat || std::abs(y - 12) > 5.5) frame->press.middleAtRest_mm.push_back({beside_mm, y, 0});
    attempt_->addFrame(frame, around_);
  }
  /// An image of the probe `deeper_mm` into the body and `slid_mm` beside its first place. The tissue has moved 7 mm
  /// aside; around the vein's center, each direction is compressed to 1/`flatter` of its length.
  void seeMovedAside(double deeper_mm, double slid_mm, double flatter) {
    auto frame = std::make_shared<LiveFrame>();
    frame->patientFromProbe = pressedBy(deeper_mm);
    frame->patientFromProbe.offset.x += slid_mm;
    frame->press.force_N = 1;
    PlaneDisplacement& moved = frame->press.displacement;
    moved = {.left_mm = -25, .top_mm = 0, .step_mm = 1, .columns = 51, .rows = 31, .restFromDisplayed = {}};
    const Vec3 center = inverted(frame->patientFromProbe) * Vec3{0, 12, 0}, seen = center + Vec3{7, 0, 0};
    for (int row = 0; row < moved.rows; ++row)
      for (int column = 0; column < moved.columns; ++column) {
        const Vec3 at{moved.left_mm + column, 0, static_cast<double>(row)};
        const Vec3 shift = center + (at - seen) * flatter - at;
        moved.restFromDisplayed.push_back({static_cast<float>(shift.x), static_cast<float>(shift.z)});
      }
    for (double z = kMiddleStep_mm / 2; z < 30; z += kMiddleStep_mm)
      frame->press.middleAtRest_mm.push_back(frame->patientFromProbe * (Vec3{0, 0, z} + shiftAt(moved, 0, z)));
    attempt_->addFrame(frame, around_);
  }
  bool isCentered() const { return attempt_->view().isVeinCentered; }
  bool isCompressed() const { return attempt_->view().isVeinCompressed; }

  const test::TemporaryFolder folder_;
  LiveAttempt::Surroundings around_;
  std::shared_ptr<LiveAttempt> attempt_;
};

TEST_F(VeinUnderTheProbe, StaysCenteredWhileStrongerCompressionMovesItAside) {
  see(0, 0, 4);
  EXPECT_FALSE(isCentered());
  see(0, 0, 0);
  EXPECT_TRUE(isCentered());
  see(6, 0, 4.5);
  EXPECT_TRUE(isCentered());
  see(6, 2, 4.5);
  EXPECT_FALSE(isCentered()) << "the probe was slid";
  see(6, 0, 4.5);
  EXPECT_TRUE(isCentered());
  see(0, 0, 4.5);
  EXPECT_FALSE(isCentered()) << "it is not in the middle after the release";
}

TEST_F(VeinUnderTheProbe, IsCompressedUntilTheProbeReleasesIt) {
  see(0, 0, 0);
  EXPECT_FALSE(isCompressed());
  see(8, 0, 0, true);
  EXPECT_TRUE(isCompressed());
  see(14, 0, 4.5, true);
  EXPECT_TRUE(isCompressed());
  see(6, 0, 0, true);
  EXPECT_TRUE(isCompressed());
  see(4, 0, 0);
  EXPECT_FALSE(isCompressed());
  see(8, 0, 0);
  EXPECT_FALSE(isCompressed()) << "it is no longer flat";
}

TEST_F(VeinUnderTheProbe, IsNeitherCenteredNorCompressedByATurnedProbe) {
  const Vec3 at_mm = pressedBy(8).offset;
  const double turned = 5 * std::numbers::pi / 180;
  const Transform tilted = *patientFromProbe(at_mm, {0, std::cos(turned), std::sin(turned)}, {1, 0, 0});
  const Transform rotated = *patientFromProbe(at_mm, {0, 1, 0}, {std::cos(turned), 0, std::sin(turned)});
  for (const Transform& pose : {tilted, rotated}) {
    see(0, 0, 0);
    see(pose, 4.5);
    EXPECT_FALSE(isCentered()) << "the probe has not only compressed the tissue";
    see(0, 0, 4.5);
    see(0, 0, 0);
    see(8, 0, 0, true);
    EXPECT_TRUE(isCompressed());
    see(pose, 0, true);
    EXPECT_FALSE(isCompressed());
    see(0, 0, 4.5);
  }
}

TEST_F(VeinUnderTheProbe, IsCompressedByItsAreaIfTheTissueMovesItAside) {
  see(0, 0, 0);
  seeMovedAside(6, 0, 1);
  EXPECT_TRUE(isCentered()) << "the probe only presses";
  EXPECT_FALSE(isCompressed()) << "the vein is beside the middle, and as wide as before";
  seeMovedAside(8, 0, 1.4);
  EXPECT_FALSE(isCompressed()) << "half of its area is left";
  seeMovedAside(9, 0, 1.8);
  EXPECT_TRUE(isCompressed());
  EXPECT_TRUE(eventually([&] {
    return std::ranges::any_of(attempt_->view().events, [](const AttemptEvent& event) {
      return event.kind == AttemptEventKind::Compressed && event.vessel == 1 && std::abs(event.tip_mm.x) < 1;
    });
  }));
}

TEST_F(VeinUnderTheProbe, IsNotCompressedByAProbeThatSlidesAway) {
  see(0, 0, 0);
  seeMovedAside(9, 3, 1.8);
  EXPECT_FALSE(isCompressed());
  seeMovedAside(9, 0, 1.8);
  EXPECT_FALSE(isCompressed()) << "the vein was not in the middle since";
}

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
