#include "audit/AnchorKeeper.h"

#include "background/Pause.h"
#include "monitoring/FailureLog.h"

#include <chrono>
#include <utility>

namespace insonate::web {

AnchorKeeper::AnchorKeeper(AuditAnchors anchors, Log log)
    : anchors_(std::move(anchors)), log_(std::move(log)), thread_([this](const std::stop_token& stop) { run(stop); }) {}

void AnchorKeeper::run(const std::stop_token& stop) {
  constexpr std::chrono::minutes kInterval(1);
  const auto append = [this] {
    if (const auto done = anchors_.append(); !done) logFailure(log_, "audit anchor failed", done.error().message);
  };
  append();
  while (pauseUnlessStopped(stop, kInterval)) append();
  append();
}

}  // namespace insonate::web
