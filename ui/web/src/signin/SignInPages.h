#pragma once

#include "page/Page.h"

namespace insonate::web {

Response showSignIn(const Visit& visit, const Parts& parts);
Response signIn(const Visit& visit, const Parts& parts);
Response signOut(const Visit& visit, const Parts& parts);
Response showPasswordForm(const Visit& visit, const Parts& parts);
Response changePassword(const Visit& visit, const Parts& parts);

/// Returns the name of the cookie that holds a session's secret. Browsers accept the prefix __Host- only for HTTPS, and
/// then only from this very host.
std::string sessionCookie(const WebOptions& options);

}  // namespace insonate::web
