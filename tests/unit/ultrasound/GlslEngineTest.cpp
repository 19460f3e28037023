#include "glsl/Device.h"
#include "support/LabelPhantom.h"

#include <insonate/ultrasound/Engine.h>

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace insonate {
namespace {

using test::gridOver;
using test::paint;

class GlslEngine : public testing::Test {
 protected:
  void SetUp() override {
    if (auto engine = makeEngine("glsl"); !engine) GTEST_SKIP() << engine.error().message;
    settings_.scanlines = 64, settings_.samples = 200;
  }

  static std::shared_ptr<const AcousticScene> sceneOf(Label tissue, double depth_mm = 12) {
    const auto phantom = paint(gridOver({-30, -10, -15}, {30, 10, 50}, 1.5), [=](Vec3 p) {
      return p.z < 0 ? kBackground : p.z < depth_mm ? kMuscle : tissue;
    });
    return *AcousticScene::make(phantom.ct, phantom.labels, *loadAcousticTable("neck"),
                                {{-60, -60, -60}, {60, 60, 60}});
  }
  EnvelopeFrame frameOf(Engine& engine, const AcousticScene& scene) const {
    EnvelopeFrame frame;
    engine.render(scene, {}, frame);
    return frame;
  }
  EnvelopeFrame freshFrame(const AcousticScene& scene, const char* name = "glsl") const {
    const auto engine = *makeEngine(name);
    engine->prepare(probe_, settings_);
    return frameOf(*engine, scene);
  }

  const Probe probe_ = *loadProbe("linear");
  ImagingSettings settings_ = settingsFor(probe_);
};

TEST_F(GlslEngine, TellsItsDevice) {
  const auto engine = *makeEngine("glsl");
  EXPECT_EQ(engine->name(), "glsl");
  const auto& device = (*glsl::Device::shared())->context().device();
  EXPECT_NE(engine->note().find(device.renderer), std::string::npos);
  EXPECT_EQ(engine->note().find("software") != std::string::npos, device.software);
}

TEST_F(GlslEngine, TimesOfItsStagesSumUpToTheFrame) {
  const auto scene = sceneOf(kVein);
  for (const Look look : {Look::Coherent, Look::Thesis}) {
    settings_.look = look;
    const auto engine = *makeEngine("glsl");
    engine->prepare(probe_, settings_);
    frameOf(*engine, *scene);
    const auto start = std::chrono::steady_clock::now();
    frameOf(*engine, *scene);
    const std::chrono::duration<double, std::milli> frame = std::chrono::steady_clock::now() - start;
    double sum_ms = 0;
    for (const Engine::Stage& stage : engine->stages()) {
      EXPECT_GE(stage.ms, 0) << stage.name;
      sum_ms += stage.ms;
    }
    EXPECT_EQ(engine->stages().front().name, "upload");
    EXPECT_EQ(engine->stages().back().name, "read-back");
    EXPECT_GT(sum_ms, 0);
    EXPECT_LE(sum_ms, frame.count());
  }
}

TEST_F(GlslEngine, SameInputsSameFrame) {
  const auto scene = sceneOf(kBone);
  const auto engine = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  const EnvelopeFrame first = frameOf(*engine, *scene), second = frameOf(*engine, *scene);
  EXPECT_EQ(first.amplitude, second.amplitude);
  EXPECT_EQ(first.amplitude, freshFrame(*scene).amplitude);
}

/// A scene's data stay on the card for as long as the scene is the same; an address alone does not say so.
TEST_F(GlslEngine, ANewSceneAtTheSameAddressIsSeen) {
  const auto engine = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  auto scene = sceneOf(kBone);
  for (int i = 0; i < 4; ++i) {
    scene.reset();
    scene = sceneOf(i % 2 ? kBone : kAirway, 10 + i);
    EXPECT_EQ(frameOf(*engine, *scene).amplitude, freshFrame(*scene).amplitude) << i;
  }
}

TEST_F(GlslEngine, ASceneIsUploadedOnceForAllEnginesAndSettings) {
  const auto first = sceneOf(kBone), second = sceneOf(kAirway);
  const auto one = *makeEngine("glsl"), other = *makeEngine("glsl");
  one->prepare(probe_, settings_);
  const auto& scenes = (*glsl::Device::shared())->scenes();
  const int before = scenes.uploads();
  const EnvelopeFrame truth = frameOf(*one, *first);
  for (int i = 0; i < 3; ++i) {
    settings_.gain_dB += 1;
    one->prepare(probe_, settings_), other->prepare(probe_, settings_);
    frameOf(*one, *first), frameOf(*other, *second), frameOf(*one, *second), frameOf(*one, *first);
  }
  EXPECT_EQ(scenes.uploads() - before, 2);
  for (int i = 0; i < 3; ++i) frameOf(*other, *sceneOf(kBone, 10 + i));  // as many as are kept
  EXPECT_EQ(frameOf(*one, *first).amplitude, truth.amplitude) << "and comes back once forgotten";
  EXPECT_EQ(scenes.uploads() - before, 6);
}

TEST_F(GlslEngine, OtherSettingsAreTakenOver) {
  const auto scene = sceneOf(kBone);
  const auto engine = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  frameOf(*engine, *scene);
  settings_.scanlines = 100, settings_.samples = 333, settings_.looks = 2, settings_.look = Look::Thesis;
  engine->prepare(probe_, settings_);
  const EnvelopeFrame frame = frameOf(*engine, *scene);
  EXPECT_EQ(frame.looks, 1) << "the look of the thesis";
  EXPECT_EQ(frame.amplitude, freshFrame(*scene).amplitude);
}

TEST_F(GlslEngine, WorksOnAnyThreadBesideOthers) {
  const auto scene = sceneOf(kBone);
  const EnvelopeFrame truth = freshFrame(*scene);
  const auto moved = *makeEngine("glsl");
  moved->prepare(probe_, settings_);
  std::vector<std::thread> threads;
  std::vector<EnvelopeFrame> frames(3);
  threads.emplace_back([&] { frames[0] = frameOf(*moved, *scene); });
  threads.emplace_back([&] { frames[1] = freshFrame(*scene); });
  threads.emplace_back([&] { frames[2] = freshFrame(*scene); });
  for (std::thread& thread : threads) thread.join();
  for (const EnvelopeFrame& frame : frames) EXPECT_EQ(frame.amplitude, truth.amplitude);
}

TEST_F(GlslEngine, ALostCardIsReplacedByTheProcessor) {
  const auto scene = sceneOf(kBone);
  const auto engine = *makeEngine("glsl"), prepared = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  frameOf(*engine, *scene);
  (*glsl::Device::shared())->context().simulateLoss();

  EXPECT_EQ(frameOf(*engine, *scene).amplitude, freshFrame(*scene, "cpu").amplitude);
  EXPECT_EQ(engine->name(), "cpu");
  EXPECT_NE(engine->note().find("reset"), std::string::npos) << engine->note();
  EXPECT_FALSE(engine->stages().empty());
  settings_.scanlines = 80;
  engine->prepare(probe_, settings_);
  EXPECT_EQ(frameOf(*engine, *scene).scanlines, 80) << "goes on with other settings";

  prepared->prepare(probe_, settings_);
  EXPECT_EQ(prepared->name(), "cpu") << "lost before it was prepared";
  const auto anew = makeEngine("glsl");
  ASSERT_TRUE(anew) << anew.error().message;
  (*anew)->prepare(probe_, settings_);
  frameOf(**anew, *scene);
  EXPECT_EQ((*anew)->name(), "glsl") << "a new one works";
}

TEST_F(GlslEngine, WhatDoesNotFitIsComputedByTheProcessor) {
  settings_.scanlines = 1024, settings_.samples = 4096, settings_.elevationPlanes = 9, settings_.looks = 1;
  const auto engine = *makeEngine("glsl");
  engine->prepare(probe_, settings_);
  if (engine->name() == "glsl") GTEST_SKIP() << "this card shows a shader all of it: " << engine->note();
  EXPECT_NE(engine->note().find("MB"), std::string::npos) << engine->note();
}

}  // namespace
}  // namespace insonate
