#include "line/LineHands.h"
#include "line/PleuraSight.h"
#include "line/WireSight.h"

#include <insonate/procedure/Procedure.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace insonate {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using enum AttemptEventKind;

/// A straight right internal jugular vein of 6 mm radius along the body, and a carotid artery 20 mm beside it. The head
/// is toward +z; the skin is 18 mm in front of the vein, toward -y.
CaseManifest manifest() {
  CaseManifest made;
  NamedVessel vein{.name = "right internal jugular vein", .label = kVein, .course = {}},
      artery{.name = "right common carotid artery", .label = kArtery, .course = {}};
  for (int z = 100; z >= -100; z -= 10) {
    vein.course.push_back({{0, 0, double(z)}, 6});
    artery.course.push_back({{20, 0, double(z)}, 4});
  }
  made.vessels = {vein, artery};
  made.targets = {{"right internal jugular vein", kVein, {0, 0, 0}}};
  return made;
}

class LineHandsTest : public testing::Test {
 protected:
  LineHandsTest() : hands(*LineHands::make(manifest().vessels, locator())) {}

  static VesselLocator locator() {
    return VesselLocator(manifest(), *builtInProcedure("internal_jugular_line"), {0, 0, 0});
  }

  /// The needle comes from the head and the front at 45 degrees, with its tip on the axis of the vein.
  LineNeedle needle(Label in = kVein, bool isInBody = true) const {
    const Vec3 axis = normalized({0, 1, -1}), x{1, 0, 0};
    return {isInBody, in, isInBody ? depth_mm : 0.0, Transform{{{x, cross(axis, x), axis}}, tip_mm}, Transform{}, 70};
  }
  void wait(double seconds, const LineNeedle& held) {
    for (int i = 0; i < std::lround(seconds * 30); ++i) {
      time_us += 33'333;
      hands.follow(time_us, held, physiology, static_cast<double>(time_us) * 1e-6);
    }
  }
  void puncture() {
    hands.add({.kind = Entered, .wall = kSkin, .into = kFat});
    hands.add({.kind = Entered, .wall = kVein, .into = kVein, .vessel = 1, .depth_mm = 17});
    wait(0.1, needle());
  }
  std::string move(Instrument instrument, double by_mm) { return hands.move(time_us, instrument, by_mm); }
  std::string perform(LineAct act, int lumen = 1) {
    const auto done = hands.perform(time_us, act, lumen);
    return done ? std::string() : done.error().message;
  }
  void insertWire(double by_mm) {
    puncture();
    EXPECT_THAT(perform(LineAct::DetachSyringe), IsEmpty());
    EXPECT_THAT(move(Instrument::Wire, by_mm), IsEmpty());
  }
  /// The needle is withdrawn over the wire, and the skin is nicked.
  void clearWay() {
    wait(0.1, needle(kBackground, false));
    EXPECT_THAT(perform(LineAct::NickSkin), IsEmpty());
  }
  AttemptSample lengths() const {
    AttemptSample sample;
    hands.fill(sample);
    return sample;
  }
  int count(AttemptEventKind kind) {
    for (const AttemptEvent& event : hands.takeEvents()) events.push_back(event);
    return static_cast<int>(std::ranges::count(events, kind, &AttemptEvent::kind));
  }

  Vec3 tip_mm{0, 0, 0};
  double depth_mm = 25;
  Physiology physiology;
  std::int64_t time_us = 0;
  std::vector<AttemptEvent> events;
  LineHands hands;
};

TEST_F(LineHandsTest, ACaseWithoutNamedVesselsHasNoLine) {
  EXPECT_FALSE(LineHands::make({}, locator()));
}

