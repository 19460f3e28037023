#include <insonate/simulator/AttemptSettings.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace insonate {
namespace {

using nlohmann::json;
using testing::HasSubstr;

AttemptSettings settings() {
  AttemptSettings all;
  all.setup.probe = *loadProbe("curvilinear");
  all.setup.settings = settingsFor(all.setup.probe);
  all.setup.tissues = *loadAcousticTable("thesis");
  all.setup.engine = "cpu";
  all.setup.mechanics.tissues = *loadMechanicalTable("thesis");
  all.setup.mechanics.sticking = true, all.setup.mechanics.settings.maxIterations = 7;
  all.setup.mechanics.settings.mesh_mm = 0.7;
  all.physiology.tilt_deg = 15, all.physiology.centralVenous_mmHg = 1.0 / 3;
  all.pulsating = true, all.bloodTime_s = 12.5, all.needle = "measured", all.needleLength_mm = 60;
  return all;
}

TEST(AttemptSettings, AreReadAsTheyWereWritten) {
  const AttemptSettings all = settings();
  const auto read = parseAttemptSettings(textOf(all));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(textOf(*read), textOf(all));
  EXPECT_EQ(read->setup.mechanics, all.setup.mechanics);
  EXPECT_EQ(read->setup.tissues.tissues, all.setup.tissues.tissues);
  EXPECT_EQ(read->setup.probe.shape, ProbeShape::Curvilinear);
  EXPECT_EQ(read->physiology.centralVenous_mmHg, 1.0 / 3);
  EXPECT_EQ(read->blood(2).vein_kPa, bloodPressureAt(all.physiology, 14.5).vein_kPa);
}

/// Images of former recordings are the same as before the lung slid.
TEST(AttemptSettings, TheLungSlidesOnlyInRecordingsThatSaySo) {
  AttemptSettings all = settings();
  all.physiology.lungSlide_mm = 4;
  const auto read = parseAttemptSettings(textOf(all));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->physiology.lungSlide_mm, 4);
  EXPECT_EQ(read->lung(2).slide_mm, lungSlideAt_mm(all.physiology, 14.5));
  json former = json::parse(textOf(all));
  former["physiology"].erase("lungSlide_mm");
  EXPECT_EQ(parseAttemptSettings(former.dump())->physiology.lungSlide_mm, 0);
  all.pulsating = false;
  EXPECT_EQ(all.lung(2).slide_mm, 0);
}

TEST(AttemptSettings, AFlushIsReadAsItWasWritten) {
  AttemptSettings all = settings();
  EXPECT_FALSE(parseAttemptSettings(textOf(all))->flush);
  all.flush = SalineFlush{1.0 / 3, kArtery, {0.1, -20.7, 1.0 / 7}};
  const auto read = parseAttemptSettings(textOf(all));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->flush, all.flush);
  json text = json::parse(textOf(all));
  text["flush"]["from_mm"][1] = 1e9;
  EXPECT_THAT(parseAttemptSettings(text.dump()).error().message, HasSubstr("a place within 10 m"));
}

TEST(AttemptSettings, APneumothoraxIsReadAsItWasWritten) {
  AttemptSettings all = settings();
  EXPECT_EQ(parseAttemptSettings(textOf(all))->pneumothorax, insonate::Pneumothorax{});
  all.pneumothorax.since_s[1] = 1.0 / 3;
  const auto read = parseAttemptSettings(textOf(all));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->pneumothorax, all.pneumothorax);
  EXPECT_EQ(read->lung(1.0 / 3 + 10).detached_mm[1], all.pneumothorax.detachedAt_mm(1.0 / 3 + 10)[1]);
}

TEST(AttemptSettings, ColorIsReadAsItWasWritten) {
  AttemptSettings all = settings();
  EXPECT_FALSE(parseAttemptSettings(textOf(all))->setup.color);
  all.setup.color = colorSettingsFor(all.setup.probe, all.setup.settings);
  all.setup.color->invert = true, all.setup.color->gain_dB = 1.0 / 3;
  const auto read = parseAttemptSettings(textOf(all));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->setup.color, all.setup.color);
}

/// Recordings of before there were electronic noise, ringing and gray maps by name.
TEST(AttemptSettings, FormerRecordingsShowWhatTheyShowed) {
  json text = json::parse(textOf(settings()));
  json& picture = text["picture"];
  for (const char* later : {"speckleReduction", "edgeEnhancement", "dynamicFilter", "noise_dB", "ringing_dB",
                            "poorContactLeft_mm", "poorContactRight_mm", "lateralGain_dB", "grayMap"})
    ASSERT_EQ(picture.erase(later), 1) << later;
  for (const char* later : {"noise", "nearField"}) ASSERT_EQ(picture["effects"].erase(later), 1) << later;
  picture["smoothing"] = true, picture["greyMap"] = "soft";
  const auto read = parseAttemptSettings(text.dump());
  ASSERT_TRUE(read) << read.error().message;
  const ImagingSettings& former = read->setup.settings;
  EXPECT_EQ(former.speckleReduction, 1);
  EXPECT_EQ(former.edgeEnhancement, 0);
  EXPECT_EQ(former.dynamicFilter, 0);
  EXPECT_EQ(former.grayMap, GrayMap::Soft);
  EXPECT_FALSE(former.effects.noise || former.effects.nearField);
  EXPECT_TRUE(former.effects.clutter);
}

TEST(AttemptSettings, BloodIsAtItsMeanWhereNothingPulses) {
  AttemptSettings all;
  EXPECT_EQ(all.blood(3).vein_kPa, all.setup.mechanics.tissues.of(kVein).pressure_kPa);
}

TEST(AttemptSettings, OtherTextsAreRefusedWithASentence) {
  json text = json::parse(textOf(settings()));
  const auto refusal = [](const std::string& of) { return parseAttemptSettings(of).error().message; };
  EXPECT_THAT(refusal(""), HasSubstr("The settings of the attempt cannot be read"));
  EXPECT_THAT(refusal("{}"), HasSubstr("cannot be read: key 'probe' not found"));
  text["physiology"]["tilt_deg"] = 80;
  EXPECT_THAT(refusal(text.dump()), HasSubstr("tilt_deg is 80; allowed is -45 to 45"));
  text["picture"]["gain_dB"] = "high";
  EXPECT_THAT(refusal(text.dump()), HasSubstr("needs a number from -40 to 40 as 'gain_dB', not \"high\"."));
}

}  // namespace
}  // namespace insonate
