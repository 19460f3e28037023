#pragma once

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/web/WebServer.h>

#include <stop_token>
#include <thread>

namespace insonate::web {

/// Appends the end of the audit log to a file each minute, and at its destruction, on a thread of its own.
class AnchorKeeper {
 public:
  /// `log`: receives failures; may be empty.
  AnchorKeeper(AuditAnchors anchors, Log log);
  AnchorKeeper(const AnchorKeeper&) = delete;
  AnchorKeeper& operator=(const AnchorKeeper&) = delete;

 private:
  void run(const std::stop_token& stop);

  AuditAnchors anchors_;
  Log log_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate::web
