#pragma once

#include "openid/Fetch.h"
#include "openid/SignInTry.h"
#include "openid/SigningKeys.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/VerifiedEmail.h>
#include <insonate/web/OpenIdOptions.h>

#include <chrono>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace insonate::web {

struct ProviderMetadata;

/// Identity provider of a hospital (OpenID Connect, authorization code flow with PKCE). Keeps the provider's metadata
/// and keys for an hour, and the metadata for longer while the provider cannot be asked. Functions that wait for the
/// provider say so: they must not be called on the workers for pages. May be used on any thread. Errors are sentences
/// for the log, without data of users.
class OpenIdProvider {
 public:
  /// `kept`: time for which metadata and keys are kept.
  explicit OpenIdProvider(OpenIdOptions options, FetchLimits limits = {},
                          std::chrono::milliseconds kept = std::chrono::hours(1));
  ~OpenIdProvider();
  OpenIdProvider(const OpenIdProvider&) = delete;
  OpenIdProvider& operator=(const OpenIdProvider&) = delete;

  /// Returns the address at the provider to which the browser is sent. Waits for the provider. `returnAddress`: address
  /// of this server to which the provider sends the browser back.
  Result<std::string> signInAddress(const SignInTry& tried, const std::string& returnAddress);
  /// Redeems a code and returns the e-mail address of the user; empty if the provider has verified none. Waits for the
  /// provider. `returnAddress`: as for signInAddress(); `now_s`: present time, since 1970, UTC.
  Result<std::optional<VerifiedEmail>> redeem(const std::string& code, const SignInTry& tried,
                                              const std::string& returnAddress, std::int64_t now_s);
  /// Returns the address at which a user signs out at the provider; empty if it is unknown. Does not wait.
  std::string signOutAddress() const;

 private:
  using Clock = std::chrono::steady_clock;

  Result<std::shared_ptr<const ProviderMetadata>> metadata();
  Result<std::shared_ptr<const ProviderMetadata>> latestMetadata() const;  ///< requires mutex_
  Result<ProviderMetadata> readMetadata() const;
  Result<SigningKeys> keysFor(const std::string& token, const std::string& keyAddress);
  Result<SigningKeys> readKeys(const std::string& keyAddress);
  Result<std::string> redeemedToken(const ProviderMetadata& from, const std::string& code, const SignInTry& tried,
                                    const std::string& returnAddress) const;

  const OpenIdOptions options_;
  const FetchLimits limits_;
  const std::chrono::milliseconds kept_;
  mutable std::mutex mutex_{};  ///< guards the following members; never held while the provider is asked
  std::shared_ptr<const ProviderMetadata> metadata_{};
  Clock::time_point metadataRead_{};
  std::optional<Error> failure_{};  ///< latest failure to read the metadata
  Clock::time_point failed_{};
  std::optional<SigningKeys> keys_{};
  Clock::time_point keysRead_{};
  std::optional<Clock::time_point> readForUnknownKey_{};
};

}  // namespace insonate::web
