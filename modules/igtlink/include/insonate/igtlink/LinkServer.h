#pragma once

#include <insonate/core/Result.h>
#include <insonate/igtlink/LinkCommand.h>
#include <insonate/igtlink/LinkMessage.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace insonate {

/// Port that 3D Slicer and PLUS use unless the user names another.
inline constexpr int kLinkPort = 18944;

/// One image with the transforms at the same time.
struct LinkFrame {
  LinkImage image;
  std::vector<LinkTransform> transforms;
  std::int64_t time_ns = 0;  ///< ns since the beginning of 1970
};

struct LinkServerOptions {
  int port = kLinkPort;     ///< TCP port; 0: a free port
  bool anyAddress = false;  ///< true: accepts programs of other computers; false: of this computer only
};

/// State of a server, and its numbers since the start.
struct LinkServerStatus {
  int clients = 0;             ///< programs that are connected
  std::uint64_t posted = 0;    ///< calls of post()
  std::uint64_t sent = 0;      ///< frames that were sent completely, counted for each client
  std::uint64_t commands = 0;  ///< commands received
  std::string lastError;       ///< why a client was disconnected; empty: never
};

/// Sends images and transforms to other programs by OpenIGTLink, and takes their commands. Each client receives the
/// latest frame as soon as it has taken the previous one completely: a slow client misses frames, and neither delays
/// post() nor other clients. All messages have headers of version 1. At most kMaxClients clients are accepted.
///
/// One thread serves all clients. All functions may be called from any thread.
class LinkServer {
 public:
  static constexpr int kMaxClients = 8;
  /// Maximum number of commands of one client without a reply. The server reads no more of a client until then.
  static constexpr int kMaxOpenCommands = 32;

  /// Sends the reply to a command; may be called once, from any thread, also after the server was destroyed.
  using Answer = std::function<void(const LinkReply&)>;
  /// Receives commands on the server's thread, and must return quickly.
  using CommandHandler = std::function<void(const LinkCommand&, const Answer&)>;

  /// Opens the port. Fails with a sentence. Without a handler, each command fails.
  static Result<std::unique_ptr<LinkServer>> start(const LinkServerOptions& options, CommandHandler handler = {});
  /// Disconnects all clients.
  ~LinkServer();
  LinkServer(const LinkServer&) = delete;
  LinkServer& operator=(const LinkServer&) = delete;

  /// Sets the latest frame. The frame must not change any more. Never waits for a client.
  void post(std::shared_ptr<const LinkFrame> frame);
  int port() const;
  LinkServerStatus status() const;

 private:
  class Impl;
  explicit LinkServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate
