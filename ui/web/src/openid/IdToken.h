#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/VerifiedEmail.h>

#include <cstdint>
#include <optional>
#include <string>

namespace insonate::web {

class SigningKeys;

/// Values that an ID token must have.
struct ExpectedToken {
  std::string issuer{};
  std::string clientId{};
  std::string nonce{};
  std::int64_t now_s = 0;  ///< since 1970, UTC
};

/// Check of ID tokens (OpenID Connect Core 1.0, 3.1.3.7), and the only source of VerifiedEmail.
class IdToken {
 public:
  /// Returns the e-mail address in a token; empty if the token is valid but states no address that the provider has
  /// verified. Fails with a sentence for the log, without data of the token, if the token is not valid: because of its
  /// signature, issuer, audience, time or nonce. Clocks may differ by 60 s.
  static Result<std::optional<VerifiedEmail>> check(const std::string& token, const SigningKeys& keys,
                                                    const ExpectedToken& expected);
};

}  // namespace insonate::web
