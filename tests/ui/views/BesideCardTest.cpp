#include "support/LabelPhantom.h"
#include "ui/support/Screen.h"

#include <insonate/ultrasound/BeamGrid.h>
#include <insonate/ultrasound/Engine.h>
#include <insonate/views/UltrasoundView.h>

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace insonate::views {
namespace {

using test::Picture;

/// The engine glsl has an OpenGL of its own; a window drawn by VTK must not feel it.
class BesideCard : public testing::Test {
 protected:
  void SetUp() override {
    if (auto engine = makeEngine("glsl"); !engine) GTEST_SKIP() << engine.error().message;
    settings_.scanlines = 64, settings_.samples = 200;
    const auto phantom = test::paint(test::gridOver({-30, -10, -15}, {30, 10, 50}, 1.5),
                                     [](Vec3 p) { return p.z < 0 ? kBackground : kMuscle; });
    scene_ =
        *AcousticScene::make(phantom.ct, phantom.labels, *loadAcousticTable("neck"), {{-60, -60, -60}, {60, 60, 60}});
    for (int i = 0; i < 256 * 128; ++i) image_.gray.push_back(static_cast<std::uint8_t>(i % 256));
  }

  EnvelopeFrame frameOf(const char* name) const {
    const auto engine = *makeEngine(name);
    EnvelopeFrame frame;
    engine->prepare(probe_, settings_);
    engine->render(*scene_, {}, frame);
    return frame;
  }
  double largestDifference(const EnvelopeFrame& frame) const {
    const EnvelopeFrame truth = frameOf("cpu");
    double most = 0;
    for (std::size_t i = 0; i < truth.amplitude.size(); ++i)
      most = std::max(most, double(std::abs(frame.amplitude[i] - truth.amplitude[i])));
    return most;
  }

  const Probe probe_ = *loadProbe("linear");
  ImagingSettings settings_ = settingsFor(probe_);
  std::shared_ptr<const AcousticScene> scene_;
  BModeImage image_{256, 128, 0.1, -12.75, 0.05, {}};
};

TEST_F(BesideCard, TheWindowIsAsItWas) {
  UltrasoundView view;
  view.setImage(image_);
  test::Screen screen(view, 600, 400);
  const Picture before = screen.picture();

  EnvelopeFrame frame;
  std::thread([&] { frame = frameOf("glsl"); }).join();
  EXPECT_LT(largestDifference(frame), 0.05);
  EXPECT_EQ(screen.picture().rgb, before.rgb) << "after frames on another thread";

  // Here the window's own context is in the way: the card's, or the processor's frame, but always a frame.
  EXPECT_LT(largestDifference(frameOf("glsl")), 0.05);
  EXPECT_EQ(screen.picture().rgb, before.rgb) << "after frames on the window's thread";
}

}  // namespace
}  // namespace insonate::views
