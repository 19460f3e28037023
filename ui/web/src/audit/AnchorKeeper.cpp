#include "audit/AnchorKeeper.h"

#include "monitoring/FailureLog.h"

#include <chrono>
#include <utility>

namespace insonate::web {

AnchorKeeper::AnchorKeeper(AuditAnchors anchors, Log log)
    : anchors_(std::move(anchors)), log_(std::move(log)), thread_([this] { run(); }) {}

AnchorKeeper::~AnchorKeeper() {
  {
    const std::lock_guard lock(mutex_);
    isEnding_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void AnchorKeeper::run() {
  constexpr std::chrono::minutes kInterval(1);
  for (bool isLast = false;;) {
    if (const auto done = anchors_.append(); !done) logFailure(log_, "audit anchor failed", done.error().message);
    if (isLast) return;
    std::unique_lock lock(mutex_);
    isLast = wake_.wait_for(lock, kInterval, [this] { return isEnding_; });
  }
}

}  // namespace insonate::web
