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
  std::shared_ptr<const AcousticScene> scene;                ///< null where it failed
  std::shared_ptr<const std::vector<std::string>> warnings;  ///< null where it failed
  std::string error;
  double build_ms = 0;
};

/// Builds scenes on a thread of its own, one at a time.
class SceneBuilder {
 public:
  /// `whenDone` is called on the worker each time that take() has something.
  SceneBuilder(CaseVolumes patient, const LiveOptions& options, std::function<void()> whenDone);
  /// Cancels and waits.
  ~SceneBuilder();

  /// Begins a job and cancels the running one, whose result never arrives.
  void begin(SceneJob job);
  void cancel();
  /// Cancels, and gives back what scenes are made of, until the next job.
  void rest();
  /// Scenes to come will lie here. Computed in idle time, after the first scene.
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
  std::atomic<std::uint64_t> ticket_{0};  ///< of the job that is wanted; another one cancels
  bool stopping_ = false;
  bool dropping_ = false;  ///< the source is to be given back before the next job
  std::optional<SceneJob> next_;
  std::optional<BuiltScene> done_;
  std::unique_ptr<ScenesAhead> ahead_;
  std::shared_ptr<const SceneSource> source_;  ///< only the worker touches it
  std::string sourceError_;
  std::thread thread_;  ///< last: it uses the others
};

}  // namespace insonate::live
