#include "openid/IdToken.h"

#include "http/Messages.h"
#include "openid/JsonFields.h"
#include "openid/SigningKeys.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>

namespace insonate::web {
namespace {

using Claims = nlohmann::json;

constexpr double kLeeway_s = 60;

std::optional<double> timeClaim_s(const Claims& claims, const char* name) {
  const auto found = claims.find(name);
  return found != claims.end() && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

/// A token for several programs must name this one as the program that requested it ("azp").
bool isFor(const Claims& claims, const std::string& clientId) {
  const auto audience = claims.find("aud");
  if (audience == claims.end()) return false;
  const bool isList = audience->is_array();
  const bool isNamed =
      isList ? std::ranges::any_of(*audience, [&](const Claims& one) { return one.is_string() && one == clientId; })
             : audience->is_string() && *audience == clientId;
  const bool hasParty = claims.contains("azp");
  if (!isNamed || (isList && audience->size() > 1 && !hasParty)) return false;
  return !hasParty || jsonText(claims, "azp") == clientId;
}

Result<void> checkClaims(const Claims& claims, const ExpectedToken& expected) {
  if (jsonText(claims, "iss") != expected.issuer) return fail("The ID token was issued by another provider.");
  if (!isFor(claims, expected.clientId)) return fail("The ID token was issued for another program.");
  const auto end_s = timeClaim_s(claims, "exp"), issued_s = timeClaim_s(claims, "iat");
  const auto now_s = static_cast<double>(expected.now_s);
  if (!end_s || !issued_s) return fail("The ID token states no times.");
  if (now_s > *end_s + kLeeway_s)
    return fail("The ID token has expired. Check the clocks of this computer and of the provider.");
  if (*issued_s > now_s + kLeeway_s)
    return fail("The ID token was issued in the future. Check the clocks of this computer and of the provider.");
  if (expected.nonce.empty() || !areEqual(expected.nonce, jsonText(claims, "nonce")))
    return fail("The ID token belongs to another sign-in.");
  return {};
}

}  // namespace

Result<std::optional<VerifiedEmail>> IdToken::check(const std::string& token, const SigningKeys& keys,
                                                    const ExpectedToken& expected) {
  const auto content = keys.contentOf(token);
  if (!content) return tl::unexpected(content.error());
  const auto claims = Claims::parse(*content, nullptr, false);
  if (!claims.is_object()) return fail("The ID token contains no claims.");
  if (auto ok = checkClaims(claims, expected); !ok) return tl::unexpected(ok.error());
  const auto verified = claims.find("email_verified");
  const std::string email = jsonText(claims, "email");
  if (email.empty() || verified == claims.end() || !verified->is_boolean() || !verified->get<bool>())
    return std::optional<VerifiedEmail>();
  return std::optional(VerifiedEmail(email));
}

}  // namespace insonate::web
