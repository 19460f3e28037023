#include "glsl/Device.h"
#include "support/LabelPhantom.h"

#include <insonate/ultrasound/ColorDoppler.h>
#include <insonate/ultrasound/Engine.h>

#include <gtest/gtest.h>

namespace insonate {
namespace {

class GlslColor : public testing::Test {
 protected:
  void SetUp() override {
    if (auto engine = makeEngine("glsl"); !engine) GTEST_SKIP() << engine.error().message;
    settings_.scanlines = 64, settings_.samples = 200;
    const auto phantom = test::paint(test::gridOver({-30, -10, -5}, {30, 10, 50}, 1.5),
                                     [](Vec3 p) { return std::abs(p.z - 20) < 5 ? kVein : kMuscle; });
    scene_ =
        *AcousticScene::make(phantom.ct, phantom.labels, *loadAcousticTable("neck"), {{-60, -60, -60}, {60, 60, 60}});
    color_ = colorSettingsFor(probe_, settings_);
  }

  ColorFrame frameOf(ColorDoppler& doppler, const ColorSettings& color) const {
    ColorFrame frame;
    doppler.prepare(probe_, settings_, color);
    doppler.render(*scene_, {}, {}, {.tissue_mmps = {0, 0, -30}}, frame);
    return frame;
  }

  const Probe probe_ = *loadProbe("linear");
  ImagingSettings settings_ = settingsFor(probe_);
  ColorSettings color_;
  std::shared_ptr<const AcousticScene> scene_;
};

TEST_F(GlslColor, UsesTheSceneThatTheEngineHasUploaded) {
  const auto engine = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  EnvelopeFrame before, after;
  engine->render(*scene_, {}, before);
  const int uploads = (*glsl::Device::shared())->scenes().uploads();
  const auto doppler = *makeColorDoppler("glsl");
  EXPECT_GT(frameOf(*doppler, color_).power[0], 0);
  EXPECT_EQ(doppler->name(), "glsl");
  EXPECT_EQ((*glsl::Device::shared())->scenes().uploads(), uploads);
  engine->render(*scene_, {}, after);
  EXPECT_EQ(before.amplitude, after.amplitude) << "color changes no envelope";
}

TEST_F(GlslColor, SameInputsSameFrame) {
  const auto doppler = *makeColorDoppler("glsl");
  const ColorFrame first = frameOf(*doppler, color_);
  ColorSettings other = color_;
  other.left = 0.4, other.far_mm -= 5;
  EXPECT_NE(frameOf(*doppler, other).power.size(), first.power.size());
  const ColorFrame again = frameOf(*doppler, color_);
  EXPECT_EQ(again.power, first.power);
  EXPECT_EQ(again.lagOneIm, first.lagOneIm);
}

TEST_F(GlslColor, ALostCardIsReplacedByTheProcessor) {
  const auto doppler = *makeColorDoppler("glsl"), processor = *makeColorDoppler("cpu");
  frameOf(*doppler, color_);
  (*glsl::Device::shared())->context().simulateLoss();
  ColorFrame frame;
  doppler->render(*scene_, {}, {}, {.tissue_mmps = {0, 0, -30}}, frame);
  EXPECT_EQ(doppler->name(), "cpu");
  EXPECT_EQ(frame.power, frameOf(*processor, color_).power);
  EXPECT_EQ(frameOf(*doppler, color_).power, frame.power) << "goes on with new settings";
  EXPECT_EQ((*makeColorDoppler("glsl"))->name(), "glsl") << "a new one works";
}

TEST_F(GlslColor, AutoTakesTheEngineThatAutoHasChosen) {
  const auto engine = *makeEngine("auto");
  engine->prepare(probe_, settings_);
  EXPECT_EQ((*makeColorDoppler("auto"))->name(), engine->name());
}

}  // namespace
}  // namespace insonate
