#pragma once

#include <insonate/core/Result.h>
#include <insonate/web/OpenIdOptions.h>

#include <string>
#include <utility>
#include <vector>

namespace insonate::web {

/// Tells whether requests to an address are protected: it begins with https://, or with http:// and a loopback address.
bool isProtected(const std::string& url);
/// Tells whether an address is one of this computer: localhost, 127.*, or [::1].
bool isOnLoopback(const std::string& url);
/// Returns an address with a query added: {"a", "b c"} adds "?a=b%20c", or "&a=b%20c" if it has a query already.
std::string withQuery(const std::string& url, const std::vector<std::pair<std::string, std::string>>& values);

/// Fails with a sentence if options of the identity provider are missing, or contradict each other.
Result<void> checkOpenIdOptions(const OpenIdOptions& options);

}  // namespace insonate::web
