#include "Sockets.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <memory>
#include <system_error>

namespace insonate {
namespace {

constexpr int kBacklog = 64;
/// The kernel keeps at most about half an image for a slow client, so that an image that arrives is not old.
constexpr int kSendBuffer = 256 * 1024;
/// A connection whose other end does not confirm data for this time is closed, e.g. after a cable was pulled.
constexpr unsigned kUnconfirmed_ms = 20'000;

std::string reasonOf(int error) {
  return std::generic_category().message(error);
}

template <class Value>
void setOption(const Descriptor& connection, int level, int name, Value value) {
  setsockopt(connection.get(), level, name, &value, sizeof value);
}

void prepareConnection(const Descriptor& connection) {
  setOption(connection, IPPROTO_TCP, TCP_NODELAY, 1);
  setOption(connection, SOL_SOCKET, SO_KEEPALIVE, 1);
  setOption(connection, IPPROTO_TCP, TCP_KEEPIDLE, 10);
  setOption(connection, IPPROTO_TCP, TCP_KEEPINTVL, 5);
  setOption(connection, IPPROTO_TCP, TCP_USER_TIMEOUT, kUnconfirmed_ms);
}

bool mustWait(int error) {
  return error == EAGAIN || error == EINTR;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) close(number_);
}

WakeUp::WakeUp() : event_(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

void WakeUp::wake() const noexcept {
  [[maybe_unused]] const int done = eventfd_write(event_.get(), 1);
}

void WakeUp::reset() const noexcept {
  eventfd_t count = 0;
  [[maybe_unused]] const int done = eventfd_read(event_.get(), &count);
}

Result<Descriptor> listenOn(int port, bool anyAddress) {
  Descriptor listening(socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!listening.isOpen()) return fail("No network port can be opened: " + reasonOf(errno) + ".");
  // A server that is restarted gets its port although old connections are still being closed.
  setOption(listening, SOL_SOCKET, SO_REUSEADDR, 1);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(anyAddress ? INADDR_ANY : INADDR_LOOPBACK);
  if (bind(listening.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      listen(listening.get(), kBacklog) != 0) {
    const std::string name = "The port " + std::to_string(port);
    if (errno == EADDRINUSE) return fail(name + " is used by another program. Choose another port.");
    if (errno == EACCES) return fail(name + " is reserved by the system. Choose a port above 1023.");
    return fail(name + " cannot be opened: " + reasonOf(errno) + ".");
  }
  return listening;
}

int portOf(const Descriptor& listening) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  getsockname(listening.get(), reinterpret_cast<sockaddr*>(&address), &size);
  return ntohs(address.sin_port);
}

std::optional<Descriptor> acceptFrom(const Descriptor& listening) {
  Descriptor connection(accept4(listening.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
  if (!connection.isOpen()) return std::nullopt;
  prepareConnection(connection);
  setOption(connection, SOL_SOCKET, SO_SNDBUF, kSendBuffer);
  return connection;
}

Result<Descriptor> beginConnection(const std::string& host, int port, int attempt) {
  addrinfo wanted{};
  wanted.ai_family = AF_UNSPEC;
  wanted.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  const int problem = getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &list);
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> found(list, freeaddrinfo);
  if (problem != 0 || !found) return fail("The computer '" + host + "' is not known. Check its name or address.");
  int count = 0;
  for (const addrinfo* one = found.get(); one; one = one->ai_next) ++count;
  const addrinfo* address = found.get();
  for (int skipped = attempt % count; skipped > 0; --skipped) address = address->ai_next;
  Descriptor connection(socket(address->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!connection.isOpen()) return fail("No connection can be opened: " + reasonOf(errno) + ".");
  prepareConnection(connection);
  if (connect(connection.get(), address->ai_addr, address->ai_addrlen) != 0 && errno != EINPROGRESS)
    return fail(host + " cannot be reached: " + reasonOf(errno) + ".");
  return connection;
}

std::string connectionError(const Descriptor& connection, const std::string& host, int port) {
  int error = 0;
  socklen_t size = sizeof error;
  getsockopt(connection.get(), SOL_SOCKET, SO_ERROR, &error, &size);
  if (error == 0) return {};
  if (error == ECONNREFUSED)
    return "No program accepts connections at " + host + ":" + std::to_string(port) +
           ". Start the tracker's server there, or check the port.";
  return host + " cannot be reached: " + reasonOf(error) + ".";
}

Transferred receiveFrom(const Descriptor& connection, std::span<std::uint8_t> buffer) {
  const ssize_t size = recv(connection.get(), buffer.data(), buffer.size(), MSG_DONTWAIT);
  if (size > 0) return {static_cast<std::size_t>(size), false};
  return {0, size == 0 || !mustWait(errno)};
}

Transferred sendTo(const Descriptor& connection, std::span<const std::uint8_t> bytes) {
  const ssize_t size = send(connection.get(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (size >= 0) return {static_cast<std::size_t>(size), false};
  return {0, !mustWait(errno)};
}

}  // namespace insonate
