#include <insonate/procedure/LineState.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace insonate {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using enum AttemptEventKind;

void perform(LineState& state, LineAct act, double amount = 0) {
  ASSERT_THAT(refusalOf(state, act, static_cast<int>(amount)), IsEmpty()) << nameOf(act);
  follow(state, AttemptEvent{.kind = Performed, .act = act, .amount = amount}, true);
}

LineState needleInVein() {
  LineState state;
  follow(state, AttemptSample{.needleDepth_mm = 25});
  return state;
}

LineState wireInVein() {
  LineState state = needleInVein();
  perform(state, LineAct::DetachSyringe);
  follow(state, AttemptEvent{.kind = InstrumentEntered, .into = kVein, .vessel = 1, .instrument = Instrument::Wire},
         true);
  follow(state, AttemptSample{.needleDepth_mm = 25, .wire_mm = 150});
  return state;
}

TEST(LineState, EachActHasItsOwnName) {
  std::set<std::string_view> names;
  for (int act = 0; act < kLineActs; ++act) names.insert(nameOf(static_cast<LineAct>(act)));
  EXPECT_EQ(names.size(), std::size_t{kLineActs});
}

TEST(LineState, TheHubIsOpenUntilSomethingClosesIt) {
  LineState state = needleInVein();
  EXPECT_FALSE(state.isHubOpen());
  EXPECT_THAT(refusalOf(state, LineAct::CoverHub), HasSubstr("syringe"));
  perform(state, LineAct::DetachSyringe);
  EXPECT_TRUE(state.isHubOpen());
  perform(state, LineAct::CoverHub);
  EXPECT_FALSE(state.isHubOpen());
  perform(state, LineAct::UncoverHub);
  perform(state, LineAct::AttachSyringe);
  EXPECT_FALSE(state.isHubOpen());
  perform(state, LineAct::DetachSyringe);
  follow(state, AttemptSample{.needleDepth_mm = 25, .wire_mm = 30});
  EXPECT_FALSE(state.isHubOpen()) << "the wire fills the needle";
  EXPECT_THAT(refusalOf(state, LineAct::AttachSyringe), HasSubstr("wire"));
}

TEST(LineState, InstrumentsFollowOneAnotherOverTheWire) {
  LineState state;
  EXPECT_THAT(refusalOf(state, Instrument::Wire, true), HasSubstr("Insert the needle first"));
  state = needleInVein();
  EXPECT_THAT(refusalOf(state, Instrument::Wire, true), HasSubstr("syringe"));
  EXPECT_THAT(refusalOf(state, Instrument::Dilator, true), HasSubstr("no wire"));
  state = wireInVein();
  EXPECT_THAT(refusalOf(state, Instrument::Wire, true), IsEmpty());
  EXPECT_THAT(refusalOf(state, Instrument::Catheter, true), HasSubstr("needle"));
  EXPECT_THAT(refusalOf(state, LineAct::NickSkin), HasSubstr("needle"));
  follow(state, AttemptSample{.wire_mm = 150});
  EXPECT_THAT(refusalOf(state, Instrument::Dilator, true), IsEmpty());
  follow(state, AttemptSample{.wire_mm = 150, .dilator_mm = 20});
  EXPECT_THAT(refusalOf(state, Instrument::Catheter, true), HasSubstr("dilator"));
  EXPECT_THAT(refusalOf(state, Instrument::Dilator, false), IsEmpty());
  follow(state, AttemptSample{.wire_mm = 150, .catheter_mm = 150});
  EXPECT_THAT(refusalOf(state, Instrument::Dilator, true), HasSubstr("catheter"));
}

