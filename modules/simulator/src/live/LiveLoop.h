#pragma once

#include "live/Cine.h"
#include "live/FramePool.h"
#include "live/SceneBuilder.h"
#include "live/SceneNeed.h"

#include <insonate/core/Mailbox.h>

#include <chrono>
#include <cmath>

namespace insonate {

/// What LiveImaging is: what crosses between threads first, then what only the simulation thread touches.
class LiveImaging::Impl {
 public:
  Impl(std::shared_ptr<const PatientCase> patient, std::shared_ptr<const ImagingSetup> setup, Imager imager,
       const Transform& patientFromProbe, const LiveOptions& options);
  ~Impl();

  void setPose(const Transform& patientFromProbe);
  void setSetup(std::shared_ptr<const ImagingSetup> setup);
  void setFrozen(bool frozen);
  std::shared_ptr<const LiveFrame> latest() const;
  std::vector<std::shared_ptr<const LiveFrame>> cine(double seconds) const;
  void onFrame(std::function<void()> listener);
  double imagesPerSecond() const;
  LiveStatus status() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// A setup with what has been made for it.
  struct Source {
    Source(std::shared_ptr<const ImagingSetup> setup, Imager imager, const VolumeGeometry& volume);
    std::shared_ptr<const ImagingSetup> setup;
    Imager imager;
    live::SceneNeed need;
    int framesToSettle;  ///< pictures of a still probe until persistence no longer shows
    BModeImage black;    ///< made when first needed
  };

  void wake();
  void run();
  void takeInputs();
  void takeScene();
  void activateNext();
  void followProbe();
  bool isFrozen() const;
  bool makePicture();
  void blackPicture();
  bool publish();
  void setState(LiveState state, std::string message = {});
  void notify();
  bool isCovered(const Source& source) const;
  static bool suits(const live::SceneJob& job, const Source& source);
  double now_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  const std::shared_ptr<const PatientCase> patient_;
  const LiveOptions options_;
  const Clock::time_point begin_ = Clock::now();

  Mailbox<Transform> poses_;
  Mailbox<std::shared_ptr<const ImagingSetup>> setups_;
  std::atomic<std::uint32_t> woken_{0};
  std::atomic<bool> stopping_{false};

  mutable std::mutex mutex_;  ///< of the following
  bool frozen_ = false;
  live::Cine cine_;
  LiveStatus status_;
  /// Of the last pictures, in a ring.
  std::vector<double> times_s_ = std::vector<double>(512, -HUGE_VAL);

  std::mutex listenerMutex_;
  std::function<void()> listener_;

  // Only the simulation thread touches what follows.
  std::shared_ptr<live::FramePool> pool_ = live::FramePool::make();
  Source active_;
  std::optional<Source> next_;         ///< waits for its scene
  live::BuiltScene scene_;             ///< suits active_; empty before the first
  std::optional<live::SceneJob> job_;  ///< being built
  bool jobFailed_ = false;             ///< not to be tried again before something changes
  Transform pose_, drawnPose_;
  bool drawn_ = false;  ///< active_ has made a picture at drawnPose_
  bool frozenSeen_ = false;
  int settleLeft_ = 0;
  std::uint64_t number_ = 0;
  ImagingFrame scratch_;

  live::SceneBuilder builder_;
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace insonate
