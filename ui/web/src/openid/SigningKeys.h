#pragma once

#include <insonate/core/Result.h>

#include <memory>
#include <string>
#include <vector>

namespace insonate::web {

struct SigningKey;

/// Public keys by which a provider signs (JSON Web Key Set, RFC 7517). Only keys for RS256, PS256 (RSA of 2048 to 8192
/// bits) and ES256 (curve P-256) are kept. Copies share the keys. May be used on any thread.
class SigningKeys {
 public:
  static constexpr std::size_t kLongestToken_bytes = 64 << 10;

  /// Reads a set of keys, in which keys of other kinds are ignored. Fails if the text is no set of keys.
  static Result<SigningKeys> parse(const std::string& text);
  /// Tells whether one of the keys may have signed a token (JWS, compact form).
  bool haveKeyFor(const std::string& token) const;
  /// Returns the content of a token that one of the keys has signed. Fails if the token is damaged or too long, if it
  /// was not signed by one of these keys, or if its algorithm is another one, such as "none" or HS256.
  Result<std::string> contentOf(const std::string& token) const;

 private:
  std::vector<std::shared_ptr<const SigningKey>> keys_;
};

}  // namespace insonate::web
