#pragma once

#include <insonate/core/Transform.h>
#include <insonate/igtlink/LinkParser.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

enum class LinkPhase {
  kConnecting,  ///< no connection yet, or none again; the client tries once a second
  kConnected,
};

/// Measured pose of a tracker's tool.
struct LinkToolPose {
  std::string name;           ///< e.g. "ProbeToTracker"
  Transform trackerFromTool;  ///< rigid, mm
  std::int64_t time_ns = 0;   ///< time of the measurement, CLOCK_MONOTONIC
};

/// A tool of which a pose has been received.
struct LinkToolStatus {
  std::string name;
  double rate_Hz = 0;    ///< poses in the last second
  double quality = 0;    ///< rate relative to the tool's highest rate on this connection, 0 to 1
  double silent_ms = 0;  ///< time since the last pose
};

struct LinkClientStatus {
  LinkPhase phase = LinkPhase::kConnecting;
  std::string error;                  ///< sentence that says why there is no connection; empty while connected
  int connections = 0;                ///< number of connections so far
  LinkCounters counters;              ///< messages on the present connection
  std::vector<LinkToolStatus> tools;  ///< tools on the present connection, in the order of their first poses
};

/// Receives the poses of tools from a tracking program, e.g. PLUS, by OpenIGTLink: messages TRANSFORM, TDATA, QTDATA
/// and POSITION with headers of version 1 to 3. Connects, and connects again when the connection is lost. The client's
/// own thread does all work. Every function may be called from any thread.
class LinkClient {
 public:
  /// Receives the poses of one message, on the client's thread; `error`: LinkClientStatus::error. Also called without
  /// poses, ten times a second, so that the listener notices when poses stop. Must return quickly.
  using Listener = std::function<void(const std::vector<LinkToolPose>& poses, const std::string& error)>;

  /// Starts to connect to a host (name or address).
  LinkClient(std::string host, int port, Listener listener);
  /// Disconnects. May wait while the name of the host is looked up.
  ~LinkClient();
  LinkClient(const LinkClient&) = delete;
  LinkClient& operator=(const LinkClient&) = delete;

  LinkClientStatus status() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
