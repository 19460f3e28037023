#include "retention/DataDeletion.h"

#include "monitoring/FailureLog.h"
#include "video/VideoFiles.h"

#include <chrono>

namespace insonate::web {

using namespace std::chrono_literals;

DataDeletion::DataDeletion(const CurriculumStore& store, const WebOptions& options)
    : options_(options), retention_(store), attempts_(store), thread_([this] { run(); }) {}

DataDeletion::~DataDeletion() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void DataDeletion::run() {
  for (;;) {
    const auto removed = removeNew();
    if (!removed) logFailure(options_.log, "deletion failed", removed.error().message);
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, removed ? 10s : 60s, [this] { return isEnding_; })) return;
  }
}

Result<void> DataDeletion::removeNew() {
  if (auto removed = removeVideos(retention_.applyDaily()); !removed) return removed;
  return removeVideos(attempts_.removeRecordings());
}

Result<void> DataDeletion::removeVideos(const Result<std::vector<std::string>>& attempts) const {
  if (!attempts) return tl::unexpected(attempts.error());
  const VideoFiles videos(options_.videos);
  Result<void> done;
  for (const std::string& attempt : *attempts)
    if (videos.isUsed())
      if (auto removed = videos.remove(attempt); !removed) done = removed;
  return done;
}

}  // namespace insonate::web
