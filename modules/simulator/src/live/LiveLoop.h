#pragma once

#include "line/SalineBubbles.h"
#include "live/Cine.h"
#include "live/FramePool.h"
#include "live/SceneBuilder.h"
#include "live/SceneNeed.h"
#include "live/SpectrumThread.h"

#include <insonate/core/Mailbox.h>
#include <insonate/simulator/CompressedTissue.h>
#include <insonate/simulator/MovingBlood.h>
#include <insonate/ultrasound/PlaneTissue.h>

#include <chrono>
#include <cmath>
#include <condition_variable>

namespace insonate {

/// Implementation of LiveImaging. Members shared between threads come first, then those of the imaging thread alone.
class LiveImaging::Impl {
 public:
  static constexpr int kIterations = 4;  ///< iterations of the deformation model for each image

  Impl(CaseVolumes patient, std::shared_ptr<const ImagingSetup> setup, Imager imager, CompressedTissue tissue,
       const Transform& patientFromProbe, const LiveOptions& options);
  ~Impl();

  void setPose(const Transform& patientFromProbe);
  void setNeedle(const std::optional<Needle>& needle, const std::optional<Tenting>& tenting);
  void setRods(SharedRods rods);
  void setFlush(const std::optional<SalineFlush>& flush);
  void setPneumothorax(const std::array<bool, 2>& lungs);
  void setSetup(std::shared_ptr<const ImagingSetup> setup);
  void setPhysiology(const Physiology& physiology);
  void setPulsating(bool pulsating);
  void setKeepMesh(bool keep);
  void setGate(const std::optional<SpectralSettings>& gate);
  void takeSpectra(std::vector<LiveSpectrum>& spectra) { spectra_.take(spectra); }
  void setFrozen(bool frozen);
  void setPaused(bool paused);
  std::shared_ptr<const LiveFrame> latest() const;
  std::vector<std::shared_ptr<const LiveFrame>> cine(double seconds) const;
  void setFrameListener(std::function<void()> listener);
  double imagesPerSecond() const;
  LiveStatus status() const;

 private:
  using Clock = std::chrono::steady_clock;

  /// An imaging setup with the objects that were made for it.
  struct Source {
    Source(std::shared_ptr<const ImagingSetup> setup, Imager imager, CompressedTissue tissue,
           const VolumeGeometry& volume);
    std::shared_ptr<const ImagingSetup> setup;
    Imager imager;
    CompressedTissue tissue;
    live::SceneNeed need;
    int framesToSettle;  ///< number of images of a still probe until persistence shows no earlier image
    BModeImage black;    ///< black image for a probe outside the patient; made when first needed
  };

  struct NeedleInTissue {
    std::optional<Needle> needle;
    std::optional<Tenting> tenting;
    bool operator==(const NeedleInTissue&) const = default;
  };

  static constexpr double kNever_s = HUGE_VAL;
  /// Maximum number of images over which one deformation is iterated. A deformation that has not converged by then is
  /// not expected to converge.
  static constexpr int kMaxOfOneSolve = 30;

  void wake();
  void waitFor(double seconds);
  void run();
  void rest();
  void takeInputs();
  void takeScene();
  void activateNext();
  void followProbe();
  void coverAtOnce();
  void activate(Source source);
  bool isFrozen() const;
  /// Makes an image if pose, setup or tissue require one. Returns the seconds until the next image; infinite if none is
  /// needed until something changes.
  double makeImage();
  void renderImage();
  void blackImage();
  void takePhysiology();
  void takePneumothorax();
  void press();
  bool breathes() const;
  bool showsLung();
  Vec3 tissueVelocity_mmps() const;
  double interval_s() const;
  void setMotion(const PlaneDisplacement& displacement);
  void showGate(const PlaneDisplacement& displacement);
  bool continues() const { return !press_.settled && tissueLeft_ > 0; }
  double timeToNextPulse_s() const;
  std::span<const Bubble> bubblesNow();
  void describePress(LiveDeformation& press) const;
  bool publish();
  void setState(LiveState state, std::string message = {});
  void notify();
  bool isCovered(const Source& source) const;
  static bool suits(const live::SceneJob& job, const Source& source);
  double now_s() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

  const CaseVolumes patient_;
  const LiveOptions options_;
  const Clock::time_point begin_ = Clock::now();

  Mailbox<Transform> poses_;
  Mailbox<NeedleInTissue> needles_;
  Mailbox<SharedRods> rodChanges_;
  Mailbox<std::optional<SalineFlush>> flushes_;
  Mailbox<std::array<bool, 2>> pneumothoraces_;
  Mailbox<std::shared_ptr<const ImagingSetup>> setups_;
  Mailbox<Physiology> physiologies_;
  std::atomic<bool> pulsating_, keepMesh_{false}, gateBegun_{false};
  std::mutex wakeMutex_;
  std::condition_variable waking_;
  bool woken_ = false;  ///< guarded by wakeMutex_
  std::atomic<bool> stopping_{false}, resting_;

  mutable std::mutex mutex_;  ///< guards the following members
  bool frozen_ = false;
  live::Cine cine_;
  LiveStatus status_;
  /// Times of the last images, as a ring buffer.
  std::vector<double> times_s_ = std::vector<double>(512, -HUGE_VAL);

  std::mutex listenerMutex_;
  std::function<void()> listener_;

  // Only the imaging thread uses the following members.
  std::shared_ptr<live::FramePool> pool_ = live::FramePool::make();
  Source active_;
  std::optional<Source> next_;         ///< setup that becomes active when its scene is built
  live::BuiltScene scene_;             ///< acoustic scene for active_; empty before the first
  std::optional<live::SceneJob> job_;  ///< acoustic scene that is being built
  bool jobFailed_ = false;             ///< true: building job_ failed; it is not tried again before something changes
  Transform pose_, drawnPose_;
  bool drawn_ = false;  ///< true: an image of active_ at drawnPose_ was made from scene_ or from a scene of its quality
  bool jumped_ = false;  ///< true: the next image shows another place than the image before it
  NeedleInTissue needle_, drawnNeedle_;
  SharedRods rods_, drawnRods_;
  std::optional<SalineFlush> flush_, drawnFlush_;  ///< flush whose bubbles are shown
  double flushed_s_ = 0;                           ///< time at which they began
  SalineBubbles bubbles_;
  TentedTissue tented_;
  bool frozenSeen_ = false;
  int settleLeft_ = 0;
  Physiology physiology_;
  bool pulsatingSeen_ = false;          ///< value of pulsating_ at the last image
  std::vector<PlanePoint> lungPoints_;  ///< points at which showsLung() looks
  PlaneSamples lungTissue_;
  Pneumothorax pneumothorax_;   ///< times since LiveImaging was constructed
  bool lungShown_ = false;      ///< true: the last image shows a lung that slides with respiration
  bool bloodChanged_ = false;   ///< true: blood pressure has changed since the last image
  int tissueLeft_ = 0;          ///< number of images that may still continue the iteration of the present deformation
  double begun_s_ = -HUGE_VAL;  ///< time at which the last image was begun
  double sinceDrawn_s_ = 0;     ///< time from the beginning of the image before to that of the last image
  MovingBlood blood_;
  LiveDeformation press_;
  std::uint64_t number_ = 0;
  ImagingFrame scratch_;

  live::SceneBuilder builder_;
  live::SpectrumThread spectra_;
  std::thread thread_;  ///< declared last, since the thread uses the other members
};

}  // namespace insonate
