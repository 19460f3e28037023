#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace insonate::web {

/// Ends connections that miss their deadlines. A client that sends or receives one byte every few seconds therefore
/// cannot keep its connection; libmicrohttpd limits only the time without any byte. May be used on any thread.
class ConnectionDeadlines {
 public:
  using Time = std::chrono::milliseconds;

  ConnectionDeadlines();
  ~ConnectionDeadlines();
  ConnectionDeadlines(const ConnectionDeadlines&) = delete;
  ConnectionDeadlines& operator=(const ConnectionDeadlines&) = delete;

  /// Adds a connection, whose socket must stay open until remove().
  void add(int socket, Time within);
  /// Changes the deadline of a connection, or removes it. Ignores unknown connections.
  void set(int socket, std::optional<Time> within);
  void remove(int socket);

 private:
  using Clock = std::chrono::steady_clock;
  void watch();

  std::mutex mutex_;
  std::condition_variable wake_;
  std::map<int, std::optional<Clock::time_point>> deadlines_;
  bool isStopping_ = false;
  std::thread watcher_;
};

}  // namespace insonate::web
