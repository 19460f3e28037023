#include "unit/procedure/ScriptedAttempt.h"

#include <insonate/procedure/AttemptScore.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace insonate {
namespace {

using test::ScriptedAttempt;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using enum AttemptEventKind;

const std::vector<std::string> kLineVessels{"right internal jugular vein", "left internal jugular vein"};

/// A line placed step by step; each test leaves out or changes one of them.
class Line {
 public:
  ScriptedAttempt hands;

  Line() {
    hands.walls = {{kVein, 20, 30, 1}};
    hands.hasTarget = true;
  }

  void prepare() {
    for (const LineAct act : {LineAct::CheckConsent, LineAct::TimeOut, LineAct::CoverProbe, LineAct::Anesthetize})
      hands.perform(act);
  }
  void puncture() {
    hands.aspirating = true;
    hands.needleTo(25);
    hands.hold(1.5);
    hands.aspirating = false;
  }
  void insertWire(Label into = kVein, std::uint8_t vessel = 1) {
    hands.perform(LineAct::DetachSyringe);
    hands.hold(2);
    hands.perform(LineAct::HoldWire);
    hands.instrument(InstrumentEntered, Instrument::Wire, into, vessel);
    hands.wire_mm = 150, hands.wireToHeart_mm = 10;
    hands.hold(1);
    hands.needleTo(-5);
  }
  void see(AttemptEventKind plane, Label wall = kVein, std::uint8_t vessel = 1) {
    hands.instrument(plane, Instrument::Needle, wall, vessel);
  }
  void dilate(Label into = kVein) {
    hands.perform(LineAct::NickSkin);
    hands.dilator_mm = 30, hands.hold(0.5);
    hands.instrument(InstrumentEntered, Instrument::Dilator, into);
    hands.hold(0.5);
    hands.dilator_mm.reset(), hands.hold(0.1);
    hands.instrument(InstrumentRemoved, Instrument::Dilator);
  }
  void insertCatheter() {
    hands.catheter_mm = 150, hands.catheterToHeart_mm = 10, hands.hold(0.5);
    hands.instrument(InstrumentEntered, Instrument::Catheter);
    hands.wire_mm.reset(), hands.wireToHeart_mm.reset(), hands.hold(0.1);
    hands.instrument(InstrumentRemoved, Instrument::Wire);
  }
  void finish() {
    for (int lumen = 1; lumen <= kCatheterLumens; ++lumen) {
      hands.perform(LineAct::AspirateLumen, lumen);
      hands.perform(LineAct::FlushLumen, lumen);
    }
    hands.perform(LineAct::SecureCatheter);
    hands.perform(LineAct::ApplyDressing);
    hands.hold(0.1);
  }
  void place() {
    prepare(), puncture(), insertWire();
    see(WireInShortAxis), see(WireInLongAxis);
    dilate(), insertCatheter(), finish();
  }

