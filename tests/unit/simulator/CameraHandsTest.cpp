#include <insonate/camera/LensCalibration.h>
#include <insonate/camera/SimulatedCamera.h>
#include <insonate/simulator/CameraHands.h>

#include <gmock/gmock.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

using namespace insonate;
using testing::HasSubstr;

namespace {

constexpr int kWidth = 640, kHeight = 480;

/// A quarter turn about x: the tools point down in the image, away from the user's hands.
Transform held(Vec3 place_mm) {
  return {{{Vec3{1, 0, 0}, Vec3{0, 0, -1}, Vec3{0, 1, 0}}}, place_mm};
}

/// Frames that the test shows to the camera. The test also plugs the camera in and out.
struct Stage {
  std::mutex mutex;
  CameraFrame shown;
  std::atomic<bool> isPluggedIn = true;
  std::atomic<int> frames = 0;

  void show(CameraFrame frame) {
    const std::lock_guard lock(mutex);
    shown = std::move(frame);
  }
};

class StageCamera : public CameraSource {
 public:
  explicit StageCamera(std::shared_ptr<Stage> stage) : stage_(std::move(stage)) {}
  std::string name() const override { return "Stage camera"; }
  int width() const override { return kWidth; }
  int height() const override { return kHeight; }
  Result<CameraStatus> next(CameraFrame& frame, std::chrono::milliseconds) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!stage_->isPluggedIn) return fail("/dev/video9: was unplugged. Plug the camera in again.");
    const std::lock_guard lock(stage_->mutex);
    frame = stage_->shown;
    frame.time_ns = std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    ++stage_->frames;
    return CameraStatus::kFrame;
  }

 private:
  std::shared_ptr<Stage> stage_;
};

