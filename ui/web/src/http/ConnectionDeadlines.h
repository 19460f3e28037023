#pragma once

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace insonate::web {

/// Ends connections that miss their deadlines, so that a client which sends or takes one byte every few seconds does
/// not keep its connection: libmicrohttpd limits only the time without any byte. For any thread.
class ConnectionDeadlines {
 public:
  using Time = std::chrono::milliseconds;

  ConnectionDeadlines();
  ~ConnectionDeadlines();
  ConnectionDeadlines(const ConnectionDeadlines&) = delete;
  ConnectionDeadlines& operator=(const ConnectionDeadlines&) = delete;

  /// Adds a connection, whose socket must stay open until remove().
  void add(int socket, Time within);
  /// Gives a connection another deadline, or none. Ignores connections that are not there.
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
