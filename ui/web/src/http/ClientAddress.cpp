#include "http/ClientAddress.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace insonate::web {
namespace {

bool isProxy(const std::string& address, const WebOptions& options) {
  return std::ranges::find(options.proxies, address) != options.proxies.end();
}

std::string_view withoutSpaces(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
  return text;
}

}  // namespace

bool isAddress(const std::string& text) {
  std::array<unsigned char, 16> bytes{};
  return inet_pton(AF_INET, text.c_str(), bytes.data()) == 1 || inet_pton(AF_INET6, text.c_str(), bytes.data()) == 1;
}

std::string clientAddress(const Request& request, const WebOptions& options) {
  if (options.proxies.empty()) return options.behindProxy ? "" : request.client;
  if (!isProxy(request.client, options)) return request.client;
  std::string_view chain = valueOf(request.headers, "x-forwarded-for");
  while (!chain.empty()) {
    const std::size_t comma = chain.rfind(',');
    const std::string last(withoutSpaces(comma == std::string_view::npos ? chain : chain.substr(comma + 1)));
    chain = comma == std::string_view::npos ? std::string_view() : chain.substr(0, comma);
    if (isProxy(last, options)) continue;
    return isAddress(last) ? last : "";
  }
  return {};
}

std::string networkOf(const std::string& address) {
  std::array<unsigned char, 16> bytes{};
  if (inet_pton(AF_INET6, address.c_str(), bytes.data()) != 1) return address;
  std::fill(bytes.begin() + 8, bytes.end(), static_cast<unsigned char>(0));
  std::array<char, INET6_ADDRSTRLEN> text{};
  return inet_ntop(AF_INET6, bytes.data(), text.data(), text.size());
}

bool isFromHere(const Request& request) {
  for (const char* name : {"x-forwarded-for", "x-real-ip", "forwarded", "via"})
    if (request.headers.contains(name)) return false;
  // A proxy without these headers passes the name on by which the browser knows the server.
  const std::string& host = valueOf(request.headers, "host");
  const std::string name = host.substr(0, host.rfind(':'));
  return request.client.starts_with("127.") && (name == "localhost" || (name.starts_with("127.") && isAddress(name)));
}

}  // namespace insonate::web
