#include "live/SceneBuilder.h"

#include <insonate/core/ThreadPriority.h>

#include <tbb/info.h>
#include <tbb/task_arena.h>

#include <chrono>
#include <exception>
#include <utility>

namespace insonate::live {

BuiltScene buildScene(const SceneSource& source, const SceneJob& job, const Progress& progress) {
  BuiltScene built{.job = job, .scene = {}, .warnings = {}, .error = {}};
  const auto start = std::chrono::steady_clock::now();
  try {
    auto scene = makeScene(source, *job.setup, job.region_mm, progress, job.quality);
    if (scene) {
      built.scene = std::move(*scene);
      built.warnings = std::make_shared<const std::vector<std::string>>(built.scene->warnings());
    } else {
      built.error = scene.error().message;
    }
  } catch (const std::exception& error) {
    built.error = "There is not enough memory for the scene around the probe (" + std::string(error.what()) +
                  "); close other programs, or choose less depth.";
  }
  built.build_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  return built;
}

SceneBuilder::SceneBuilder(CaseVolumes patient, const LiveOptions& options, std::function<void()> whenDone)
    : patient_(std::move(patient)),
      threads_(options.threads),
      workAhead_(options.workAhead),
      background_(options.background),
      whenDone_(std::move(whenDone)),
      thread_([this] { work(); }) {}

SceneBuilder::~SceneBuilder() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    ++ticket_;
  }
  changed_.notify_one();
  thread_.join();
}

void SceneBuilder::begin(SceneJob job) {
  {
    const std::lock_guard lock(mutex_);
    ++ticket_;
    // Parts around the former place would only delay the scene.
    if (job.isUrgent && ahead_) ahead_->drop();
    next_ = std::move(job);
    done_.reset();
  }
  changed_.notify_one();
}

void SceneBuilder::cancel() {
  const std::lock_guard lock(mutex_);
  ++ticket_;
  next_.reset();
  done_.reset();
}

void SceneBuilder::rest() {
  cancel();
  {
    const std::lock_guard lock(mutex_);
    dropping_ = true;
  }
  changed_.notify_one();
}

void SceneBuilder::expect(const Region& region_mm, double detail_mm) {
  const std::lock_guard lock(mutex_);
  if (ahead_) ahead_->want(region_mm, detail_mm);
}

std::optional<BuiltScene> SceneBuilder::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, std::nullopt);
}

void SceneBuilder::work() {
  if (background_) lowerThreadPriority();
  // Images have precedence: while one is computed, its arena gets the processors. An urgent scene takes all processors.
  tbb::task_arena usual(threads_, 1, tbb::task_arena::priority::low);
  tbb::task_arena urgent(background_ ? threads_ : tbb::info::default_concurrency());
  for (;;) {
    SceneJob job;
    std::uint64_t ticket = 0;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stopping_ || dropping_ || next_; });
      if (stopping_) return;
      if (std::exchange(dropping_, false)) {
        lock.unlock();
        dropSource();
        continue;
      }
      job = *std::exchange(next_, std::nullopt);
      ticket = ticket_;
    }
    tbb::task_arena& arena = job.isUrgent ? urgent : usual;
    BuiltScene built = arena.execute([&] {
      findSource();
      return build(job, ticket);
    });
    {
      const std::lock_guard lock(mutex_);
      if (ticket_ != ticket) continue;
      done_ = std::move(built);
    }
    whenDone_();
  }
}

/// The parts that scenes share are computed with the first scene, so that no other caller waits for them.
void SceneBuilder::findSource() {
  if (source_) return;
  auto source = SceneSource::make(*patient_.ct, *patient_.labels);
  if (!source) {
    sourceError_ = source.error().message;
    return;
  }
  {
    const std::lock_guard lock(mutex_);
    source_ = std::move(*source);
    if (workAhead_ && !stopping_) ahead_ = std::make_unique<ScenesAhead>(source_);
  }
  whenDone_();
}

std::shared_ptr<const SceneSource> SceneBuilder::source() {
  const std::lock_guard lock(mutex_);
  return source_;
}

void SceneBuilder::dropSource() {
  std::unique_ptr<ScenesAhead> ahead;
  {
    const std::lock_guard lock(mutex_);
    ahead = std::move(ahead_);
    source_ = nullptr;
  }
  ahead = nullptr;
}

BuiltScene SceneBuilder::build(const SceneJob& job, std::uint64_t ticket) const {
  if (!source_) return {.job = job, .scene = {}, .warnings = {}, .error = sourceError_};
  return buildScene(*source_, job, [&](std::string_view, double) { return ticket_ == ticket; });
}

}  // namespace insonate::live
