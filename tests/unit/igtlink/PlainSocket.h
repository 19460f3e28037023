#pragma once

#include "LinkBytes.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>

namespace insonate::test {

/// Waits until `done` is true, at most 20 seconds.
inline bool waitUntil(const std::function<bool()>& done) {
  for (int i = 0; i < 20'000; ++i) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return done();
}

/// A message as its bytes say, read without the module.
struct PlainMessage {
  int version = 0;
  std::string type, device;
  Bytes body;
  bool crcFits = false;

  float real(std::size_t at) const {
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < 4; ++i) bits = (bits << 8) | body.at(at + i);
    return std::bit_cast<float>(bits);
  }
  std::string text() const { return {body.begin() + 4, body.end()}; }
};

/// A blocking TCP socket without the module.
class PlainSocket {
 public:
  explicit PlainSocket(int number) : number_(number) {}
  PlainSocket(PlainSocket&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  ~PlainSocket() { reset(); }
  void reset() {
    if (number_ >= 0) close(std::exchange(number_, -1));
  }

  static PlainSocket connectedTo(int port, const char* address = "127.0.0.1", int receiveBuffer = 0) {
    PlainSocket made(socket(AF_INET, SOCK_STREAM, 0));
    if (receiveBuffer > 0) setsockopt(made.number_, SOL_SOCKET, SO_RCVBUF, &receiveBuffer, sizeof receiveBuffer);
    const sockaddr_in to = addressOf(port, address);
    if (connect(made.number_, reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0) made.reset();
    return made;
  }
  /// Listens on a port of this computer; 0: a free port.
  static PlainSocket listening(int port = 0) {
    PlainSocket made(socket(AF_INET, SOCK_STREAM, 0));
    const int on = 1;
    setsockopt(made.number_, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    const sockaddr_in at = addressOf(port, "127.0.0.1");
    if (bind(made.number_, reinterpret_cast<const sockaddr*>(&at), sizeof at) != 0 || listen(made.number_, 4) != 0)
      made.reset();
    return made;
  }
  PlainSocket accepted() const { return PlainSocket(isReady() ? accept(number_, nullptr, nullptr) : -1); }
  int port() const {
    sockaddr_in at{};
    socklen_t size = sizeof at;
    getsockname(number_, reinterpret_cast<sockaddr*>(&at), &size);
    return ntohs(at.sin_port);
  }
  bool isOpen() const { return number_ >= 0; }

  bool write(std::span<const std::uint8_t> bytes) const {
    while (!bytes.empty()) {
      const ssize_t size = send(number_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
      if (size <= 0) return false;
      bytes = bytes.subspan(static_cast<std::size_t>(size));
    }
    return true;
  }
  /// Reads `size` bytes; empty if the connection ends before, or is silent for 20 seconds.
  std::optional<Bytes> read(std::size_t size) const {
    Bytes bytes(size);
    for (std::size_t have = 0; have < size;) {
      const ssize_t got = isReady() ? recv(number_, bytes.data() + have, size - have, 0) : 0;
      if (got <= 0) return std::nullopt;
      have += static_cast<std::size_t>(got);
    }
    return bytes;
  }
  std::optional<PlainMessage> readMessage() const {
    const auto head = read(58);
    if (!head) return std::nullopt;
    const auto number = [&](std::size_t at, std::size_t size) {
      std::uint64_t value = 0;
      for (std::size_t i = 0; i < size; ++i) value = (value << 8) | (*head)[at + i];
      return value;
    };
    const auto text = [&](std::size_t at, std::size_t size) {
      const auto begin = head->begin() + static_cast<std::ptrdiff_t>(at);
      return std::string(begin, std::find(begin, begin + static_cast<std::ptrdiff_t>(size), 0));
    };
    const auto body = read(number(42, 8));
    if (!body) return std::nullopt;
    return PlainMessage{static_cast<int>(number(0, 2)), text(2, 12), text(14, 20), *body,
                        slowCrc(*body) == number(50, 8)};
  }
  /// Reads until a message of this type.
  std::optional<PlainMessage> readMessage(std::string_view type) const {
    auto message = readMessage();
    while (message && message->type != type) message = readMessage();
    return message;
  }

 private:
  static sockaddr_in addressOf(int port, const char* address) {
    sockaddr_in made{};
    made.sin_family = AF_INET;
    made.sin_port = htons(static_cast<std::uint16_t>(port));
    inet_pton(AF_INET, address, &made.sin_addr);
    return made;
  }
  bool isReady() const {
    pollfd waiting{number_, POLLIN, 0};
    return poll(&waiting, 1, 20'000) == 1;
  }

  int number_;
};

}  // namespace insonate::test
