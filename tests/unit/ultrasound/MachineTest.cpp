#include <insonate/ultrasound/Machine.h>
#include <insonate/ultrasound/SetupText.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace insonate {
namespace {

using testing::HasSubstr;

TEST(Machine, AllClassesAreThere) {
  std::vector<std::string> names;
  for (const Machine& machine : machines()) {
    names.push_back(machine.name);
    EXPECT_FALSE(machine.title.empty());
    EXPECT_TRUE(machine.about.ends_with('.')) << machine.about;
  }
  EXPECT_THAT(names, testing::ElementsAre("cart-2024", "laptop-2024", "handheld-2024", "cart-2008", "laptop-2008"));
}

TEST(Machine, EachIsValidForEachProbeAndRecognized) {
  for (const auto& name : probePresetNames()) {
    const Probe probe = *loadProbe(name);
    EXPECT_EQ(machineOf(settingsFor(probe), probe), nullptr) << "the defaults are no machine's";
    for (const Machine& machine : machines()) {
      auto settings = settingsOf(machine.name, probe, settingsFor(probe));
      ASSERT_TRUE(settings) << settings.error().message;
      EXPECT_TRUE(validate(*settings, probe)) << machine.name << " with " << name;
      settings->depth_mm = probe.maxDepth_mm, settings->focus_mm = 25;
      EXPECT_EQ(machineOf(*settings, probe), &machine) << "depth and focus are the user's";
      settings->persistence += 0.1;
      EXPECT_EQ(machineOf(*settings, probe), nullptr);
    }
  }
}

TEST(Machine, DecidesWhatItNamesAndNothingElse) {
  const Probe probe = *loadProbe("linear");
  ImagingSettings base = settingsFor(probe);
  base.depth_mm = 33, base.tgc_dB[2] = 4, base.effects.layers = false;
  const auto settings = settingsOf("handheld-2024", probe, base);
  ASSERT_TRUE(settings);
  EXPECT_EQ(settings->scanlines, 128);
  EXPECT_EQ(settings->noise_dB, -38);
  EXPECT_EQ(settings->grayMap, GrayMap::Contrast);
  EXPECT_EQ(settings->frequency_MHz, 10);
  EXPECT_EQ(settings->depth_mm, 33);
  EXPECT_EQ(settings->tgc_dB[2], 4);
  EXPECT_FALSE(settings->effects.layers);
}

TEST(Machine, FrequencyIsThatOfTheProbesShapeWithinItsRange) {
  const Probe curvilinear = *loadProbe("curvilinear");
  EXPECT_EQ(settingsOf("cart-2024", curvilinear, settingsFor(curvilinear))->frequency_MHz, 4);
  Probe low = *loadProbe("linear");
  low.maxFrequency_MHz = 8;
  EXPECT_EQ(settingsOf("cart-2024", low, settingsFor(low))->frequency_MHz, 8);
}

TEST(Machine, AnUnknownNameIsRefusedWithTheKnownOnes) {
  const Probe probe = *loadProbe("linear");
  EXPECT_THAT(settingsOf("cart-1950", probe, {}).error().message,
              HasSubstr("there is no machine named 'cart-1950'; machines are cart-2024, laptop-2024"));
}

}  // namespace
}  // namespace insonate
