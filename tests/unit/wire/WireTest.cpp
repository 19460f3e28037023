#include <insonate/wire/Wire.h>

#include <gmock/gmock.h>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(Wires, BuiltInOnesLoad) {
  EXPECT_THAT(wirePresetNames(), testing::ElementsAre("j-tip", "straight", "dilator", "triple-lumen"));
  for (const std::string& name : wirePresetNames()) {
    const auto wire = loadWire(name);
    ASSERT_TRUE(wire) << wire.error().message;
    EXPECT_EQ(wire->name, name);
  }
}

TEST(Wires, SeldingerWireIsFloppyAtItsEndAndCurvedLikeAJ) {
  const Wire wire = loadWire("j-tip").value();
  EXPECT_EQ(wire.kind, WireKind::Guidewire);
  EXPECT_NEAR(lengthOf_mm(wire), 600, 1);
  EXPECT_NEAR(wire.diameter_mm, 0.032 * 25.4, 0.01);
  EXPECT_EQ(wire.sections.front().restRadius_mm, 3);
  EXPECT_EQ(wire.sections.back().restRadius_mm, 0);
  EXPECT_GT(wire.sections.back().bendingStiffness_Nmm2, 50 * wire.sections.front().bendingStiffness_Nmm2);
}

TEST(Wires, CatheterIsHollowAndSofterThanTheWire) {
  const Wire catheter = loadWire("triple-lumen").value();
  EXPECT_EQ(catheter.kind, WireKind::Catheter);
  EXPECT_GT(catheter.innerDiameter_mm, 1);
  EXPECT_LT(catheter.sections.back().bendingStiffness_Nmm2,
            loadWire("j-tip").value().sections.back().bendingStiffness_Nmm2);
}

TEST(Wires, FileErrorsAreSentences) {
  const auto message = [](const char* text) { return parseWire(text).error().message; };
  EXPECT_THAT(message("{"), HasSubstr("The wire"));
  EXPECT_THAT(message(R"({"name":"a","kind":"rope"})"), HasSubstr("rope"));
  EXPECT_THAT(message(R"({"name":"a","kind":"guidewire","diameter_mm":0.8})"), HasSubstr("\"source\""));
  EXPECT_THAT(message(R"({"name":"a","kind":"guidewire","diameter_mm":{"value":0.8,"source":"x"},
                          "friction":{"value":0.1,"source":"x"}})"),
              HasSubstr("no sections"));
  EXPECT_THAT(loadWire("rope").error().message, HasSubstr("rope"));
}

}  // namespace
}  // namespace insonate
