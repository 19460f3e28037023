#pragma once

#include <insonate/core/Result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

namespace insonate {

/// A file descriptor that is closed at the end.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int get() const { return number_; }
  bool isOpen() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// Wakes a thread that waits in poll() for get() to become readable.
class WakeUp {
 public:
  WakeUp();
  int get() const { return event_.get(); }
  void wake() const noexcept;
  void reset() const noexcept;

 private:
  Descriptor event_;
};

/// Opens a TCP port for connections to 127.0.0.1, or to any address of the computer. Port 0: a free port.
Result<Descriptor> listenOn(int port, bool anyAddress);
int portOf(const Descriptor& listening);
/// Accepts a connection; none if no program waits.
std::optional<Descriptor> acceptFrom(const Descriptor& listening);
/// Begins a connection to a host. Blocks while the name of the host is looked up, but not for the connection. A host
/// may have several addresses, e.g. of IPv6 and IPv4; consecutive values of `attempt` take one after the other.
Result<Descriptor> beginConnection(const std::string& host, int port, int attempt);
/// Sentence about the failure of a connection that was begun; empty if the connection has been made.
std::string connectionError(const Descriptor& connection, const std::string& host, int port);

/// Outcome of reading from or writing to a connection without waiting.
struct Transferred {
  std::size_t size = 0;  ///< bytes; 0 also if the call would have to wait
  bool closed = false;   ///< the connection is closed or broken
};
Transferred receiveFrom(const Descriptor& connection, std::span<std::uint8_t> buffer);
Transferred sendTo(const Descriptor& connection, std::span<const std::uint8_t> bytes);

}  // namespace insonate
