#pragma once

#include "page/Page.h"

namespace insonate::web {

Response showSignIn(const Visit& visit, const Parts& parts);
Response signIn(const Visit& visit, const Parts& parts);
Response signOut(const Visit& visit, const Parts& parts);
Response showPasswordForm(const Visit& visit, const Parts& parts);
Response changePassword(const Visit& visit, const Parts& parts);

/// Tells whether browsers reach the server by HTTPS.
bool hasHttps(const WebOptions& options);
/// Returns an address of this server as it is, and "/" for an address that would lead elsewhere.
std::string localAddress(const std::string& next);
/// Returns the header that stores the secret of a session in the browser; an empty secret deletes the cookie.
std::pair<std::string, std::string> sessionHeader(const WebOptions& options, const std::string& secret);
/// Returns the name of the cookie that contains a session's secret. Browsers accept the prefix __Host- only over HTTPS,
/// and only if the cookie comes from this host.
std::string sessionCookie(const WebOptions& options);

}  // namespace insonate::web
