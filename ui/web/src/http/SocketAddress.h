#pragma once

#include <insonate/core/Result.h>

#include <sys/socket.h>

#include <string>

/// IP addresses as text and as the system's structures. An address has one text: "10.0.0.5", "2001:db8::5". An IPv4
/// address that arrives in the form of an IPv6 address ("::ffff:10.0.0.5") has the text of the IPv4 address.
namespace insonate::web {

/// Returns the one text of an IPv4 or IPv6 address; "" if `text` is no address.
std::string canonicalAddress(const std::string& text);
/// Tells whether a text is an IPv4 or IPv6 address.
bool isAddress(const std::string& text);
/// Tells whether a text is an address that only programs on this computer reach: 127.0.0.0/8 or ::1.
bool isLoopbackAddress(const std::string& text);
/// Returns the text of an address; "" if it is neither IPv4 nor IPv6.
std::string textOf(const sockaddr& address);

/// Returns the address that an address or a name stands for. If a name has several addresses, it is the first IPv4
/// address, or the first IPv6 address if there is no other. A name is looked up on the network, which may take seconds.
/// Fails with a sentence if there is no address.
Result<std::string> resolvedAddress(const std::string& addressOrName);
/// Returns the structure of an address, which must be canonical. `port`: 0 to 65535.
sockaddr_storage socketAddress(const std::string& address, int port);
/// Returns address and port for messages and browsers: "127.0.0.1:8443", "[::1]:8443".
std::string withPort(const std::string& address, int port);

}  // namespace insonate::web
