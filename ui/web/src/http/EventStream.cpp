#include "http/EventStream.h"

#include <microhttpd.h>

#include <algorithm>
#include <cstring>

namespace insonate::web {

void EventStream::push(const std::string& name, std::int64_t id) {
  const std::lock_guard lock(mutex_);
  if (isOver_ || hasEvent_) return;
  hasEvent_ = true;
  waiting_ += "id: " + std::to_string(id) + "\nevent: " + name + "\ndata:\n\n";
  resume();
}

void EventStream::keepAlive() {
  const std::lock_guard lock(mutex_);
  if (isOver_ || !waiting_.empty()) return;
  waiting_ = ":\n\n";
  resume();
}

void EventStream::end() {
  const std::lock_guard lock(mutex_);
  isOver_ = true;
  resume();
}

bool EventStream::isOver() const {
  const std::lock_guard lock(mutex_);
  return isOver_;
}

std::ptrdiff_t EventStream::read(MHD_Connection* connection, char* to, std::size_t max_bytes, std::ptrdiff_t over) {
  const std::lock_guard lock(mutex_);
  if (isOver_) return over;
  const std::size_t count = std::min(waiting_.size(), max_bytes);
  if (count == 0) {
    suspended_ = connection;
    MHD_suspend_connection(connection);
    return 0;
  }
  std::memcpy(to, waiting_.data(), count);
  waiting_.erase(0, count);
  if (waiting_.empty()) hasEvent_ = false;
  return static_cast<std::ptrdiff_t>(count);
}

void EventStream::detach() {
  const std::lock_guard lock(mutex_);
  isOver_ = true;
  suspended_ = nullptr;
}

void EventStream::resume() {
  if (suspended_) MHD_resume_connection(suspended_);
  suspended_ = nullptr;
}

}  // namespace insonate::web
