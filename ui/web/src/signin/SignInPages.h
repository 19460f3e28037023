#pragma once

#include "page/Page.h"

namespace insonate::web {

Response showSignIn(const Visit& visit, const Parts& parts);
Response signIn(const Visit& visit, const Parts& parts);
Response signOut(const Visit& visit, const Parts& parts);
Response showPasswordForm(const Visit& visit, const Parts& parts);
Response changePassword(const Visit& visit, const Parts& parts);

/// Returns the name of the cookie that contains a session's secret. Browsers accept the prefix __Host- only over HTTPS,
/// and only if the cookie comes from this host.
std::string sessionCookie(const WebOptions& options);

}  // namespace insonate::web