  ProcedureRun run() const {
    ProcedureRun run(*loadProcedure("internal_jugular_line"), ScriptedAttempt::picture(), kLineVessels);
    for (const auto& entry : hands.stream) std::visit([&](const auto& what) { run.add(what); }, entry);
    return run;
  }
};

/// Names of the rules that an attempt broke.
std::vector<std::string> broken(const ProcedureRun& run) {
  std::vector<std::string> names;
  for (const ProcedureRun::Finding& finding : run.findings()) names.push_back(run.procedure().rules[finding.rule].name);
  return names;
}

TEST(LineWork, AWholeLineSucceedsStepByStep) {
  Line line;
  line.place();
  const ProcedureRun run = line.run();
  EXPECT_TRUE(run.succeeded());
  EXPECT_THAT(broken(run), testing::IsEmpty());
  for (std::size_t i = 0; i < run.steps().size(); ++i) {
    const ProcedureStep& step = run.procedure().steps[i];
    EXPECT_TRUE(step.optional || run.steps()[i].state == ProcedureRun::StepState::Done) << step.name;
  }
  const MetricValues values = run.metrics().values();
  EXPECT_EQ(values[Metric::Preparations], 4);
  EXPECT_NEAR(*values[Metric::OpenHub], 2, 0.01) << "from the syringe to the wire";
  EXPECT_EQ(values[Metric::AirVolume], 0);
  EXPECT_EQ(values[Metric::WirePlanes], 2);
  EXPECT_EQ(values[Metric::VeinConfirmations], 2);
  EXPECT_EQ(values[Metric::UnconfirmedDilations], 0);
  EXPECT_EQ(values[Metric::WireControlLosses], 0);
  EXPECT_EQ(values[Metric::WiresLost], 0);
  EXPECT_EQ(values[Metric::WireDepth], 150);
  EXPECT_EQ(values[Metric::Ectopy], 0);
  EXPECT_EQ(values[Metric::DilatorPasses], 1);
  EXPECT_EQ(values[Metric::DilatorDepth], 30);
  EXPECT_EQ(values[Metric::CatheterToHeart], 10);
  EXPECT_NEAR(*values[Metric::TimeToWire], 0.5 + 1.5 + 2, 0.01);
  EXPECT_EQ(values[Metric::LumensFlushed], 3);
  EXPECT_EQ(values[Metric::LumensFlushedFirst], 0);
  EXPECT_EQ(values[Metric::CatheterInVein], 1);
  EXPECT_EQ(values[Metric::UsedNeedleInsertions], 0);
}

/// An attempt that ends after the puncture says nothing about a line.
TEST(LineWork, APunctureAloneHasNoValues) {
  ScriptedAttempt attempt;
  attempt.needleTo(25);
  const MetricValues values = attempt.values();
  for (int i = static_cast<int>(Metric::Preparations); i <= static_cast<int>(Metric::CatheterInVein); ++i)
    EXPECT_EQ(values[static_cast<Metric>(i)], std::nullopt) << metricTable()[static_cast<std::size_t>(i)].id;
}

TEST(LineWork, DilationWithoutBothPlanesIsCritical) {
  for (const auto& seen : {std::vector<AttemptEventKind>{}, {WireInShortAxis}, {WireInLongAxis}}) {
    Line line;
    line.prepare(), line.puncture(), line.insertWire();
    for (const AttemptEventKind plane : seen) line.see(plane);
    line.hands.perform(LineAct::MeasurePressure, 8);  // a proof of the vein, and not of the wire
    line.dilate();
    line.see(WireInShortAxis), line.see(WireInLongAxis);
    line.insertCatheter(), line.finish();
    const ProcedureRun run = line.run();
    EXPECT_THAT(broken(run), Contains("dilated unseen"));
    EXPECT_FALSE(run.succeeded());
    EXPECT_EQ(run.metrics().value(Metric::WirePlanes), static_cast<double>(seen.size())) << "later views do not count";
    EXPECT_EQ(run.metrics().value(Metric::VeinConfirmations), static_cast<double>(seen.size()) + 1);
    EXPECT_EQ(computeScore(run).points, 0);
  }
}

/// A flush proves the vein only where the live image has shown its bubbles.
TEST(LineWork, BubblesProveTheVeinInWhichTheyWereSeen) {
  const auto proofs = [](const auto& after) {
    Line line;
    line.prepare(), line.puncture();
    line.hands.perform(LineAct::FlushForBubbles);
    after(line);
    line.insertWire();
    return *line.run().metrics().value(Metric::VeinConfirmations);
  };
  EXPECT_EQ(proofs([](Line&) {}), 0) << "they were not seen";
  EXPECT_EQ(proofs([](Line& line) { line.see(BubblesSeen); }), 1);
  EXPECT_EQ(proofs([](Line& line) { line.see(BubblesSeen), line.see(BubblesSeen); }), 1);
  EXPECT_EQ(proofs([](Line& line) { line.see(BubblesSeen, kArtery, 2); }), 0);
  EXPECT_EQ(proofs([](Line& line) { line.see(BubblesSeen, kVein, 2); }), 0) << "another vein";
}

/// Both planes showed a wire, but in the wrong vessel.
TEST(LineWork, AWireSeenInAnotherVesselIsNoProof) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire(kVein, 2);
  line.see(WireInShortAxis, kVein, 2), line.see(WireInLongAxis, kVein, 2);
  line.dilate();
  EXPECT_THAT(broken(line.run()), Contains("dilated unseen"));
}

