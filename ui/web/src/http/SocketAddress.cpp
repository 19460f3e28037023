#include "http/SocketAddress.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>

#include <array>
#include <cstring>
#include <memory>
#include <optional>

namespace insonate::web {
namespace {

std::string textOf(const in_addr& address) {
  std::array<char, INET_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET, &address, text.data(), text.size()) ? text.data() : "";
}

std::string textOf(const in6_addr& address) {
  if (IN6_IS_ADDR_V4MAPPED(&address)) {
    in_addr inner{};
    std::memcpy(&inner, address.s6_addr + 12, sizeof inner);
    return textOf(inner);
  }
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET6, &address, text.data(), text.size()) ? text.data() : "";
}

}  // namespace

std::string canonicalAddress(const std::string& text) {
  in_addr four{};
  if (inet_pton(AF_INET, text.c_str(), &four) == 1) return textOf(four);
  in6_addr six{};
  return inet_pton(AF_INET6, text.c_str(), &six) == 1 ? textOf(six) : "";
}

bool isAddress(const std::string& text) {
  return !canonicalAddress(text).empty();
}

bool isLoopbackAddress(const std::string& text) {
  const std::string address = canonicalAddress(text);
  return address.starts_with("127.") || address == "::1";
}

std::string textOf(const sockaddr& address) {
  if (address.sa_family == AF_INET) return textOf(reinterpret_cast<const sockaddr_in&>(address).sin_addr);
  if (address.sa_family == AF_INET6) return textOf(reinterpret_cast<const sockaddr_in6&>(address).sin6_addr);
  return {};
}

Result<std::string> resolvedAddress(const std::string& addressOrName) {
  if (isAddress(addressOrName)) return canonicalAddress(addressOrName);
  addrinfo hints{};
  hints.ai_family = AF_UNSPEC;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  const bool isFound = getaddrinfo(addressOrName.c_str(), nullptr, &hints, &list) == 0;
  const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> owner(isFound ? list : nullptr, &freeaddrinfo);
  std::optional<std::string> found;
  for (const addrinfo* one = owner.get(); one; one = one->ai_next) {
    if (one->ai_family == AF_INET) return textOf(*one->ai_addr);
    if (one->ai_family == AF_INET6 && !found) found = textOf(*one->ai_addr);
  }
  if (found) return *found;
  return fail(
      "'" + addressOrName +
      "' is neither an IP address nor a known name; give an address of this computer, such as 127.0.0.1 or ::1.");
}

sockaddr_storage socketAddress(const std::string& address, int port) {
  sockaddr_storage storage{};
  auto& four = reinterpret_cast<sockaddr_in&>(storage);
  auto& six = reinterpret_cast<sockaddr_in6&>(storage);
  if (inet_pton(AF_INET, address.c_str(), &four.sin_addr) == 1) {
    four.sin_family = AF_INET;
    four.sin_port = htons(static_cast<std::uint16_t>(port));
  } else if (inet_pton(AF_INET6, address.c_str(), &six.sin6_addr) == 1) {
    six.sin6_family = AF_INET6;
    six.sin6_port = htons(static_cast<std::uint16_t>(port));
  }
  return storage;
}

std::string withPort(const std::string& address, int port) {
  const bool isVersion6 = address.find(':') != std::string::npos;
  return (isVersion6 ? "[" + address + "]" : address) + ":" + std::to_string(port);
}

}  // namespace insonate::web
