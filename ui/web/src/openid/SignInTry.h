#pragma once

#include <insonate/core/Result.h>

#include <cstdint>
#include <optional>
#include <string>

namespace insonate::web {

/// Data of a sign-in from the redirect to the provider until the user's return. The browser keeps them in a cookie,
/// since another server may answer the return.
struct SignInTry {
  static constexpr std::int64_t kLongest_s = 600;

  std::string state{};     ///< ties the return to this browser
  std::string nonce{};     ///< ties the ID token to this sign-in
  std::string verifier{};  ///< ties the code to this sign-in (PKCE, RFC 7636)
  std::int64_t begun_s = 0;
  std::string next{};  ///< address of the page that the user asked for
};

/// Makes a sign-in of new random values. Fails if the system has no random numbers.
Result<SignInTry> beginTry(const std::string& next, std::int64_t now_s);
/// Returns the value of the cookie.
std::string cookieValueOf(const SignInTry& tried);
/// Reads the value of the cookie; empty if it is damaged or older than kLongest_s.
std::optional<SignInTry> readTry(const std::string& cookieValue, std::int64_t now_s);
/// Returns the challenge that belongs to a verifier, by the method S256 of RFC 7636.
std::string challengeOf(const std::string& verifier);

}  // namespace insonate::web