TEST(LineWork, ADilatedArteryIsCritical) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire(kArtery, 3);
  line.see(WireInShortAxis, kArtery, 3), line.see(WireInLongAxis, kArtery, 3);
  line.dilate(kArtery);
  const ProcedureRun run = line.run();
  EXPECT_EQ(run.metrics().value(Metric::ArteryDilations), 1);
  EXPECT_THAT(broken(run), Contains("dilated artery"));
  EXPECT_THAT(broken(run), Contains("dilated unseen"));
}

/// A second wire has to be seen again.
TEST(LineWork, ANewWireIsUnseen) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire();
  line.see(WireInShortAxis), line.see(WireInLongAxis);
  line.hands.wire_mm.reset(), line.hands.hold(0.1);
  line.hands.instrument(InstrumentRemoved, Instrument::Wire);
  EXPECT_FALSE(line.run().metrics().line().isWireSeenInShortAxis);
  line.puncture(), line.insertWire(), line.dilate();
  EXPECT_THAT(broken(line.run()), Contains("dilated unseen"));
}

TEST(LineWork, AWireThatIsNotHeldIsCountedOnceForEachLoss) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire();
  line.see(WireInShortAxis), line.see(WireInLongAxis);
  line.hands.perform(LineAct::ReleaseWire);
  line.dilate();
  EXPECT_EQ(line.run().metrics().value(Metric::WireControlLosses), 1);
  line.hands.perform(LineAct::HoldWire);
  line.hands.hold(0.1);
  line.hands.perform(LineAct::ReleaseWire);
  line.hands.catheter_mm = 50, line.hands.hold(0.1);
  EXPECT_EQ(line.run().metrics().value(Metric::WireControlLosses), 2);
  line.hands.instrument(WireLost, Instrument::Wire);
  EXPECT_THAT(broken(line.run()), Contains("wire lost"));
  EXPECT_TRUE(line.run().metrics().line().isWireLost);
}

TEST(LineWork, AnOpenHubAndItsAirAreCounted) {
  Line line;
  line.prepare(), line.puncture();
  line.hands.perform(LineAct::DetachSyringe);
  line.hands.hold(1);
  line.hands.perform(LineAct::CoverHub);
  line.hands.hold(10);
  EXPECT_NEAR(*line.run().metrics().value(Metric::OpenHub), 1, 0.01) << "a covered hub is closed";
  line.hands.perform(LineAct::UncoverHub);
  line.hands.hold(5);
  line.hands.stream.push_back(AttemptEvent{.kind = AirEntered, .amount = 15});
  line.hands.stream.push_back(AttemptEvent{.kind = AirEntered, .amount = 10});
  line.hands.hold(0.1);
  const ProcedureRun run = line.run();
  EXPECT_NEAR(*run.metrics().value(Metric::OpenHub), 6.1, 0.02);
  EXPECT_EQ(run.metrics().value(Metric::AirVolume), 25);
  EXPECT_THAT(broken(run), Contains("open hub"));
  EXPECT_THAT(broken(run), Contains("air"));
}

TEST(LineWork, AWireInTheHeartCountsItsTime) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire();
  line.hands.wire_mm = 220, line.hands.wireToHeart_mm = -60;
  line.hands.hold(4);
  line.hands.wire_mm = 150, line.hands.wireToHeart_mm = 10;
  line.hands.hold(3);
  const ProcedureRun run = line.run();
  EXPECT_NEAR(*run.metrics().value(Metric::Ectopy), 4, 0.01);
  EXPECT_EQ(run.metrics().value(Metric::WireDepth), 220);
  EXPECT_THAT(broken(run), Contains("extra beats"));
  EXPECT_THAT(broken(run), Contains("wire deep"));
}

