#pragma once

#include "live/ScenesAhead.h"

#include <insonate/cases/CaseView.h>
#include <insonate/simulator/Imager.h>
#include <insonate/simulator/LiveImaging.h>

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace insonate::live {

struct SceneJob {
  std::shared_ptr<const ImagingSetup> setup;
  Region region_mm;
  double detail_mm = 0;
  SceneQuality quality = SceneQuality::Full;
  bool isUrgent = false;  ///< true: the image waits for the scene, or is coarse until the scene is built
};

struct BuiltScene {
  SceneJob job;
  std::shared_ptr<const AcousticScene> scene;                ///< the acoustic scene; null if the build failed
  std::shared_ptr<const std::vector<std::string>> warnings;  ///< sentences about the case; null if the build failed
  std::string error;
  double build_ms = 0;

  bool isCoarse() const { return job.quality == SceneQuality::Coarse; }
};

/// Builds a scene; `progress` may cancel it.
BuiltScene buildScene(const SceneSource& source, const SceneJob& job, const Progress& progress);

/// Builds acoustic scenes on its own thread, one at a time.
class SceneBuilder {
 public:
  /// `whenDone` is called on the builder's thread each time that a scene is ready for take(), and when source() is.
  SceneBuilder(CaseVolumes patient, const LiveOptions& options, std::function<void()> whenDone);
  /// Cancels the scene in progress and waits for the thread.
  ~SceneBuilder();

  /// Begins to build a scene; a scene in progress is cancelled and discarded.
  void begin(SceneJob job);
  void cancel();
  /// Cancels the scene in progress, and releases the memory of the SceneSource until the next job.
  void rest();
  /// Sets the region in which later scenes are expected; their parts are computed in idle time, after the first scene.
  void expect(const Region& region_mm, double detail_mm);
  std::optional<BuiltScene> take();
  /// Returns the source of the scenes; null before the first job and after rest().
  std::shared_ptr<const SceneSource> source();

 private:
  void work();
  BuiltScene build(const SceneJob& job, std::uint64_t ticket) const;

  void findSource();
  void dropSource();

  CaseVolumes patient_;
  int threads_;
  bool workAhead_, background_;
  std::function<void()> whenDone_;
  std::mutex mutex_;
  std::condition_variable changed_;
  /// number of the scene requested last; a job in progress with another number is cancelled
  std::atomic<std::uint64_t> ticket_{0};
  bool stopping_ = false;
  bool dropping_ = false;  ///< true: source_ is to be released before the next job
  std::optional<SceneJob> next_;
  std::optional<BuiltScene> done_;
  std::unique_ptr<ScenesAhead> ahead_;
  std::shared_ptr<const SceneSource> source_;  ///< source of scenes; only the builder's thread changes it
  std::string sourceError_;
  std::thread thread_;  ///< declared last, since the thread uses the other members
};

}  // namespace insonate::live
