#include "live/SceneBuilder.h"

#include <insonate/core/ThreadPriority.h>

#include <tbb/task_arena.h>

#include <chrono>
#include <exception>
#include <utility>

namespace insonate::live {

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
  // Images have precedence: while one is computed, its arena gets the processors.
  tbb::task_arena arena(threads_, 1, tbb::task_arena::priority::low);
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
  source_ = std::move(*source);
  const std::lock_guard lock(mutex_);
  if (workAhead_ && !stopping_) ahead_ = std::make_unique<ScenesAhead>(source_);
}

void SceneBuilder::dropSource() {
  std::unique_ptr<ScenesAhead> ahead;
  {
    const std::lock_guard lock(mutex_);
    ahead = std::move(ahead_);
  }
  ahead = nullptr;
  source_ = nullptr;
}

BuiltScene SceneBuilder::build(const SceneJob& job, std::uint64_t ticket) const {
  BuiltScene built{.job = job, .scene = {}, .warnings = {}, .error = {}};
  const auto start = std::chrono::steady_clock::now();
  try {
    if (!source_) {
      built.error = sourceError_;
      return built;
    }
    auto scene =
        makeScene(*source_, *job.setup, job.region_mm, [&](std::string_view, double) { return ticket_ == ticket; });
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

}  // namespace insonate::live