/// The wire runs through the distal lumen.
TEST(LineState, AWireThatMetAResistanceIsWithdrawnBeforeItGoesOn) {
  LineState state = wireInVein();
  const AttemptEvent stopped{.kind = InstrumentStopped, .depth_mm = 150, .instrument = Instrument::Wire};
  follow(state, stopped, true);
  EXPECT_EQ(state.wireStop_mm, 150);
  follow(state, AttemptSample{.needleDepth_mm = 25, .wire_mm = 145});
  EXPECT_EQ(state.wireStop_mm, 150) << "not yet free";
  follow(state, AttemptSample{.needleDepth_mm = 25, .wire_mm = 139});
  EXPECT_EQ(state.wireStop_mm, 0);
  follow(state, stopped, true);
  follow(state, AttemptSample{.needleDepth_mm = 25, .wire_mm = 160});
  EXPECT_EQ(state.wireStop_mm, 0) << "it went on";
  follow(state, stopped, true);
  follow(state, AttemptEvent{.kind = InstrumentRemoved, .instrument = Instrument::Wire}, true);
  EXPECT_EQ(state.wireStop_mm, 0);
}

TEST(LineState, LumensAreReachedWithoutTheWire) {
  LineState state = wireInVein();
  EXPECT_THAT(refusalOf(state, LineAct::FlushLumen, 2), HasSubstr("not in the body"));
  follow(state, AttemptSample{.wire_mm = 150, .catheter_mm = 150});
  EXPECT_THAT(refusalOf(state, LineAct::AspirateLumen, 2), HasSubstr("No blood comes")) << "it is in no vessel yet";
  follow(state, AttemptEvent{.kind = InstrumentEntered, .into = kVein, .instrument = Instrument::Catheter}, true);
  EXPECT_THAT(refusalOf(state, LineAct::AspirateLumen, 1), HasSubstr("wire"));
  EXPECT_THAT(refusalOf(state, LineAct::AspirateLumen, 2), IsEmpty());
  EXPECT_THAT(refusalOf(state, LineAct::AspirateLumen, 4), HasSubstr("1 to 3"));
  follow(state, AttemptEvent{.kind = InstrumentRemoved, .instrument = Instrument::Wire}, true);
  follow(state, AttemptSample{.catheter_mm = 150});
  perform(state, LineAct::AspirateLumen, 1);
  perform(state, LineAct::FlushLumen, 1);
  EXPECT_TRUE(state.isFlushed[0]);
  EXPECT_FALSE(state.isFlushed[1]);
  EXPECT_THAT(refusalOf(state, LineAct::FlushLumen, 1), HasSubstr("already flushed"));
}

/// The first wire is in the vein, and a second needle is in the body with its syringe off.
TEST(LineState, AnotherNeedleHasNoWireInItsHub) {
  LineState state = wireInVein();
  EXPECT_TRUE(state.isWireInNeedle);
  follow(state, AttemptSample{.wire_mm = 150});
  follow(state, AttemptSample{.needleDepth_mm = 20, .wire_mm = 150});
  EXPECT_FALSE(state.isWireInNeedle);
  EXPECT_TRUE(state.isHubOpen());
  EXPECT_THAT(refusalOf(state, LineAct::CoverHub), IsEmpty());
}

TEST(LineState, ALostWireCannotBeReached) {
  LineState state = wireInVein();
  follow(state, AttemptEvent{.kind = WireLost, .instrument = Instrument::Wire}, true);
  EXPECT_THAT(refusalOf(state, LineAct::HoldWire), HasSubstr("cannot be reached"));
  EXPECT_THAT(refusalOf(state, Instrument::Wire, false), HasSubstr("cannot be reached"));
}

TEST(LineState, ANewPunctureNeedsItsOwnNick) {
  LineState state = wireInVein();
  follow(state, AttemptSample{.wire_mm = 150});
  perform(state, LineAct::NickSkin);
  EXPECT_THAT(refusalOf(state, LineAct::NickSkin), HasSubstr("already"));
  follow(state, AttemptEvent{.kind = InstrumentRemoved, .instrument = Instrument::Wire}, true);
  follow(state, AttemptSample{});
  follow(state, AttemptEvent{.kind = Entered, .wall = kSkin}, true);
  EXPECT_FALSE(state.isNicked);
}

}  // namespace
}  // namespace insonate
