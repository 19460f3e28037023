#include "people/ErasedFiles.h"

#include "video/VideoFiles.h"

#include <nlohmann/json.hpp>

#include <chrono>

namespace insonate::web {

using namespace std::chrono_literals;

ErasedFiles::ErasedFiles(const CurriculumStore& store, const WebOptions& options)
    : options_(options), attempts_(store), thread_([this] { run(); }) {}

ErasedFiles::~ErasedFiles() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void ErasedFiles::run() {
  for (;;) {
    const auto removed = removeNew();
    if (!removed && options_.log)
      options_.log(LogLevel::Error,
                   nlohmann::ordered_json{{"event", "erasure failed"}, {"message", removed.error().message}}.dump(
                       -1, ' ', false, nlohmann::json::error_handler_t::replace));
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, removed ? 10s : 60s, [this] { return isEnding_; })) return;
  }
}

Result<void> ErasedFiles::removeNew() {
  const auto attempts = attempts_.removeRecordings();
  if (!attempts) return tl::unexpected(attempts.error());
  const VideoFiles videos(options_.videos);
  Result<void> done;
  for (const std::string& attempt : *attempts)
    if (videos.isUsed())
      if (auto removed = videos.remove(attempt); !removed) done = removed;
  return done;
}

}  // namespace insonate::web
