#include "BlurProfile.h"
#include "HandScene.h"
#include "PatternAlignment.h"

#include <insonate/camera/HandFilter.h>
#include <insonate/camera/HandTracker.h>

#include <gmock/gmock.h>
#include <malloc.h>

#include <random>

namespace insonate::test {
namespace {

const Transform kMiddle{turned({1, 0.3, -0.2}, 75), {20, -10, 500}};

SimulatedSensor smallSensor() {
  SimulatedSensor sensor;
  sensor.lens = scaledLens(laptopLens(), 960, 540);
  return sensor;
}

CameraFrame at(CameraFrame frame, std::int64_t number) {
  frame.time_ns = 1 + number * 33'333'333;
  return frame;
}

TEST(BlurProfile, DerivativesAreThoseOfDifferences) {
  for (const double box : {0.0, 0.2, 1.5, 4.0})
    for (double d = -2; d <= 2; d += 0.37) {
      constexpr double kStep = 0.02;
      const camera::BlurProfile profile(0.6, box), wider(0.6 + kStep, box), narrower(0.6 - kStep, box);
      const auto edge = profile.at(d);
      EXPECT_NEAR(edge.density, (profile.at(d + kStep).share - profile.at(d - kStep).share) / (2 * kStep), 0.01);
      EXPECT_NEAR(edge.byWidth, (wider.at(d).share - narrower.at(d).share) / (2 * kStep), 0.02);
    }
}

TEST(PatternAlignment, FindsThePoseFromAStartThatIsAPixelOff) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 11);
  const TagBody body = bodyNamed("needle");
  const CameraFrame frame = camera.render({atRest(body, kMiddle)}, 0);
  camera::PatternAlignment alignment(sensor.lens);
  for (const double side : {-1.0, 1.0}) {
    camera::AlignmentStart start{
        camera::movedBy(kMiddle, {{0.6 * side, -0.5, 3 * side, 0.01, -0.01 * side, 0.01}}), {}, 0.9};
    const auto pose = alignment.align(frame.view(), body, start);
    ASSERT_TRUE(pose);
    EXPECT_LT(norm(tipOf(body, pose->cameraFromBody) - tipOf(body, kMiddle)), 0.2);
    EXPECT_NEAR(pose->blur_px, std::hypot(sensor.blur_px, std::sqrt(1.0 / 12)), 0.1);
    EXPECT_GE(pose->tags, 3);
  }
}

TEST(PatternAlignment, RefusesAnImageWithoutTheBody) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 12);
  camera::PatternAlignment alignment(sensor.lens);
  EXPECT_FALSE(alignment.align(camera.render({}, 0).view(), bodyNamed("needle"), {kMiddle, {}, 0.7}));
}

TEST(HandFilter, FollowsAConstantVelocityWithoutDelayAndSmoothsAtRest) {
  HandFilter filter;
  std::array<double, 36> covariance{};
  for (std::size_t i = 0; i < 6; ++i) covariance[7 * i] = i < 3 ? 0.04 : 1e-6;
  std::mt19937 random(3);
  std::normal_distribution<double> normal(0, 0.2);
  const Vec3 velocity{80, -30, 20};
  Vec3 position{0, 0, 500};
  filter.reset({{}, position}, 0);
  double moving = 0, resting = 0;
  for (int i = 1; i <= 60; ++i) {
    position = position + velocity / 30;
    filter.update({{}, position + Vec3{normal(random), normal(random), normal(random)}}, covariance, i * 33'333'333LL);
    if (i > 30) moving += dot(filter.cameraFromBody().offset - position, velocity) / norm(velocity) / 30;
  }
  EXPECT_NEAR(moving / norm(velocity), 0, 1e-3) << "delay in s";
  EXPECT_LT(norm(filter.predictedAt(filter.time_ns() + 30'000'000).offset - (position + velocity * 0.03)), 1);
  for (int i = 61; i <= 180; ++i) {
    filter.update({{}, position + Vec3{normal(random), normal(random), normal(random)}}, covariance, i * 33'333'333LL);
    if (i > 120) resting += std::pow(filter.cameraFromBody().offset.x - position.x, 2) / 60;
  }
  EXPECT_LT(std::sqrt(resting), 0.17);
}

