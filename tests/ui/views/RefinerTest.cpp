#include "Neck.h"
#include "cast/Refiner.h"
#include "ui/support/Screen.h"

#include <insonate/views/SceneView.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <thread>

namespace insonate::views {
namespace {

using namespace std::chrono_literals;

class Refining : public testing::Test {
 protected:
  bool waitFor(const std::function<bool()>& there) {
    std::unique_lock lock(mutex);
    return heard.wait_for(lock, 60s, there);
  }
  void tell() {
    const std::lock_guard lock(mutex);
    heard.notify_all();
  }
  CastTask task(int pixels) {
    CastTask made{look, {}, pixels, pixels, false};
    const Vec3 middle = test::neck().patient->ct.geometry.center_mm();
    made.view.patientFromSeen = {90, 0, 0, middle.x, 0, 0, 90, middle.y, 0, 90, 0, middle.z, 0, 0, 0, 1};
    made.view.patientFromCamera = {Vec3{1, 0, 0}, Vec3{0, 0, 1}, Vec3{0, -1, 0}};
    made.view.width = made.view.height = pixels;
    made.view.depth.assign(std::size_t(pixels) * pixels, 1);
    return made;
  }
  void makeLook() {
    refiner.prepare(test::neck().patient);
    ASSERT_TRUE(waitFor([&] { return refiner.volume() != nullptr; }));
    look = std::make_shared<const CastLook>(refiner.volume(), transferPresets().front().function);
  }

  std::mutex mutex;
  std::condition_variable heard;
  std::shared_ptr<const CastLook> look;
  Refiner refiner{[this] { tell(); }};
};

TEST_F(Refining, MakesThePictureThatCastingAtOnceMakes) {
  makeLook();
  const CastTask wanted = task(64);
  refiner.want(0, wanted);
  ASSERT_TRUE(waitFor([&] { return refiner.picture(0) != nullptr; }));
  EXPECT_TRUE(refiner.picture(0)->task.showsAs(wanted));
  std::vector<std::uint8_t> atOnce;
  castAll(wanted, atOnce);
  EXPECT_EQ(refiner.picture(0)->rgba, atOnce);
  EXPECT_GT(std::ranges::count_if(atOnce, [](std::uint8_t value) { return value > 100; }), 1000);
  EXPECT_EQ(refiner.picture(1), nullptr) << "the other eye has its own";
}

TEST_F(Refining, WhatIsNoLongerWantedIsLeft) {
  makeLook();
  const CastTask large = task(3000), small = task(48);
  refiner.want(0, large);
  EXPECT_TRUE(refiner.makes(0, large));
  refiner.want(0, small);
  EXPECT_FALSE(refiner.makes(0, large));
  ASSERT_TRUE(waitFor([&] { return refiner.picture(0) != nullptr; }));
  EXPECT_EQ(refiner.picture(0)->task.across, 48);
  refiner.want(1, large);
  refiner.rest();
  EXPECT_FALSE(refiner.makes(1, large));
  EXPECT_EQ(refiner.picture(1), nullptr);
}

TEST(SceneVolume, AtRestAQuickPictureComesFirstAndTheExactOneByItself) {
  SceneView view;
  view.setCase(test::neck().shown);
  test::Screen screen(view, 320, 280);
  view.setCtVisible(true);
  std::mutex mutex;
  std::condition_variable heard;
  int woken = 0;
  view.setWakeListener([&] {
    const std::lock_guard lock(mutex);
    ++woken;
    heard.notify_all();
  });
  const auto wait = [&](int times) {
    std::unique_lock lock(mutex);
    return heard.wait_for(lock, 60s, [&] { return woken >= times; });
  };
  view.render();
  EXPECT_FALSE(view.isExact()) << "the CT is being made ready";
  ASSERT_TRUE(wait(1));
  const test::Picture quick = screen.picture();
  EXPECT_FALSE(view.isExact());
  const auto begin = std::chrono::steady_clock::now();
  ASSERT_TRUE(wait(2));
  const auto took = std::chrono::steady_clock::now() - begin;
  const test::Picture exact = screen.picture();
  EXPECT_TRUE(view.isExact());
  EXPECT_NE(quick.rgb, exact.rgb);
  EXPECT_EQ(screen.picture().rgb, exact.rgb) << "and it stays";
  EXPECT_EQ(woken, 2) << "nothing is cast again";
  double difference = 0;
  for (std::size_t k = 0; k < exact.rgb.size(); ++k) difference += std::abs(int(exact.rgb[k]) - int(quick.rgb[k]));
  EXPECT_LT(difference / double(exact.rgb.size()), 12) << "the quick one shows the same";
  view.orbit(10, 0);
  view.setMoving(true);
  view.render();
  EXPECT_FALSE(view.isExact());
  std::this_thread::sleep_for(2 * took + 200ms);
  EXPECT_EQ(woken, 2) << "while it moves nothing is refined";
  view.setMoving(false);
  EXPECT_TRUE(view.renderExactly());
  EXPECT_TRUE(view.isExact());
  view.setWakeListener({});
}

TEST(SceneVolume, EachEyeHasItsExactPicture) {
  SceneView view;
  view.setCase(test::neck().shown);
  test::Screen screen(view, 160, 140);
  view.setCtVisible(true);
  view.setStereo(Stereo::Anaglyph);
  EXPECT_TRUE(view.renderExactly());
}

}  // namespace
}  // namespace insonate::views
