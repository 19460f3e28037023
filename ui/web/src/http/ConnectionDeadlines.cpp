#include "http/ConnectionDeadlines.h"

#include <sys/socket.h>

namespace insonate::web {
namespace {

constexpr std::chrono::milliseconds kLook{100};

}  // namespace

ConnectionDeadlines::ConnectionDeadlines() : watcher_([this] { watch(); }) {}

ConnectionDeadlines::~ConnectionDeadlines() {
  {
    const std::lock_guard lock(mutex_);
    isStopping_ = true;
  }
  wake_.notify_all();
  watcher_.join();
}

void ConnectionDeadlines::add(int socket, Time within) {
  const std::lock_guard lock(mutex_);
  deadlines_[socket] = Clock::now() + within;
}

void ConnectionDeadlines::set(int socket, std::optional<Time> within) {
  const std::lock_guard lock(mutex_);
  const auto found = deadlines_.find(socket);
  if (found != deadlines_.end()) found->second = within ? std::optional(Clock::now() + *within) : std::nullopt;
}

void ConnectionDeadlines::remove(int socket) {
  const std::lock_guard lock(mutex_);
  deadlines_.erase(socket);
}

void ConnectionDeadlines::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kLook, [this] { return isStopping_; }))
    for (auto& [socket, deadline] : deadlines_) {
      if (!deadline || *deadline > Clock::now()) continue;
      // The library sees the end of the connection and closes the socket; closing it here could hit another one.
      ::shutdown(socket, SHUT_RDWR);
      deadline.reset();
    }
}

}  // namespace insonate::web
