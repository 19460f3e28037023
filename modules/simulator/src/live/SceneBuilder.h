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
};

struct BuiltScene {
  SceneJob job;
  std::shared_ptr<const AcousticScene> scene;                ///< null if the build failed
  std::shared_ptr<const std::vector<std::string>> warnings;  ///< null if the build failed
  std::string error;
  double build_ms = 0;
};

/// Builds scenes on its own thread, one at a time.
class SceneBuilder {
 public:
  /// `whenDone` is called on the builder's thread each time that take() has a new result.
  SceneBuilder(CaseVolumes patient, const LiveOptions& options, std::function<void()> whenDone);
  /// Cancels the running job and waits for the thread.
  ~SceneBuilder();

  /// Begins a job and cancels the running job, whose result is discarded.
  void begin(SceneJob job);
  void cancel();
  /// Cancels the running job, and releases the source of the scenes until the next job.
  void rest();
  /// Tells where later scenes are expected. Their parts are computed in idle time, after the first scene.
  void expect(const Region& region_mm, double detail_mm);
  std::optional<BuiltScene> take();

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
  std::atomic<std::uint64_t> ticket_{0};  ///< number of the requested job; a job with another number is cancelled
  bool stopping_ = false;
  bool dropping_ = false;  ///< the source is to be released before the next job
  std::optional<SceneJob> next_;
  std::optional<BuiltScene> done_;
  std::unique_ptr<ScenesAhead> ahead_;
  std::shared_ptr<const SceneSource> source_;  ///< only the builder's thread uses it
  std::string sourceError_;
  std::thread thread_;  ///< last: the thread uses the other members
};

}  // namespace insonate::live