TEST_F(LineHandsTest, TheWireGoesTowardTheHeart) {
  EXPECT_THAT(move(Instrument::Wire, 10), HasSubstr("Insert the needle first"));
  insertWire(100);
  EXPECT_EQ(count(InstrumentEntered), 1);
  const auto entered = std::ranges::find(events, InstrumentEntered, &AttemptEvent::kind);
  EXPECT_EQ(entered->into, kVein);
  EXPECT_EQ(entered->vessel, 1);
  EXPECT_NEAR(*lengths().wire_mm, 125, 0.01);
  EXPECT_LT(hands.wire_mm().back().z, -60) << "caudal";
  const double before_mm = *lengths().wireToHeart_mm;
  EXPECT_THAT(move(Instrument::Wire, 20), IsEmpty());
  EXPECT_NEAR(*lengths().wireToHeart_mm, before_mm - 20, 2);
  EXPECT_TRUE(hands.state().isWireHeld) << "the hand that moves the wire holds it";
}

/// 16 cm are the mean distance from the right internal jugular vein to the heart; 30 cm are in the heart.
TEST_F(LineHandsTest, TooMuchWireReachesTheHeartOnce) {
  insertWire(300);
  EXPECT_EQ(count(Ectopy), 1);
  EXPECT_EQ(count(Tachycardia), 1) << "it is through the atrium";
  EXPECT_LT(*lengths().wireToHeart_mm, -kTachycardiaFrom_mm);
  EXPECT_EQ(hands.state().rhythm, HeartRhythm::Tachycardia);
  move(Instrument::Wire, -200);
  EXPECT_GT(*lengths().wireToHeart_mm, 0);
  EXPECT_EQ(hands.state().rhythm, HeartRhythm::Sinus);
  move(Instrument::Wire, 200);
  EXPECT_EQ(count(Ectopy), 2) << "again after it was out of the heart";
}

TEST_F(LineHandsTest, BehindTheVeinTheWireStops) {
  tip_mm = {0, 12, -12}, depth_mm = 42;
  hands.add({.kind = Entered, .wall = kVein, .into = kVein, .vessel = 1, .depth_mm = 17});
  hands.add({.kind = Left, .wall = kVein, .into = kMuscle, .vessel = 1, .depth_mm = 34});
  wait(0.1, needle(kMuscle));
  perform(LineAct::DetachSyringe);
  EXPECT_THAT(move(Instrument::Wire, 8), HasSubstr("does not go on"));
  EXPECT_EQ(count(InstrumentStopped), 1);
  EXPECT_EQ(count(WireKinked), 0);
  EXPECT_LT(*lengths().wire_mm, depth_mm + 30);
  EXPECT_FALSE(lengths().wireToHeart_mm);
}

TEST_F(LineHandsTest, ACorrectedNeedleStartsTheWireAgain) {
  tip_mm = {0, 12, -12}, depth_mm = 42;
  wait(0.1, needle(kMuscle));
  perform(LineAct::DetachSyringe);
  EXPECT_THAT(move(Instrument::Wire, 8), HasSubstr("correct the position of the needle"));
  tip_mm = {0, 0, 0}, depth_mm = 25;
  wait(0.1, needle());
  EXPECT_THAT(move(Instrument::Wire, 60), IsEmpty());
  EXPECT_EQ(hands.state().wireIn, kVein);
}

/// No instrument follows over a kinked wire, and a new wire is straight.
TEST_F(LineHandsTest, AWireThatIsPushedAgainstAResistanceKinks) {
  tip_mm = {0, 12, -12}, depth_mm = 42;
  wait(0.1, needle(kMuscle));
  perform(LineAct::DetachSyringe);
  EXPECT_THAT(move(Instrument::Wire, 8), HasSubstr("does not go on"));
  EXPECT_THAT(move(Instrument::Wire, 2), HasSubstr("does not go on"));
  EXPECT_EQ(count(WireKinked), 0) << "a push that is noticed in time";
  EXPECT_THAT(move(Instrument::Wire, 8), HasSubstr("kink"));
  EXPECT_THAT(move(Instrument::Wire, 3), HasSubstr("kink"));
  EXPECT_EQ(count(WireKinked), 1);
  const double in_mm = *lengths().wire_mm;
  EXPECT_THAT(move(Instrument::Wire, -2), IsEmpty()) << "it comes back freely";
  EXPECT_NEAR(*lengths().wire_mm, in_mm - 2, 1e-6);
  clearWay();
  EXPECT_THAT(move(Instrument::Dilator, 5), HasSubstr("does not pass the kink"));
  EXPECT_THAT(move(Instrument::Wire, -100), IsEmpty());
  EXPECT_FALSE(hands.state().isWireKinked);
  tip_mm = {0, 0, 0}, depth_mm = 25;
  wait(0.1, needle());
  EXPECT_THAT(move(Instrument::Wire, 60), IsEmpty());
}