TEST(LineWork, TheRhythmFollowsTheWire) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire();
  const auto rhythmAt = [&](double toHeart_mm) {
    line.hands.wireToHeart_mm = toHeart_mm;
    line.hands.hold(0.1);
    return line.run().metrics().line().rhythm;
  };
  EXPECT_EQ(rhythmAt(5), HeartRhythm::Sinus);
  EXPECT_EQ(rhythmAt(-5), HeartRhythm::ExtraBeats);
  EXPECT_EQ(rhythmAt(-45), HeartRhythm::Tachycardia);
  line.hands.stream.push_back(AttemptEvent{.kind = Tachycardia});
  EXPECT_THAT(broken(line.run()), Contains("tachycardia"));
}

TEST(LineWork, AKinkIsAnErrorUntilTheWireIsOut) {
  Line line;
  line.prepare(), line.puncture(), line.insertWire();
  line.hands.instrument(WireKinked, Instrument::Wire);
  const ProcedureRun run = line.run();
  EXPECT_EQ(run.metrics().value(Metric::WireKinks), 1);
  EXPECT_THAT(broken(run), Contains("wire kinked"));
  EXPECT_THAT(refusalOf(run.metrics().line(), Instrument::Wire, true), testing::HasSubstr("kink"));
  EXPECT_EQ(refusalOf(run.metrics().line(), Instrument::Wire, false), "");
  line.hands.wire_mm.reset(), line.hands.hold(0.1);
  line.hands.instrument(InstrumentRemoved, Instrument::Wire);
  EXPECT_FALSE(line.run().metrics().line().isWireKinked);
}

TEST(LineWork, TheColorOfBloodAndALumenFlushedFirstAreErrors) {
  Line line;
  line.puncture();
  line.hands.perform(LineAct::TrustBloodColor);
  line.insertWire();
  line.see(WireInShortAxis), line.see(WireInLongAxis);
  line.dilate(), line.insertCatheter();
  line.hands.perform(LineAct::FlushLumen, 2);
  line.finish();
  const ProcedureRun run = line.run();
  EXPECT_THAT(broken(run), Contains("blood color"));
  EXPECT_THAT(broken(run), Contains("flushed first"));
  EXPECT_THAT(broken(run), Contains("preparation")) << "none was done";
  EXPECT_EQ(run.metrics().value(Metric::LumensFlushedFirst), 1);
  EXPECT_EQ(run.metrics().value(Metric::Preparations), 0);
  EXPECT_TRUE(run.succeeded()) << "none of them is critical";
}

/// The needle that leaves the skin over the wire ends no pass; without a wire it does, and the steps begin again.
TEST(LineWork, TheNeedleOverTheWireKeepsTheSteps) {
  Line over;
  over.prepare(), over.puncture(), over.insertWire();
  const ProcedureRun run = over.run();
  ASSERT_TRUE(run.nextStep());
  EXPECT_EQ(run.procedure().steps[*run.nextStep()].name, "short axis");
  Line without;
  without.prepare(), without.puncture();
  without.hands.needleTo(-5);
  const ProcedureRun again = without.run();
  EXPECT_EQ(again.procedure().steps[*again.nextStep()].name, "skin");
}

std::string dueStep(const ProcedureRun& run) {
  return run.nextStep() ? run.procedure().steps[*run.nextStep()].name : "";
}

TEST(LineWork, AWireIsInsertedOnceItIsLongEnough) {
  Line line;
  line.prepare(), line.puncture();
  line.hands.perform(LineAct::DetachSyringe);
  line.hands.instrument(InstrumentEntered, Instrument::Wire);
  line.hands.wire_mm = 77, line.hands.hold(0.5);
  EXPECT_EQ(dueStep(line.run()), "wire") << "it does not go on";
  line.hands.wire_mm = 150, line.hands.hold(0.1);
  EXPECT_EQ(dueStep(line.run()), "needle out");
  Line kinked;
  kinked.prepare(), kinked.puncture();
  kinked.hands.perform(LineAct::DetachSyringe);
  kinked.hands.instrument(InstrumentEntered, Instrument::Wire);
  kinked.hands.instrument(WireKinked, Instrument::Wire);
  kinked.hands.wire_mm = 160, kinked.hands.hold(0.1);
  EXPECT_EQ(dueStep(kinked.run()), "wire");
}

