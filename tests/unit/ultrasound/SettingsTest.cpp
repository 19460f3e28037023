#include "support/TestData.h"

#include <insonate/ultrasound/SetupText.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <limits>

namespace insonate {
namespace {

using nlohmann::json;
using testing::HasSubstr;

std::string refusal(const json& overrides) {
  const auto settings = settingsFromJson(overrides, {});
  return settings ? "accepted" : settings.error().message;
}

TEST(Settings, DefaultsOfEveryProbeAreValid) {
  for (const auto& name : probePresetNames()) {
    const Probe probe = *loadProbe(name);
    const ImagingSettings settings = settingsFor(probe);
    EXPECT_EQ(settings.depth_mm, probe.defaultDepth_mm);
    EXPECT_EQ(settings.frequency_MHz, probe.defaultFrequency_MHz);
    const auto ok = validate(settings, probe);
    EXPECT_TRUE(ok) << ok.error().message;
  }
}

TEST(Settings, OverridesTouchOnlyWhatTheyName) {
  ImagingSettings base;
  base.focus_mm = 33;
  const auto settings = settingsFromJson(json{{"depth_mm", 55},
                                              {"looks", 1},
                                              {"speckleReduction", 0.25},
                                              {"grayMap", "linear"},
                                              {"look", "thesis"},
                                              {"tgc_dB", {1, 2, 3, 4, 5, 6, 7, 8}},
                                              {"effects", {{"layers", false}}}},
                                         base);
  ASSERT_TRUE(settings) << settings.error().message;
  EXPECT_EQ(settings->depth_mm, 55);
  EXPECT_EQ(settings->focus_mm, 33);
  EXPECT_EQ(settings->looks, 1);
  EXPECT_EQ(settings->speckleReduction, 0.25);
  EXPECT_EQ(settings->grayMap, GrayMap::Linear);
  EXPECT_EQ(settings->look, Look::Thesis);
  EXPECT_EQ(settings->tgc_dB[7], 8);
  EXPECT_FALSE(settings->effects.layers);
  EXPECT_TRUE(settings->effects.speckle);
}

TEST(Settings, UnknownFieldsAreRefusedWithTheNearestKnown) {
  EXPECT_THAT(refusal({{"dept_mm", 40}}), HasSubstr("unknown 'dept_mm'; did you mean 'depth_mm'?"));
  EXPECT_THAT(refusal({{"frequency", 5}}), HasSubstr("'frequency_MHz'"));
  EXPECT_THAT(refusal({{"effects", {{"spekle", false}}}}), HasSubstr("'speckle'"));
  EXPECT_THAT(refusal({{"qqqqqq", 1}}), HasSubstr("has an unknown 'qqqqqq'; it is one of"));
}

TEST(Settings, WrongTypesAreRefusedByName) {
  EXPECT_THAT(refusal({{"depth_mm", "deep"}}), HasSubstr("needs a number from 5 to 400 as 'depth_mm', not \"deep\"."));
  EXPECT_THAT(refusal({{"looks", 2.5}}), HasSubstr("needs a whole number as 'looks', not 2.5."));
  EXPECT_THAT(refusal({{"smoothing", 1}}), HasSubstr("needs true or false as 'smoothing', not 1."));
  EXPECT_THAT(refusal({{"speckleReduction", true}}),
              HasSubstr("needs a number from 0 to 1 as 'speckleReduction', not true."));
  EXPECT_THAT(refusal({{"grayMap", "pink"}}),
              HasSubstr("has the unknown grayMap 'pink'; it is one of linear, soft, contrast, bright, dark, flat."));
  EXPECT_THAT(refusal({{"tgc_dB", {1, 2}}}),
              HasSubstr("needs a list of 8 numbers, from the face to the depth, as 'tgc_dB'"));
  EXPECT_THAT(refusal({{"lateralGain_dB", 3}}),
              HasSubstr("needs a list of 8 numbers, from left to right, as 'lateralGain_dB', not 3."));
  EXPECT_THAT(refusal({{"effects", true}}), HasSubstr("object"));
  EXPECT_THAT(refusal(json::array()), HasSubstr("object"));
  EXPECT_THAT(refusal({{"depth_mm", nullptr}}), HasSubstr("as 'depth_mm', not null."));
}

TEST(Settings, ValuesOutOfRangeAreRefusedByName) {
  EXPECT_THAT(refusal({{"gain_dB", 41}}), HasSubstr("needs a number from -40 to 40 as 'gain_dB', not 41."));
  EXPECT_THAT(refusal({{"persistence", 1}}), HasSubstr("needs a number from 0 to 0.95 as 'persistence', not 1."));
  EXPECT_THAT(refusal({{"scanlines", 1000000}}),
              HasSubstr("needs a number from 16 to 1024 as 'scanlines', not 1000000."));
  EXPECT_THAT(refusal({{"looks", 1e30}}), HasSubstr("needs a number from 1 to 3 as 'looks', not 1e+30."));
  EXPECT_THAT(refusal({{"elevationPlanes", 4}}), HasSubstr("must be odd"));
  EXPECT_THAT(refusal({{"tgc_dB", {0, 0, 0, 21, 0, 0, 0, 0}}}),
              HasSubstr("needs numbers from -20 to 20 in the list 'tgc_dB', not 21."));
  EXPECT_THAT(refusal({{"lateralGain_dB", {0, 0, 0, 0, 0, 0, 0, -21}}}),
              HasSubstr("needs numbers from -20 to 20 in the list 'lateralGain_dB', not -21."));
  EXPECT_THAT(refusal({{"speckleReduction", 1.5}}),
              HasSubstr("needs a number from 0 to 1 as 'speckleReduction', not 1.5."));
  EXPECT_THAT(refusal({{"noise_dB", 3}}), HasSubstr("needs a number from -120 to 0 as 'noise_dB', not 3."));
  EXPECT_THAT(refusal({{"depth_mm", std::nan("")}}), HasSubstr("as 'depth_mm', not nan."));
  EXPECT_THAT(refusal({{"gain_dB", std::numeric_limits<double>::infinity()}}), HasSubstr("as 'gain_dB', not inf."));
}

TEST(Settings, FilesOfFormerVersionsAreRead) {
  EXPECT_EQ(settingsFromJson({{"smoothing", true}}, {})->speckleReduction, 1);
  EXPECT_EQ(settingsFromJson({{"smoothing", false}}, {})->speckleReduction, 0);
  EXPECT_EQ(settingsFromJson({{"greyMap", "linear"}}, {})->grayMap, GrayMap::Linear);
  EXPECT_THAT(refusal({{"smoothing", true}, {"speckleReduction", 0.5}}),
              HasSubstr("has 'smoothing', which is the former name of 'speckleReduction'; leave it out."));
}

TEST(Settings, TheProbeLimitsDepthAndFrequency) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.frequency_MHz = 2;
  EXPECT_THAT(validate(settings, probe).error().message,
              HasSubstr("settings for the linear probe: frequency_MHz is 2; allowed is 5 to 13"));
  settings = settingsFor(probe);
  settings.depth_mm = 200;
  EXPECT_THAT(validate(settings, probe).error().message, HasSubstr("depth_mm is 200; allowed is 20 to 120"));
}

TEST(Settings, FileErrorsNameTheFile) {
  const test::TemporaryFolder folder;
  const auto file = folder / "settings.json";
  EXPECT_THAT(loadSettings(file, {}).error().message, HasSubstr("cannot be read"));
  std::ofstream(file) << "{\"depth_mm\": }";
  EXPECT_THAT(loadSettings(file, {}).error().message, HasSubstr("settings.json is not valid JSON"));
  std::ofstream(file) << "{\"depth_mm\": 1e999}";
  EXPECT_FALSE(loadSettings(file, {}));
  std::ofstream(file) << "{\"depth_mm\": 1}";
  EXPECT_THAT(loadSettings(file, {}).error().message,
              HasSubstr("settings.json: The imaging setup needs a number from 5 to 400 as 'depth_mm', not 1."));
  std::ofstream(file) << "{\"depth_mm\": 50}";
  EXPECT_EQ(loadSettings(file, {})->depth_mm, 50);
}

TEST(Settings, AreReadAsTheyWereWritten) {
  ImagingSettings all;
  all.depth_mm = 55.1, all.frequency_MHz = 9, all.focus_mm = 100.0 / 3, all.gain_dB = -3, all.tgc_dB[7] = 2.5;
  all.dynamicRange_dB = 70, all.persistence = 0.3, all.grayMap = GrayMap::Flat, all.looks = 1;
  all.speckleReduction = 0.7, all.edgeEnhancement = 0.3, all.dynamicFilter = 0.8, all.noise_dB = -35.5,
  all.ringing_dB = 31;
  all.poorContactLeft_mm = 1.5, all.poorContactRight_mm = 3, all.lateralGain_dB[0] = -4;
  all.steering_deg = -5, all.compoundingAngles = 3;
  all.scanlines = 100, all.samples = 500, all.elevationPlanes = 5, all.width = 300, all.height = 200;
  all.conformingContact = false, all.harmonic = true, all.look = Look::Thesis, all.time_s = 2,
  all.effects.speckle = false;
  all.effects.clutter = false;
  const json written = jsonOf(all), plain = jsonOf(ImagingSettings{});
  EXPECT_EQ(written.size(), plain.size());
  for (const auto& [key, value] : plain.items())
    EXPECT_NE(written[key], value) << key << " tells nothing if it is as by default";
  const auto read = settingsFromJson(written, {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(jsonOf(*read), written);
  EXPECT_EQ(read->focus_mm, 100.0 / 3);
  EXPECT_FALSE(read->effects.speckle || read->effects.clutter);
  EXPECT_TRUE(read->effects.beam);
}

}  // namespace
}  // namespace insonate