/// Through the vein into the artery, and back: the pressure is that of the vein again.
TEST_F(LineHandsTest, TheVesselIsThatOfTheTip) {
  puncture();
  hands.add({.kind = Left, .wall = kVein, .into = kMuscle, .vessel = 1, .depth_mm = 34});
  hands.add({.kind = Entered, .wall = kArtery, .into = kArtery, .vessel = 2, .depth_mm = 40});
  hands.add({.kind = Withdrawn, .wall = kArtery, .into = kMuscle, .vessel = 2, .depth_mm = 40});
  hands.add({.kind = Withdrawn, .wall = kVein, .into = kVein, .vessel = 1, .depth_mm = 34});
  wait(0.1, needle());
  EXPECT_THAT(perform(LineAct::MeasurePressure), IsEmpty());
  count(Performed);
  EXPECT_EQ(events.back().wall, kVein);
  EXPECT_EQ(events.back().vessel, 1);
  perform(LineAct::DetachSyringe);
  move(Instrument::Wire, 140);
  clearWay();
  move(Instrument::Dilator, 16);
  EXPECT_EQ(hands.state().dilations, 0);
  move(Instrument::Dilator, 2);
  EXPECT_EQ(hands.state().dilations, 1) << "the wall of the vein is 17 mm deep";
}

TEST_F(LineHandsTest, NoMoreWireThanThereIs) {
  puncture();
  perform(LineAct::DetachSyringe);
  EXPECT_THAT(move(Instrument::Wire, 700), HasSubstr("in your hand"));
  EXPECT_LE(*lengths().wire_mm, 580.01);
  EXPECT_EQ(count(WireLost), 0);
}

TEST_F(LineHandsTest, ADeepCatheterKeepsItsCourse) {
  insertWire(140);
  clearWay();
  move(Instrument::Dilator, 30), move(Instrument::Dilator, -40);
  move(Instrument::Catheter, 150);
  const double toHeart_mm = *lengths().catheterToHeart_mm;
  move(Instrument::Wire, -60);
  move(Instrument::Catheter, -5);
  EXPECT_NEAR(*lengths().catheterToHeart_mm, toHeart_mm + 5, 2);
}

/// Tremor of a tenth of a millimeter does not creep.
TEST_F(LineHandsTest, TremorDoesNotPullOutALooseWire) {
  insertWire(100);
  perform(LineAct::ReleaseWire);
  for (int i = 0; i < 100; ++i) {
    depth_mm = 25 + (i % 2 ? 0.1 : -0.1);
    wait(1.0 / 30, needle());
  }
  EXPECT_NEAR(*lengths().wire_mm, 125, 0.6);
}

TEST_F(LineHandsTest, ANeedleTakesALooseWireAlong) {
  insertWire(100);
  perform(LineAct::ReleaseWire);
  depth_mm = 15;
  wait(0.1, needle());
  EXPECT_NEAR(*lengths().wire_mm, 115, 0.01);
}