/// A tilted table before the attempt leaves nothing out.
TEST(LineWork, TheStepsBeforeThePositionStayDue) {
  Line line;
  line.hands.tell(AttemptEventKind::Positioned);
  EXPECT_EQ(dueStep(line.run()), "consent");
  line.hands.perform(LineAct::CheckConsent), line.hands.perform(LineAct::TimeOut);
  EXPECT_EQ(dueStep(line.run()), "survey");
  const ProcedureRun run = line.run();
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(run.steps()[i].state, ProcedureRun::StepState::Done) << i;
}

/// The trainee gives up the wire: through the needle, only the wire is due again; without the needle, a new puncture.
TEST(LineWork, AWireThatComesOutIsDueAgain) {
  Line line;
  line.prepare(), line.puncture();
  line.hands.perform(LineAct::DetachSyringe);
  line.hands.instrument(InstrumentEntered, Instrument::Wire);
  line.hands.wire_mm = 160, line.hands.hold(0.1);
  EXPECT_EQ(dueStep(line.run()), "needle out");
  line.hands.wire_mm.reset(), line.hands.hold(0.1);
  line.hands.instrument(InstrumentRemoved, Instrument::Wire);
  EXPECT_EQ(dueStep(line.run()), "wire");
  line.hands.needleTo(-5);
  EXPECT_EQ(dueStep(line.run()), "skin") << "the needle that came out without a wire completes no step";
  Line later;
  later.prepare(), later.puncture(), later.insertWire();
  later.hands.wire_mm.reset(), later.hands.hold(0.1);
  later.hands.instrument(InstrumentRemoved, Instrument::Wire);
  EXPECT_EQ(dueStep(later.run()), "skin");
}

/// Neither aspiration nor the views of the wire can be done after the dilator; the list goes on.
TEST(LineWork, StepsThatCanNoLongerBeDoneAreSkipped) {
  Line line;
  line.prepare();
  line.hands.needleTo(25);
  line.insertWire();
  EXPECT_EQ(dueStep(line.run()), "short axis");
  line.dilate(), line.insertCatheter();
  EXPECT_EQ(dueStep(line.run()), "lumens");
  line.finish();
  const ProcedureRun run = line.run();
  EXPECT_FALSE(run.succeeded());
  for (std::size_t i = 0; i < run.steps().size(); ++i) {
    const std::string& name = run.procedure().steps[i].name;
    const bool isPassedOver = name == "confirm" || name == "short axis" || name == "long axis";
    EXPECT_TRUE(!isPassedOver || run.steps()[i].state == ProcedureRun::StepState::Skipped) << name;
  }
}

/// The time-out before the consent: both are done, whatever their order.
TEST(LineWork, AnActAfterItsStepStillCounts) {
  Line line;
  line.hands.hold(0.1);
  line.hands.perform(LineAct::TimeOut);
  line.hands.hold(0.1);
  EXPECT_EQ(line.run().steps()[0].state, ProcedureRun::StepState::Skipped);
  line.hands.perform(LineAct::CheckConsent);
  line.hands.hold(0.1);
  EXPECT_EQ(line.run().steps()[0].state, ProcedureRun::StepState::Done);
}

TEST(LineWork, TheMomentsAreSentences) {
  Line line;
  line.place();
  const auto said = test::sentences(computeScore(line.run()));
  EXPECT_THAT(said, Contains("The time-out is done."));
  EXPECT_THAT(said, Contains("The wire is in the right internal jugular vein."));
  EXPECT_THAT(said, Contains("The image shows the wire in the right internal jugular vein, in long axis."));
  EXPECT_THAT(said, Contains("The wire is out of the skin."));
  EXPECT_THAT(said, Contains("Lumen 3 is flushed and clamped."));
  EXPECT_THAT(said, Not(Contains(HasSubstr("lead"))));
}

}  // namespace
}  // namespace insonate
