#pragma once

#include <insonate/simulator/LiveImaging.h>
#include <insonate/simulator/ProbePose.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace insonate::test {

using Frame = std::shared_ptr<const LiveFrame>;

inline ImagingSetup smallSetup() {
  ImagingSetup setup{*loadProbe("linear"), {}, *loadAcousticTable("neck"), "cpu"};
  setup.probe.name = "coarse linear";
  // A beam so wide that 1 mm voxels need not be divided: scenes in an eighth of the time.
  setup.probe.transmitFNumber = setup.probe.receiveFNumber = 7;
  setup.probe.elevationFocus_mm = 10;  // in the middle of the image, where needles are
  setup.settings = settingsFor(setup.probe);
  setup.settings.depth_mm = 25;
  setup.settings.scanlines = 48;
  setup.settings.samples = 200;
  setup.settings.elevationPlanes = 1;
  setup.settings.looks = 1;
  setup.settings.width = 128;
  setup.settings.height = 96;
  setup.settings.effects.noise = false;  // images are compared with others of the same pose
  setup.mechanics.model = kNoDeformation;
  return setup;
}

inline Transform poseAt(double x_mm, double z_mm = 0) {
  return *patientFromProbe({x_mm, 0, z_mm}, {0, 1, 0}, {1, 0, 0});
}

/// A slab of tissue 200 mm wide with a vein every 20 mm: several scenes side by side.
inline std::shared_ptr<const PatientCase> wideCase() {
  VolumeGeometry grid;
  grid.size = {201, 46, 40};
  grid.origin_mm = {-100, -10, -20};
  auto patient = std::make_shared<PatientCase>(PatientCase{{}, CtVolume(grid, -1000), LabelMap(grid)});
  for (int k = 0; k < grid.size[2]; ++k)
    for (int j = 10; j < grid.size[1]; ++j)
      for (int i = 0; i < grid.size[0]; ++i) {
        const double x = i - 100, depth = j - 10;
        const bool vein = std::hypot(std::remainder(x, 20), depth - 12) < 5;
        patient->labels.at(i, j, k) = depth < 2 ? kSkin : vein ? kVein : kSoftTissue;
        patient->ct.at(i, j, k) = static_cast<std::int16_t>(vein ? 45 : 30 + (i * 7 + j * 3 + k) % 11);
      }
  return patient;
}

inline BModeImage freshPicture(const PatientCase& patient, const ImagingSetup& setup, const Transform& pose,
                               std::uint64_t noiseSeed = 0) {
  auto imager = Imager::make(setup);
  auto scene = makeScene(patient, setup, regionOf(setup.probe, setup.settings, pose));
  EXPECT_TRUE(imager && scene);
  ImagingFrame frame;
  frame.noiseSeed = static_cast<std::uint32_t>(noiseSeed);
  imager->render(**scene, pose, frame);
  return frame.image;
}

inline int greatestDifference(const BModeImage& a, const BModeImage& b) {
  if (a.gray.size() != b.gray.size()) return 256;
  int most = 0;
  for (std::size_t i = 0; i < a.gray.size(); ++i) most = std::max(most, std::abs(int(a.gray[i]) - int(b.gray[i])));
  return most;
}

/// LiveImaging with a way to wait for what it says.
class Live {
 public:
  explicit Live(const Transform& pose = poseAt(0), const ImagingSetup& setup = smallSetup(), LiveOptions options = {},
                std::shared_ptr<const PatientCase> patient = wideCase()) {
    options.threads = 2;
    auto made = LiveImaging::make(std::move(patient), setup, pose, options);
    EXPECT_TRUE(made) << made.error().message;
    imaging_ = std::move(*made);
    imaging_->setFrameListener([this] {
      const std::lock_guard lock(mutex_);
      ++calls_;
      changed_.notify_all();
    });
    const std::lock_guard lock(mutex_);
    changed_.notify_all();
  }
  ~Live() { imaging_->setFrameListener({}); }

  LiveImaging* operator->() { return imaging_.get(); }
  int calls() {
    const std::lock_guard lock(mutex_);
    return calls_;
  }

  template <class Condition>
  bool until(const Condition& condition, std::chrono::milliseconds patience = std::chrono::minutes(5)) {
    const auto end = std::chrono::steady_clock::now() + patience;
    std::unique_lock lock(mutex_);
    while (!condition()) {
      if (std::chrono::steady_clock::now() > end) return false;
      changed_.wait_for(lock, std::chrono::milliseconds(5));
    }
    return true;
  }
  /// The image of a pose, in full quality.
  Frame frameAt(const Transform& pose) {
    imaging_->setPose(pose);
    Frame frame;
    EXPECT_TRUE(
        until([&] { return (frame = imaging_->latest()) && frame->patientFromProbe == pose && !frame->isCoarse; }));
    return frame;
  }
  /// Nothing more is under way.
  void settle() {
    const auto paused = [&] {
      return imaging_->latest() && !imaging_->latest()->isCoarse && !imaging_->status().buildingScene;
    };
    do {
      ASSERT_TRUE(until(paused));
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    } while (!paused());
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int calls_ = 0;
  std::unique_ptr<LiveImaging> imaging_;
};

}  // namespace insonate::test