TEST(HandTracker, FollowsAMotionWithinTheAims) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 21);
  const TagBody body = bodyNamed("needle");
  const SimulatedMotion motion(kMiddle, 10, 8, 0.6, 22);
  const SimulatedObject object{body, [&](double t) { return motion.at(t); }, {}};
  HandTracker tracker(sensor.lens, {body});
  double tip = 0, direction = 0;
  constexpr int kFrames = 20;
  for (int i = 0; i < kFrames; ++i) {
    const TrackedHand& state = tracker.process(at(camera.render({object}, i / 30.0), i)).front();
    ASSERT_EQ(state.sight, HandSight::kTracked);
    EXPECT_TRUE(state.isAligned);
    const Transform truth = motion.at(i / 30.0);
    tip += std::pow(norm(tipOf(body, state.cameraFromBody) - tipOf(body, truth)), 2) / kFrames;
    direction += std::pow(angleBetween_deg(state.cameraFromBody.linear.column[2], truth.linear.column[2]), 2) / kFrames;
  }
  EXPECT_LT(std::sqrt(tip), 0.4);
  EXPECT_LT(std::sqrt(direction), 0.15);
}

TEST(HandTracker, FingersOnThreeFacesDoNotMoveTheBody) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 31);
  const TagBody body = bodyNamed("needle");
  SimulatedObject object = atRest(body, kMiddle);
  for (const int tag : {2, 4, 6})
    object.fingers.push_back({normalized(body.tags[std::size_t(tag)].bodyFromTag.offset) * 27, 8});
  HandTracker tracker(sensor.lens, {body});
  TrackedHand state;
  for (int i = 0; i < 4; ++i) state = tracker.process(at(camera.render({object}, 0), i)).front();
  ASSERT_EQ(state.sight, HandSight::kTracked);
  EXPECT_LT(norm(tipOf(body, state.cameraFromBody) - tipOf(body, kMiddle)), 0.5);
}

TEST(HandTracker, AHiddenBodyStaysWhereItWasAndIsFoundAgainElsewhere) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 41);
  const TagBody body = bodyNamed("needle");
  HandTracker tracker(sensor.lens, {body});
  EXPECT_EQ(tracker.states().front().sight, HandSight::kNeverSeen);
  std::int64_t number = 0;
  const CameraFrame seen = camera.render({atRest(body, kMiddle)}, 0), empty = camera.render({}, 0);
  for (int i = 0; i < 3; ++i) tracker.process(at(seen, number++));
  const TrackedHand last = tracker.states().front();
  ASSERT_EQ(last.sight, HandSight::kTracked);
  for (int i = 0; i < 8; ++i) {
    const TrackedHand& hidden = tracker.process(at(empty, number++)).front();
    EXPECT_EQ(hidden.sight, HandSight::kHidden);
    EXPECT_EQ(hidden.advice, HandAdvice::kNotSeen);
    EXPECT_EQ(hidden.cameraFromBody, last.cameraFromBody);
    EXPECT_EQ(hidden.time_ns, last.time_ns);
    EXPECT_EQ(predictedPose(hidden, hidden.time_ns + 400'000'000), last.cameraFromBody);
  }
  const Transform elsewhere{turned({1, -0.5, 0}, 100), {-120, 50, 430}};
  const CameraFrame again = camera.render({atRest(body, elsewhere)}, 0);
  TrackedHand found;
  for (int i = 0; i < 3; ++i) found = tracker.process(at(again, number++)).front();
  ASSERT_EQ(found.sight, HandSight::kTracked);
  EXPECT_LT(norm(tipOf(body, found.cameraFromBody) - tipOf(body, elsewhere)), 0.6);
}

