#pragma once

#include "http/SocketAddress.h"

#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <string>

namespace insonate::web {

/// A connection of a client that sends what no browser would.
class RawClient {
 public:
  explicit RawClient(int port, const std::string& at = "127.0.0.1") {
    const sockaddr_storage address = socketAddress(at, port);
    socket_ = ::socket(address.ss_family, SOCK_STREAM, 0);
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
    timeval patience{20, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  }
  ~RawClient() { ::close(socket_); }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;

  bool connected() const { return connected_; }
  void send(const std::string& bytes) { (void)!::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL); }
  /// Everything until the server closes the connection.
  std::string receive() {
    std::string all;
    char part[4096];
    ssize_t count = 0;
    while ((count = ::recv(socket_, part, sizeof part, 0)) > 0) all.append(part, std::size_t(count));
    isEnded_ = count == 0 || errno == ECONNRESET;
    return all;
  }
  /// Returns what arrives until `text` has arrived, or until the server closes the connection.
  std::string receiveUntil(const std::string& text) {
    std::string all;
    char part[4096];
    ssize_t count = 0;
    while (all.find(text) == std::string::npos && (count = ::recv(socket_, part, sizeof part, 0)) > 0)
      all.append(part, std::size_t(count));
    return all;
  }
  /// The server closed the connection; otherwise receive() lost its patience.
  bool isEnded() const { return isEnded_; }
  std::string ask(const std::string& bytes) {
    send(bytes);
    return receive();
  }

 private:
  int socket_ = -1;
  bool connected_ = false, isEnded_ = false;
};

}  // namespace insonate::web
