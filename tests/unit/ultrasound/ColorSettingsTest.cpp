#include <insonate/ultrasound/ColorSettings.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace insonate {
namespace {

class ColorSettingsTest : public testing::Test {
 protected:
  std::string problemOf(const ColorSettings& color) const {
    const auto ok = validate(color, probe_, settings_);
    return ok ? std::string() : ok.error().message;
  }
  Probe probe_ = *loadProbe("linear");
  ImagingSettings settings_ = settingsFor(probe_);
  ColorSettings color_ = colorSettingsFor(probe_, settings_);
};

TEST_F(ColorSettingsTest, DefaultsAreValidForEveryProbe) {
  for (const std::string& name : probePresetNames()) {
    const Probe probe = *loadProbe(name);
    const ImagingSettings settings = settingsFor(probe);
    const auto ok = validate(colorSettingsFor(probe, settings), probe, settings);
    EXPECT_TRUE(ok) << name << ": " << (ok ? "" : ok.error().message);
  }
}

TEST_F(ColorSettingsTest, NyquistVelocityIsAQuarterOfTheWavelengthTimesThePrf) {
  color_.prf_Hz = 4000, color_.frequency_MHz = 5;
  EXPECT_NEAR(nyquistVelocity_mmps(color_), 308, 1e-9);
}

TEST_F(ColorSettingsTest, JsonReadsBackTheSameSettings) {
  color_.mode = ColorMode::Power, color_.invert = true, color_.packet = 7, color_.left = 0.123;
  const auto read = colorFromJson(jsonOf(color_), {});
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, color_);
}

TEST_F(ColorSettingsTest, ErrorsNameTheField) {
  EXPECT_NE(colorFromJson({{"prf", 3000}}, {}).error().message.find("prf"), std::string::npos);
  EXPECT_NE(colorFromJson({{"mode", "red"}}, {}).error().message.find("mode"), std::string::npos);
  EXPECT_NE(colorFromJson(3, {}).error().message.find("object"), std::string::npos);
  color_.far_mm = 60;
  EXPECT_NE(problemOf(color_).find("color: far_mm"), std::string::npos);
  color_ = colorSettingsFor(probe_, settings_);
  color_.right = color_.left;
  EXPECT_NE(problemOf(color_).find("right must exceed left"), std::string::npos);
  color_ = colorSettingsFor(probe_, settings_);
  color_.near_mm = color_.far_mm - 1;
  EXPECT_NE(problemOf(color_).find("far_mm must exceed near_mm"), std::string::npos);
}

TEST_F(ColorSettingsTest, ThePrfAllowsTheDeepestEchoToReturn) {
  color_.far_mm = 39, color_.prf_Hz = 19000;
  EXPECT_EQ(problemOf(color_), "");
  color_.prf_Hz = 19900;
  EXPECT_NE(problemOf(color_).find("color: prf_Hz"), std::string::npos);
  color_.prf_Hz = 1000, color_.wallFilter_Hz = 600;
  EXPECT_NE(problemOf(color_).find("color: wallFilter_Hz"), std::string::npos);
}

}  // namespace
}  // namespace insonate