TEST_F(LineHandsTest, DilatorAndCatheterFollowTheWire) {
  insertWire(180);
  clearWay();
  EXPECT_THAT(move(Instrument::Dilator, 10), IsEmpty());
  EXPECT_EQ(count(InstrumentEntered), 1) << "the wall is 17 mm deep";
  EXPECT_THAT(move(Instrument::Dilator, 10), IsEmpty());
  EXPECT_EQ(count(InstrumentEntered), 2);
  EXPECT_EQ(hands.state().dilations, 1);
  EXPECT_THAT(move(Instrument::Catheter, 10), HasSubstr("dilator is on the wire"));
  EXPECT_THAT(move(Instrument::Dilator, -30), IsEmpty());
  EXPECT_EQ(count(InstrumentRemoved), 1);
  EXPECT_THAT(move(Instrument::Catheter, 150), IsEmpty());
  const double toHeart_mm = *lengths().catheterToHeart_mm;
  EXPECT_GT(toHeart_mm, *lengths().wireToHeart_mm + 30) << "the wire is 55 mm deeper, and its tip is a J";
  EXPECT_THAT(move(Instrument::Wire, -300), IsEmpty());
  EXPECT_FALSE(lengths().wire_mm);
  EXPECT_NEAR(*lengths().catheterToHeart_mm, toHeart_mm, 0.01) << "the catheter stays";
  EXPECT_THAT(move(Instrument::Catheter, -20), IsEmpty());
  EXPECT_NEAR(*lengths().catheterToHeart_mm, toHeart_mm + 20, 2);
  EXPECT_EQ(hands.state().catheterIn, kVein);
  EXPECT_THAT(perform(LineAct::AspirateLumen, 1), IsEmpty());
}

TEST_F(LineHandsTest, SkinAndTissueHoldBackWithoutNickAndDilator) {
  insertWire(140);
  wait(0.1, needle(kBackground, false));
  EXPECT_THAT(move(Instrument::Dilator, 10), HasSubstr("Nick the skin"));
  EXPECT_THAT(move(Instrument::Catheter, 10), HasSubstr("Dilate first"));
  EXPECT_THAT(move(Instrument::Dilator, 10), HasSubstr("Nick the skin"));
  EXPECT_EQ(count(InstrumentStopped), 2) << "each instrument once";
  EXPECT_FALSE(lengths().dilator_mm);
}

/// A wire of 600 mm with 395 mm in the body does not reach through a catheter of 300 mm with its hub.
TEST_F(LineHandsTest, AWireInsideTheCatheterCannotBeHeldAndIsLost) {
  insertWire(370);
  clearWay();
  move(Instrument::Dilator, 30), move(Instrument::Dilator, -40);
  EXPECT_TRUE(hands.state().isWireHeld);
  for (int i = 0; i < 19; ++i) move(Instrument::Catheter, 10);
  EXPECT_FALSE(hands.state().isWireHeld);
  EXPECT_EQ(count(WireLost), 1);
  EXPECT_THAT(move(Instrument::Wire, -10), HasSubstr("cannot be reached"));
}

/// With the head down the vein is full. With the head up its pressure at the hub is below that of the room: by
/// Q = C A sqrt(2 p / rho).
TEST_F(LineHandsTest, AnOpenHubTakesInAirOnlyBelowThePressureOfTheRoom) {
  physiology.breathing_perMin = 0;
  puncture();
  perform(LineAct::DetachSyringe);
  physiology.tilt_deg = 15;
  wait(5, needle());
  EXPECT_EQ(count(AirEntered), 0);
  physiology.tilt_deg = -20;
  wait(3, needle());
  perform(LineAct::CoverHub);
  wait(3, needle());
  EXPECT_GT(count(AirEntered), 0);
  double air_ml = 0;
  for (const AttemptEvent& event : events)
    if (event.kind == AirEntered) air_ml += event.amount;
  const double height_mm = 70 / std::sqrt(2);
  const double suction_Pa = -(venousPressure_mmHg(physiology, 0) - 0.078 * height_mm) * kPascalPermmHg;
  EXPECT_NEAR(air_ml, 3 * 0.7 * 0.55 * std::sqrt(2 * suction_Pa / 1.2), 1.5);
}

