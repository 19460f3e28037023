#include "auto/AutoEngine.h"
#include "support/LabelPhantom.h"

#include <insonate/gpu/Context.h>

#include <gtest/gtest.h>

#include <array>

namespace insonate {
namespace {

TEST(AutoEngine, TakesTheFastestAndSaysWhy) {
  const std::array<EngineCandidate, 2> card{{{"cpu", "the processor", 4.06}, {"glsl", "Card X", 0.9}}};
  EXPECT_EQ(fastestOf(card).name, "glsl");
  EXPECT_EQ(fastestOf(card).why, "A frame takes 0.9 ms on Card X, 4.1 ms on the processor.");
  const std::array<EngineCandidate, 2> slow{{{"cpu", "the processor", 4}, {"glsl", "Card X", 9}}};
  EXPECT_EQ(fastestOf(slow).name, "cpu");
}

TEST(AutoEngine, IsNeverASoftwareRenderer) {
  const auto engine = *makeEngine("auto");
  EXPECT_EQ(engine->name(), "auto") << "nothing is measured before it is needed";
  const Probe probe = *loadProbe("linear");
  ImagingSettings settings = settingsFor(probe);
  settings.scanlines = 48, settings.samples = 200;
  engine->prepare(probe, settings);
  EXPECT_FALSE(engine->note().empty());
  if (!gpu::Context::make({.hardware = true})) {
    EXPECT_EQ(engine->name(), "cpu") << engine->note();
  }

  const auto phantom = test::paint(test::gridOver({-30, -10, -15}, {30, 10, 50}, 1.5),
                                   [](Vec3 p) { return p.z < 0 ? kBackground : kMuscle; });
  const auto scene =
      *AcousticScene::make(phantom.ct, phantom.labels, *loadAcousticTable("neck"), {{-60, -60, -60}, {60, 60, 60}});
  const auto chosen = *makeEngine(engine->name());
  chosen->prepare(probe, settings);
  EnvelopeFrame frame, truth;
  engine->render(*scene, {}, frame);
  chosen->render(*scene, {}, truth);
  EXPECT_EQ(frame.amplitude, truth.amplitude);
  EXPECT_EQ(engine->stages().size(), chosen->stages().size());
}

TEST(AutoEngine, UnknownNamesAreToldWhatThereIs) {
  const auto engine = makeEngine("warp");
  ASSERT_FALSE(engine);
  for (const char* name : {"auto", "reference", "cpu", "glsl", "warp"})
    EXPECT_NE(engine.error().message.find(name), std::string::npos) << engine.error().message;
}

}  // namespace
}  // namespace insonate
