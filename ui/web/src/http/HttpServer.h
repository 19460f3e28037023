#pragma once

#include "http/Messages.h"

#include <insonate/core/Result.h>
#include <insonate/web/WebServer.h>

#include <chrono>
#include <functional>
#include <memory>
#include <optional>

namespace insonate::web {

/// Limits by which a server protects itself against slow clients and against too many clients.
struct HttpLimits {
  std::chrono::milliseconds request{30'000};  ///< time for receiving a whole request, since the connection or the
                                              ///< previous answer
  std::chrono::milliseconds answer{120'000};  ///< time in which a client must receive a whole answer
  unsigned idle_s = 30;                       ///< time without a byte in either direction after which a connection
                                              ///< ends
  unsigned connections = 1000, connectionsOfOneAddress = 200;  ///< maximum number of connections, in total and from
                                                               ///< one address (IPv6: from one network, networkOf());
                                                               ///< behind a proxy, all connections have one address
};

/// Accepts HTTP or HTTPS connections and answers each request by `answer`, on a few worker threads. One thread waits
/// for all connections (epoll), so that a slow client occupies no worker. Bodies above kLargestBody_bytes are refused;
/// for class lists and curricula, the limit is kLargestBodyOfList_bytes, and for workstations
/// kLargestBodyOfWorkstation_bytes. Before such a larger body is received, `admit` checks who sends it, so that an
/// unknown client cannot fill the memory.
class HttpServer {
 public:
  using Answer = std::function<Response(const Request&)>;
  /// Function that receives a request without its body, and returns the refusal if the sender of a larger body is
  /// unknown. The server then receives the body without keeping it, and sends the refusal.
  using Admit = std::function<std::optional<Response>(const Request&)>;
  /// Function that receives the status of each request that was refused before it reached `answer`: the request was too
  /// large or ambiguous, or there were too many requests.
  using Refused = std::function<void(int status)>;
  static constexpr std::size_t kLargestBody_bytes = 64 << 10, kLargestBodyOfList_bytes = 256 << 10,
                               kLargestBodyOfWorkstation_bytes = 4 << 20;

  /// Starts to listen. Fails if the address is in use or if certificate and key cannot be used. The functions are
  /// called on several threads at the same time and must not throw. `refused` may be empty. If `admit` is empty, larger
  /// bodies are refused.
  static Result<std::unique_ptr<HttpServer>> start(const WebOptions& options, Answer answer,
                                                   const HttpLimits& limits = {}, Refused refused = {},
                                                   Admit admit = {});
  /// Finishes the requests in progress, answers waiting requests with status 503, then stops.
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