/// The image plane holds the vein, or crosses it; its image is 40 mm deep.
TEST_F(LineHandsTest, TheWireIsSeenInBothPlanes) {
  insertWire(100);
  const ImageField field{.width_mm = 38, .sliceHalf_mm = 1};
  const Vec3 down{0, 1, 0}, left{1, 0, 0}, head{0, 0, 1};
  const PlaneDisplacement none;
  // The wire lies on a wall of the vein, up to 6 mm beside its axis.
  const double beside_mm = hands.wire_mm()[20].x;
  const Transform along{{{head, cross(down, head), down}}, {beside_mm, -18, -30}};
  const Transform across{{{left, cross(down, left), down}}, {0, -18, -30}};
  const LineHands::Sight inLong = wireSightOf({along, none, field, 40}, hands);
  EXPECT_TRUE(inLong.isInLongAxis);
  EXPECT_FALSE(inLong.isInShortAxis);
  const LineHands::Sight inShort = wireSightOf({across, none, field, 40}, hands);
  EXPECT_TRUE(inShort.isInShortAxis);
  EXPECT_FALSE(inShort.isInLongAxis);
  Transform above = across;
  above.offset = {0, -18, 60};
  const LineHands::Sight outside = wireSightOf({above, none, field, 40}, hands);
  EXPECT_FALSE(outside.isInShortAxis || outside.isInLongAxis) << "the wire is farther toward the feet";
  EXPECT_FALSE(wireSightOf({across, none, field, 10}, hands).isInShortAxis) << "deeper than the image";
}

TEST_F(LineHandsTest, AViewCountsAfterHalfASecond) {
  insertWire(100);
  const LineHands::Sight seen{true, false, {0, 0, -30}};
  const auto look = [&](double seconds) {
    for (int i = 0; i < std::lround(seconds * 30); ++i) wait(1.0 / 30, needle()), hands.look(seen);
  };
  look(0.3);
  hands.look(std::nullopt);
  look(0.4);
  EXPECT_EQ(count(WireInShortAxis), 0) << "the view was interrupted";
  look(0.3);
  EXPECT_EQ(count(WireInShortAxis), 1);
  look(2);
  EXPECT_EQ(count(WireInShortAxis), 1) << "once for each view";
  EXPECT_TRUE(hands.state().isWireSeenInShortAxis);
}

TEST_F(LineHandsTest, PressureTellsTheVessel) {
  puncture();
  EXPECT_THAT(perform(LineAct::MeasurePressure), IsEmpty());
  hands.add({.kind = Entered, .wall = kArtery, .into = kArtery, .vessel = 2, .depth_mm = 30});
  wait(0.1, needle(kArtery));
  EXPECT_THAT(perform(LineAct::MeasurePressure), IsEmpty());
  count(Performed);
  EXPECT_EQ(events[0].wall, kVein);
  EXPECT_LT(events[0].amount, 15);
  EXPECT_EQ(events[1].wall, kArtery);
  EXPECT_GT(events[1].amount, 60);
  wait(0.1, needle(kMuscle));
  EXPECT_THAT(perform(LineAct::MeasurePressure), HasSubstr("in no vessel"));
}

/// Bubbles are seen in a live image, or not at all.
TEST_F(LineHandsTest, BubblesNeedALiveImage) {
  puncture();
  hands.look(std::nullopt);
  EXPECT_THAT(perform(LineAct::FlushForBubbles), HasSubstr("no live image"));
  hands.look(LineHands::Sight{});
  EXPECT_THAT(perform(LineAct::FlushForBubbles), IsEmpty());
  EXPECT_EQ(count(BubblesSeen), 0) << "they must be in the image";
}

TEST_F(LineHandsTest, BubblesAreSeenDownstreamOfTheTip) {
  VolumeGeometry geometry;
  geometry.size = {61, 21, 61}, geometry.spacing_mm = {1, 1, 2}, geometry.origin_mm = {-20, -10, -60};
  LabelMap labels(geometry, kMuscle);
  for (int k = 0; k < geometry.size[2]; ++k)
    for (int j = 0; j < geometry.size[1]; ++j)
      for (int i = 0; i < geometry.size[0]; ++i)
        if (std::hypot(i - 20, j - 10) < 6) labels.at(i, j, k) = kVein;
  const ImageField field{.width_mm = 38, .sliceHalf_mm = 1};
  const PlaneDisplacement none;
  const Vec3 down{0, 1, 0}, left{1, 0, 0};
  const auto lookAt = [&](double z_mm, double shown_mm) {
    const Transform across{{{left, cross(down, left), down}}, {0, -18, z_mm}};
    EXPECT_THAT(perform(LineAct::FlushForBubbles), IsEmpty());
    int most = 0;
    for (int i = 0; i < 60; ++i) {
      wait(1.0 / 30, needle());
      const LineHands::Sight sight = sightOf({across, none, field, shown_mm}, hands, labels, std::nullopt, {});
      most = std::max(most, sight.bubbles);
      hands.look(sight);
    }
    return most;
  };
  puncture();
  hands.look(LineHands::Sight{});
  EXPECT_EQ(lookAt(30, 40), 0) << "toward the head";
  EXPECT_EQ(lookAt(-20, 10), 0) << "deeper than the image";
  EXPECT_EQ(count(BubblesSeen), 0);
  EXPECT_GT(lookAt(-20, 40), 9);
  EXPECT_EQ(count(BubblesSeen), 1) << "once for each flush";
  EXPECT_GT(lookAt(-20, 40), 9);
  EXPECT_EQ(count(BubblesSeen), 2);
  EXPECT_EQ(events.back().vessel, 1);
}