TEST(HandTracker, GivesAdviceOnLightFocusAndDistance) {
  const TagBody body = bodyNamed("needle");
  const auto advice = [&](const SimulatedSensor& sensor, const Transform& pose) {
    SimulatedCamera camera(sensor, 51);
    const CameraFrame frame = camera.render({atRest(body, pose)}, 0);
    HandTracker tracker(sensor.lens, {body});
    for (int i = 0; i < 4; ++i) tracker.process(at(frame, i));
    return tracker.states().front().advice;
  };
  SimulatedSensor sensor = smallSensor();
  EXPECT_EQ(advice(sensor, kMiddle), HandAdvice::kNone);
  SimulatedSensor dark = sensor;
  dark.white = 45, dark.noise = 1;
  EXPECT_EQ(advice(dark, kMiddle), HandAdvice::kTooDark);
  SimulatedSensor blurred = sensor;
  blurred.blur_px = 2;
  EXPECT_EQ(advice(blurred, {kMiddle.linear, {0, 0, 280}}), HandAdvice::kOutOfFocus);
  EXPECT_EQ(advice(sensor, {kMiddle.linear, {0, 0, 90}}), HandAdvice::kTooNear);
  EXPECT_EQ(advice(sensor, {kMiddle.linear, {-325, 0, 500}}), HandAdvice::kAtEdge);
  for (int a = 1; a <= int(HandAdvice::kTooFast); ++a) {
    const std::string sentence(sentenceOf(HandAdvice(a)));
    EXPECT_TRUE(sentence.ends_with('.')) << a;
  }
}

TEST(HandTracker, IgnoresFramesOfAnotherSizeAndOfThePast) {
  const SimulatedSensor sensor = smallSensor();
  SimulatedCamera camera(sensor, 61);
  const TagBody body = bodyNamed("needle");
  HandTracker tracker(sensor.lens, {body});
  const CameraFrame frame = camera.render({atRest(body, kMiddle)}, 0);
  tracker.process(at(frame, 5));
  const TrackedHand state = tracker.states().front();
  tracker.process(at(frame, 5));
  tracker.process(at(frame, 2));
  CameraFrame small;
  small.width = 4, small.height = 4, small.pixels.resize(16), small.time_ns = 1'000'000'000;
  tracker.process(small);
  CameraFrame torn = at(frame, 9);
  torn.pixels.resize(100);
  tracker.process(torn);
  EXPECT_EQ(tracker.states().front().time_ns, state.time_ns);
  EXPECT_EQ(tracker.states().front().cameraFromBody, state.cameraFromBody);
}

TEST(HandTracker, NoiseAndBrokenImagesNeverBreakIt) {
  SimulatedSensor sensor = smallSensor();
  sensor.lens = scaledLens(sensor.lens, 320, 180);
  const TagBody body = bodyNamed("needle");
  SimulatedCamera camera(sensor, 71);
  const CameraFrame frame = camera.render({atRest(body, {kMiddle.linear, {10, 0, 180}})}, 0);
  HandTracker tracker(sensor.lens, {body});
  std::mt19937 random(72);
  for (int i = 0; i < 150; ++i) {
    CameraFrame broken = at(frame, i);
    const int kind = int(random() % 4);
    for (std::size_t p = 0; p < broken.pixels.size(); ++p) {
      if (kind == 0) broken.pixels[p] = std::uint8_t(random());
      if (kind == 1 && p % 320 > random() % 320) broken.pixels[p] = 255;
      if (kind == 2 && p > broken.pixels.size() / 2) broken.pixels[p] = 0;
    }
    for (const TrackedHand& state : tracker.process(broken)) EXPECT_TRUE(isFinite(state.cameraFromBody.offset));
  }
}

TEST(HandTracker, MemoryDoesNotGrowOverThousandsOfFrames) {
  SimulatedSensor sensor = smallSensor();
  sensor.lens = scaledLens(sensor.lens, 320, 180);
  const TagBody body = bodyNamed("needle");
  SimulatedCamera camera(sensor, 81);
  std::vector<CameraFrame> frames;
  for (int i = 0; i < 6; ++i)
    frames.push_back(camera.render({atRest(body, {kMiddle.linear, {10.0 + i % 3, 0, 180}})}, 0));
  frames.push_back(camera.render({}, 0));
  HandTracker tracker(sensor.lens, {body});
  std::int64_t number = 0;
  const auto run = [&](int count) {
    for (int i = 0; i < count; ++i) {
      CameraFrame& frame = frames[std::size_t(number) % frames.size()];
      frame.time_ns = 1 + ++number * 33'333'333;
      tracker.process(frame);
    }
  };
  run(200);
  const auto before = mallinfo2().uordblks;
  run(3000);
  EXPECT_LT(double(mallinfo2().uordblks), double(before) + 65536);
}

}  // namespace
}  // namespace insonate::test
