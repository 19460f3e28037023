#pragma once

#include "http/Messages.h"

#include <insonate/core/Result.h>
#include <insonate/web/WebServer.h>

#include <chrono>
#include <functional>
#include <memory>

namespace insonate::web {

/// Times and numbers by which a server protects itself from slow and many clients.
struct HttpLimits {
  std::chrono::milliseconds request{30'000};  ///< for a whole request, from the connection or the answer before
  std::chrono::milliseconds answer{120'000};  ///< for taking a whole answer
  unsigned idle_s = 30;                       ///< without a byte in either direction
  unsigned connections = 1000, connectionsOfOneAddress = 200;  ///< behind a proxy, all have one address
};

/// Accepts HTTP or HTTPS connections and answers each request by `answer`, on a few worker threads: one thread waits
/// for all connections (epoll), so that a slow client holds no worker. Bodies above kLargestBody_bytes are refused,
/// class lists of signed-in users above kLargestBodyOfList_bytes, and bodies of workstations above
/// kLargestBodyOfWorkstation_bytes.
class HttpServer {
 public:
  using Answer = std::function<Response(const Request&)>;
  /// Takes the status of a request that was refused before it reached `answer`: too large, ambiguous, or too many.
  using Refused = std::function<void(int status)>;
  static constexpr std::size_t kLargestBody_bytes = 64 << 10, kLargestBodyOfList_bytes = 256 << 10,
                               kLargestBodyOfWorkstation_bytes = 4 << 20;

  /// Starts to listen. Fails if the address is in use or if certificate and key cannot be used. `answer` is called on
  /// several threads at the same time and must not throw; so is `refused`, which may be empty.
  static Result<std::unique_ptr<HttpServer>> start(const WebOptions& options, Answer answer,
                                                   const HttpLimits& limits = {}, Refused refused = {});
  /// Finishes the requests in progress, answers those that wait with status 503, then stops.
  ~HttpServer();
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  /// Returns the port at which the server listens.
  int port() const;

 private:
  struct Impl;
  explicit HttpServer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace insonate::web
