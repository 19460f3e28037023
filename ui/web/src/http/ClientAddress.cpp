#include "http/ClientAddress.h"

#include "http/SocketAddress.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace insonate::web {
namespace {

bool isProxy(const std::string& address, const WebOptions& options) {
  return std::ranges::any_of(options.proxies,
                             [&](const std::string& proxy) { return canonicalAddress(proxy) == address; });
}

std::string_view withoutSpaces(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

std::string clientAddress(const Request& request, const WebOptions& options) {
  if (options.proxies.empty()) return options.behindProxy ? "" : request.client;
  if (!isProxy(request.client, options)) return request.client;
  std::string_view chain = valueOf(request.headers, "x-forwarded-for");
  while (!chain.empty()) {
    const std::size_t comma = chain.rfind(',');
    std::string last =
        canonicalAddress(std::string(withoutSpaces(comma == std::string_view::npos ? chain : chain.substr(comma + 1))));
    chain = comma == std::string_view::npos ? std::string_view() : chain.substr(0, comma);
    if (!isProxy(last, options)) return last;
  }
  return {};
}

std::string networkOf(const std::string& address) {
  std::array<unsigned char, 16> bytes{};
  std::string text = canonicalAddress(address);
  if (inet_pton(AF_INET6, text.c_str(), bytes.data()) != 1) return text;
  std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
  std::array<char, INET6_ADDRSTRLEN> network{};
  return inet_ntop(AF_INET6, bytes.data(), network.data(), network.size());
}

bool isFromHere(const Request& request) {
  for (const char* name : {"x-forwarded-for", "x-real-ip", "forwarded", "via"})
    if (request.headers.contains(name)) return false;
  // A proxy without these headers passes the name on by which the browser knows the server.
  const std::string& host = valueOf(request.headers, "host");
  const bool isVersion6 = host.starts_with('[');
  const std::string name = isVersion6 ? host.substr(1, host.find(']') - 1) : host.substr(0, host.rfind(':'));
  return isLoopbackAddress(request.client) && (name == "localhost" || isLoopbackAddress(name));
}

}  // namespace insonate::web