class CameraHandsTest : public testing::Test {
 protected:
  CameraHandsTest() {
    lens.k1 = 0.05, lens.k2 = -0.1;
    sensor.lens = lens;
  }
  CameraFrame render(const Transform* probe, const Transform* needle) {
    SimulatedCamera camera(sensor, 3);
    std::vector<SimulatedObject> objects;
    const auto add = [&](const char* name, const Transform* pose) {
      if (pose) objects.push_back({*loadTagBody(name), [at = *pose](double) { return at; }, {}});
    };
    add("probe", probe), add("needle", needle);
    return camera.render(objects, 0);
  }
  void start(const CameraCalibration& calibration) {
    hands = std::make_unique<CameraHands>(
        [stage = stage]() -> Result<std::unique_ptr<CameraSource>> {
          if (!stage->isPluggedIn) return fail("There is no camera at /dev/video9.");
          return std::make_unique<StageCamera>(stage);
        },
        devices, calibration);
  }
  template <class Done>
  bool waitFor(Done done) {
    for (int i = 0; i < 1500; ++i) {
      if (done()) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }
  void waitFrames(int frames) {
    const int until = stage->frames + frames;
    EXPECT_TRUE(waitFor([&] { return stage->frames >= until; }));
  }
  /// The state after the last correction was blended.
  DeviceState poll(HapticTool hand) {
    DeviceState state;
    EXPECT_TRUE(devices[hand]->pollState(state));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    devices[hand]->pollState(state);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    devices[hand]->pollState(state);
    return state;
  }

  LensModel lens = lensWithoutDistortion(kWidth, kHeight, 60);
  SimulatedSensor sensor;
  std::shared_ptr<Stage> stage = std::make_shared<Stage>();
  std::array<std::shared_ptr<PoseDevice>, 2> devices = CameraHands::makeDevices();
  std::unique_ptr<CameraHands> hands;
};

TEST_F(CameraHandsTest, BothBodiesMoveTheirDevices) {
  const Transform probe = held({-70, -40, 380}), needle = held({70, -40, 360});
  stage->show(render(&probe, &needle));
  start({lens, {}});
  ASSERT_TRUE(waitFor([&] { return devices[0]->counters().reports > 3 && devices[1]->counters().reports > 3; }));
  waitFrames(5);
  const Vec3 tip_mm = poll(kNeedleTool).deviceFromStylus.offset, face_mm = poll(kProbeTool).deviceFromStylus.offset;
  EXPECT_NEAR(norm(tip_mm - Vec3{-70, -45, 360}), 0, 1) << "the tip is 85 mm below the body; x to the user's right";
  EXPECT_NEAR(norm(face_mm - Vec3{70, -80, 380}), 0, 1);
  // The needle points along the stylus's -z axis, down.
  EXPECT_NEAR(norm(poll(kNeedleTool).deviceFromStylus.linear.column[2] - Vec3{0, 1, 0}), 0, 0.02);
  EXPECT_EQ(devices[kNeedleTool]->quality().advice, "");
  EXPECT_GT(devices[kNeedleTool]->quality().quality, 0.7);
  EXPECT_GT(devices[kNeedleTool]->quality().latency_ms, 0);
  const CameraView view = hands->view();
  EXPECT_GE(view.bodies[kProbeTool].outline.size(), 15U);
  EXPECT_EQ(view.frame.width, kWidth);

  const Transform moved = held({60, -40, 365});
  stage->show(render(&probe, &moved));
  waitFrames(3);
  EXPECT_TRUE(waitFor([&] { return devices[kNeedleTool]->quality().quality > 0.5; }))
      << devices[kNeedleTool]->quality().advice;
  waitFrames(12);
  EXPECT_NEAR(norm(poll(kNeedleTool).deviceFromStylus.offset - tip_mm - Vec3{10, 0, 5}), 0, 1);
  EXPECT_NEAR(norm(poll(kProbeTool).deviceFromStylus.offset - face_mm), 0, 0.3);
  EXPECT_EQ(hands->state().error, "");
  EXPECT_NEAR(hands->state().frames_Hz, 30, 25);
}

TEST_F(CameraHandsTest, AHiddenBodyStaysAndTheDeviceSaysSo) {
  const Transform probe = held({-70, -40, 380}), needle = held({70, -40, 360});
  stage->show(render(&probe, &needle));
  start({lens, {}});
  ASSERT_TRUE(waitFor([&] { return devices[1]->counters().reports > 5; }));
  const Vec3 tip_mm = poll(kNeedleTool).deviceFromStylus.offset;
  stage->show(render(&probe, nullptr));
  waitFrames(5);
  const std::uint64_t reports = devices[kNeedleTool]->counters().reports;
  waitFrames(5);
  EXPECT_EQ(devices[kNeedleTool]->counters().reports, reports);
  EXPECT_EQ(devices[kNeedleTool]->phase(), DevicePhase::kStreaming);
  EXPECT_NEAR(norm(poll(kNeedleTool).deviceFromStylus.offset - tip_mm), 0, 1);
  EXPECT_EQ(devices[kNeedleTool]->quality().quality, 0);
  EXPECT_THAT(devices[kNeedleTool]->quality().advice, HasSubstr("does not see the body"));
  EXPECT_EQ(devices[kProbeTool]->quality().advice, "");
  stage->show(render(&probe, &needle));
  EXPECT_TRUE(waitFor([&] { return devices[kNeedleTool]->quality().quality > 0.5; })) << "found again";
}

TEST_F(CameraHandsTest, AnUnpluggedCameraIsLostAndFoundAgain) {
  const Transform probe = held({0, -40, 380});
  stage->isPluggedIn = false;
  stage->show(render(&probe, nullptr));
  start({lens, {}});
  ASSERT_TRUE(waitFor([&] { return devices[0]->phase() == DevicePhase::kFailed; }));
  EXPECT_EQ(devices[0]->error(), "There is no camera at /dev/video9.");
  EXPECT_EQ(hands->state().error, "There is no camera at /dev/video9.");
  stage->isPluggedIn = true;
  ASSERT_TRUE(waitFor([&] { return devices[0]->phase() == DevicePhase::kStreaming; }));
  EXPECT_EQ(devices[0]->error(), "");
  EXPECT_EQ(devices[1]->phase(), DevicePhase::kReady) << "not seen yet";
  stage->isPluggedIn = false;
  ASSERT_TRUE(waitFor([&] { return devices[0]->phase() == DevicePhase::kLost; }));
  EXPECT_THAT(devices[1]->error(), HasSubstr("camera"));
  stage->isPluggedIn = true;
  ASSERT_TRUE(waitFor([&] { return devices[0]->phase() == DevicePhase::kStreaming; }));
  hands.reset();
  EXPECT_EQ(devices[0]->phase(), DevicePhase::kAbsent);
}

TEST_F(CameraHandsTest, TheProbeOnTheOutlineSetsTheDesk) {
  const Transform probe = held({-40, -60, 380}), needle = held({70, -40, 360});
  stage->show(render(&probe, &needle));
  start({lens, {}});
  ASSERT_TRUE(waitFor([&] { return devices[0]->counters().reports > 3; }));
  hands->registerDesk();
  ASSERT_TRUE(waitFor([&] { return !hands->state().outcome.empty(); }));
  EXPECT_FALSE(hands->state().hasFailed) << hands->state().outcome;
  ASSERT_TRUE(hands->calibration().cameraFromDesk);
  waitFrames(5);
  const Transform onOutline = poll(kProbeTool).deviceFromStylus;
  EXPECT_NEAR(norm(onOutline.offset), 0, 0.5);
  for (std::size_t axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(norm(onOutline.linear.column[axis] - stylusOnOutline().linear.column[axis]), 0, 0.02);
  // The needle's tip is 110 mm beside the middle of the probe's face, 20 mm nearer to the camera and 15 mm higher.
  EXPECT_NEAR(norm(poll(kNeedleTool).deviceFromStylus.offset), norm(Vec3{110, 15, 20}), 1);
  EXPECT_NEAR(poll(kNeedleTool).deviceFromStylus.offset.y, 15, 1) << "y is up";
}

TEST_F(CameraHandsTest, WithoutTheProbeTheDeskIsNotSet) {
  stage->show(render(nullptr, nullptr));
  start({lens, {}});
  ASSERT_TRUE(waitFor([&] { return stage->frames > 2; }));
  hands->registerDesk();
  ASSERT_TRUE(waitFor([&] { return !hands->state().outcome.empty(); }));
  EXPECT_TRUE(hands->state().hasFailed);
  EXPECT_THAT(hands->state().outcome, HasSubstr("outline"));
  EXPECT_FALSE(hands->calibration().cameraFromDesk);
}

/// Board with all its tags, as a flat box.
TagBody boardBody() {
  TagBody board;
  board.name = "board";
  for (const double z : {0.0, -2.0})
    for (const auto& [x, y] : {std::pair{-140.0, -100.0}, {140.0, -100.0}, {140.0, 100.0}, {-140.0, 100.0}})
      board.vertices_mm.push_back({x, y, z});
  board.faces = {{0, 1, 2, 3}, {7, 6, 5, 4}, {0, 4, 5, 1}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 4, 0}};
  board.tags = lensBoard();
  return board;
}

TEST_F(CameraHandsTest, TheBoardCalibratesTheLens) {
  const TagBody board = boardBody();
  const auto boardFrame = [&](int i) {
    const double a = 0.45 * std::sin(i * 1.9), b = 0.45 * std::cos(i * 1.3);
    const Vec3 z = normalized(Vec3{std::sin(a), std::sin(b), -1}), x = normalized(cross(Vec3{0, -1, 0}, z));
    const Transform pose{{{x, cross(z, x), z}}, {30. * std::sin(i * 2.), 20. * std::cos(i * 3.), 420. + 12 * i}};
    return SimulatedCamera(sensor, 5).render({{board, [pose](double) { return pose; }, {}}}, 0);
  };
  stage->show(boardFrame(0));
  start({});
  hands->calibrateLens();
  for (int i = 1; i < 20 && hands->state().outcome.empty(); ++i) {
    waitFrames(3);
    stage->show(boardFrame(i));
  }
  ASSERT_TRUE(waitFor([&] { return !hands->state().outcome.empty(); })) << hands->state().taken;
  EXPECT_FALSE(hands->state().hasFailed) << hands->state().outcome;
  ASSERT_TRUE(hands->calibration().lens);
  EXPECT_NEAR(hands->calibration().lens->fx_px, lens.fx_px, 0.01 * lens.fx_px);
}

}  // namespace
