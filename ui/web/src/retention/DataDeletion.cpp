#include "retention/DataDeletion.h"

#include "background/Pause.h"
#include "monitoring/FailureLog.h"
#include "video/VideoFiles.h"

#include <chrono>
#include <string>

namespace insonate::web {

using namespace std::chrono_literals;

DataDeletion::DataDeletion(const CurriculumStore& store, const WebOptions& options)
    : options_(options),
      retention_(store),
      attempts_(store),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

void DataDeletion::run(const std::stop_token& stop) {
  while (pauseUnlessStopped(stop, removeNew() ? 10s : 60s)) {
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
