#pragma once

#include <insonate/curriculum/AuditAnchors.h>
#include <insonate/web/WebServer.h>

#include <condition_variable>
#include <mutex>
#include <thread>

namespace insonate::web {

/// Appends the end of the audit log to a file each minute, and at its destruction, on a thread of its own.
class AnchorKeeper {
 public:
  /// `log`: receives failures; may be empty.
  AnchorKeeper(AuditAnchors anchors, Log log);
  ~AnchorKeeper();
  AnchorKeeper(const AnchorKeeper&) = delete;
  AnchorKeeper& operator=(const AnchorKeeper&) = delete;

 private:
  void run();

  AuditAnchors anchors_;
  Log log_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool isEnding_ = false;
  std::thread thread_;
};

}  // namespace insonate::web
