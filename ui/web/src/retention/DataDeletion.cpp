#include "retention/DataDeletion.h"

#include "monitoring/FailureLog.h"
#include "video/VideoFiles.h"

#include <chrono>
#include <string>

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
    const bool isDone = removeNew();
    std::unique_lock lock(mutex_);
    if (wake_.wait_for(lock, isDone ? 10s : 60s, [this] { return isEnding_; })) return;
  }
}

/// Returns whether all files are deleted. A file that stays must not keep the others.
bool DataDeletion::removeNew() {
  const bool isApplied = remove(retention_.applyDaily());
  return remove(attempts_.removeRecordings()) && isApplied;
}

bool DataDeletion::remove(const Result<FilesToDelete>& files) const {
  const VideoFiles videos(options_.videos);
  Result<void> done = files ? files->recordings : Result<void>(tl::unexpected(files.error()));
  if (files && videos.isUsed())
    for (const std::string& attempt : files->attempts)
      if (auto removed = videos.remove(attempt); !removed && done) done = removed;
  if (!done) logFailure(options_.log, "deletion failed", done.error().message);
  return done.has_value();
}

}  // namespace insonate::web
