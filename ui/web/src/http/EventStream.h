#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

struct MHD_Connection;

namespace insonate::web {

/// Messages to one browser over a connection that stays open (server-sent events, HTML standard). While there is
/// nothing to send, the connection is suspended and costs no thread. Made by the page that answers a request; then one
/// thread pushes messages while the server's thread sends them.
class EventStream {
 public:
  /// Sends an event with this name and id, unless an earlier one still waits for a slow browser. A browser that
  /// connects again sends the id of the last event.
  void push(const std::string& name, std::int64_t id);
  /// Sends a line without meaning, which keeps proxies from closing the connection.
  void keepAlive();
  /// Ends the answer; the browser then connects again.
  void end();
  /// Tells whether the browser has closed the connection, or the stream was ended.
  bool isOver() const;

  /// For HttpServer: copies what is to be sent, at most `max_bytes`. Suspends the connection and returns 0 if there is
  /// nothing; returns `over` at the end.
  std::ptrdiff_t read(MHD_Connection* connection, char* to, std::size_t max_bytes, std::ptrdiff_t over);
  /// For HttpServer: the connection does not exist any more.
  void detach();

 private:
  mutable std::mutex mutex_;
  std::string waiting_ = "retry: 5000\n\n";  ///< a browser that lost the connection tries again after 5 s
  bool hasEvent_ = false;                    ///< an event is in waiting_
  MHD_Connection* suspended_ = nullptr;
  bool isOver_ = false;

  void resume();
};

}  // namespace insonate::web
