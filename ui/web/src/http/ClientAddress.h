#pragma once

#include "http/Messages.h"

#include <insonate/web/WebServer.h>

#include <string>

namespace insonate::web {

/// Returns the address of the client that made a request, in its one text (SocketAddress.h). This is the address of the
/// connection. If the connection comes from a proxy of WebOptions::proxies, it is the last address in X-Forwarded-For
/// that is not one of these proxies; anybody can forge the addresses before it. Returns "" if the address is unknown,
/// because the proxy is not listed or does not state its client.
std::string clientAddress(const Request& request, const WebOptions& options);

/// Returns the part of an address that stands for one subscriber: an IPv4 address, or the first 64 bits of an IPv6
/// address.
std::string networkOf(const std::string& address);

/// Tells whether a program on this computer made the request to this server itself, without a proxy.
bool isFromHere(const Request& request);

}  // namespace insonate::web
