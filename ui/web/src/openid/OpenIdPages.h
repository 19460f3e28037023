#pragma once

#include "page/Page.h"

#include <string>
#include <string_view>

namespace insonate::web {

inline constexpr std::string_view kOpenIdSignIn = "/sign-in/openid", kOpenIdReturn = "/sign-in/openid/return";
/// Address of the sign-in page after a session ended that the provider had begun.
inline constexpr const char* kSignedOutOfProvider = "/sign-in?ended=openid";

/// Sends the browser to the identity provider. The query has "next": the page that the user asked for. Waits for the
/// provider.
Response sendToProvider(const Visit& visit, const Parts& parts);
/// Begins a session for a browser that comes back from the identity provider. Waits for the provider.
Response returnFromProvider(const Visit& visit, const Parts& parts);

/// Returns the link of the sign-in page that leads to the identity provider, and from there to the address `next`.
Markup providerLink(const Visit& visit, const std::string& next);
/// Returns the note of the sign-in page that the provider's session goes on; empty unless the user has just signed out
/// (kSignedOutOfProvider).
Markup signedOutNote(const Visit& visit);

}  // namespace insonate::web