/// The lung has to be seen for two seconds without interruption, since the catheter is in the vein.
TEST_F(LineHandsTest, TheLungIsCheckedInTheImage) {
  const auto look = [&](double seconds, double pleura_mm, double still_mm = 0) {
    LineHands::Sight sight;
    sight.pleura_mm = pleura_mm, sight.still_mm = still_mm;
    for (int i = 0; i < std::lround(seconds * 30); ++i) {
      wait(1.0 / 30, needle(kBackground, false));
      hands.look(sight);
    }
  };
  insertWire(180);
  clearWay();
  look(3, 20);
  move(Instrument::Dilator, 30), move(Instrument::Dilator, -40);
  move(Instrument::Catheter, 150);
  EXPECT_THAT(perform(LineAct::CheckLungSliding), HasSubstr("Hold the probe over the right lung"))
      << "it was seen before the catheter was in place";
  look(1.5, 20), look(0.1, 3), look(1.5, 20);
  EXPECT_THAT(perform(LineAct::CheckLungSliding), HasSubstr("two seconds")) << "the view was interrupted";
  look(0.6, 20);
  EXPECT_THAT(perform(LineAct::CheckLungSliding), IsEmpty());
  count(Performed);
  EXPECT_EQ(events.back().amount, 0);
  look(2.5, 20, 15);
  EXPECT_THAT(perform(LineAct::CheckLungSliding), IsEmpty());
  count(Performed);
  EXPECT_EQ(events.back().amount, 1) << "most of the lung in the image does not slide";
  move(Instrument::Wire, -300), move(Instrument::Catheter, -200);
  look(0.1, 0);
  hands.add({.kind = NeedleReplaced});
  insertWire(180);
  clearWay();
  move(Instrument::Dilator, 30), move(Instrument::Dilator, -40);
  move(Instrument::Catheter, 150);
  EXPECT_THAT(perform(LineAct::CheckLungSliding), HasSubstr("has not been seen")) << "another catheter";
}

TEST_F(LineHandsTest, TheRodsAreThoseInTheImage) {
  EXPECT_THAT(hands.rods(), IsEmpty());
  insertWire(100);
  wait(0.2, needle());
  ASSERT_TRUE(hands.takeRods());
  wait(0.2, needle());
  EXPECT_FALSE(hands.takeRods()) << "nothing has moved";
  ASSERT_EQ(hands.rods().size(), 1U);
  EXPECT_EQ(hands.rods()[0].nodes_mm.front(), (Vec3{0, 0, 0})) << "the rest is in the needle";
  clearWay();
  wait(0.2, needle(kBackground, false));
  ASSERT_TRUE(hands.takeRods());
  EXPECT_LT(hands.rods()[0].nodes_mm.front().y, -10) << "from the skin on";
  move(Instrument::Dilator, 30);
  ASSERT_EQ(hands.rods().size(), 2U);
  EXPECT_EQ(hands.rods()[1].material, RodMaterial::Polymer);
  for (const FlexibleRod& rod : hands.rods()) EXPECT_TRUE(validate(rod)) << validate(rod).error().message;
}

}  // namespace
}  // namespace insonate
