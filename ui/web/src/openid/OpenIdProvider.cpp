#include "openid/OpenIdProvider.h"

#include "http/Messages.h"
#include "openid/IdToken.h"
#include "openid/JsonFields.h"
#include "openid/ProviderAddress.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>
#include <vector>

namespace insonate::web {

/// Addresses of a provider, from its document /.well-known/openid-configuration.
struct ProviderMetadata {
  std::string authorization{}, token{}, keys{};
  std::string signOut{};   ///< empty: the provider has none
  bool takesBasic = true;  ///< the token address takes the secret by HTTP Basic authentication, not in the form
};

namespace {

using namespace std::chrono_literals;

constexpr std::chrono::seconds kPauseAfterFailure = 10s, kPauseOfUnknownKeys = 60s;
constexpr long kOk = 200;

bool lists(const nlohmann::json& object, const char* name, const std::string& value) {
  const auto found = object.find(name);
  return found != object.end() && found->is_array() &&
         std::ranges::any_of(*found, [&](const auto& one) { return one.is_string() && one == value; });
}

Result<std::string> bodyOf(const FetchRequest& request, const FetchLimits& limits) {
  auto fetched = fetch(request, limits);
  if (!fetched) return tl::unexpected(fetched.error());
  if (fetched->status != kOk)
    return fail(request.url + " answered with status " + std::to_string(fetched->status) +
                ". Check that openid-issuer is the address of an identity provider.");
  return std::move(fetched->body);
}

Result<ProviderMetadata> metadataOf(const std::string& text, const std::string& issuer) {
  const auto document = nlohmann::json::parse(text, nullptr, false);
  if (!document.is_object()) return fail("The provider's configuration is no JSON. Check openid-issuer.");
  if (const std::string stated = jsonText(document, "issuer"); stated != issuer)
    return fail("The provider is named " + plainText(stated).substr(0, 200) + ", not " + issuer +
                ". Set openid-issuer to the name that the provider states.");
  ProviderMetadata read{.authorization = jsonText(document, "authorization_endpoint"),
                        .token = jsonText(document, "token_endpoint"),
                        .keys = jsonText(document, "jwks_uri"),
                        .signOut = jsonText(document, "end_session_endpoint")};
  for (const std::string* address : {&read.authorization, &read.token, &read.keys})
    if (!isProtected(*address))
      return fail("The provider's configuration lacks an address, or names one without https://.");
  if (!isProtected(read.signOut)) read.signOut.clear();
  constexpr const char* kMethods = "token_endpoint_auth_methods_supported";
  read.takesBasic = !document.contains(kMethods) || lists(document, kMethods, "client_secret_basic");
  if (!read.takesBasic && !lists(document, kMethods, "client_secret_post"))
    return fail("The provider takes no client secret. Allow client_secret_basic or client_secret_post there.");
  return read;
}

std::string formOf(const std::vector<std::pair<std::string, std::string>>& fields) {
  return withQuery("", fields).substr(1);
}

/// The provider's word for the reason; other texts may contain data of users.
std::string reasonIn(const std::string& body) {
  const auto answer = nlohmann::json::parse(body, nullptr, false);
  const std::string word = answer.is_object() ? jsonText(answer, "error") : std::string();
  constexpr std::size_t kLongestWord = 40;
  const bool isWord = !word.empty() && word.size() <= kLongestWord &&
                      word.find_first_not_of("abcdefghijklmnopqrstuvwxyz_") == std::string::npos;
  return isWord ? " (" + word + ")" : "";
}

}  // namespace

OpenIdProvider::OpenIdProvider(OpenIdOptions options, FetchLimits limits, std::chrono::milliseconds kept)
    : options_(std::move(options)), limits_(limits), kept_(kept) {}

OpenIdProvider::~OpenIdProvider() = default;

Result<std::string> OpenIdProvider::signInAddress(const SignInTry& tried, const std::string& returnAddress) {
  const auto known = metadata();
  if (!known) return tl::unexpected(known.error());
  return withQuery((*known)->authorization, {{"response_type", "code"},
                                             {"client_id", options_.clientId},
                                             {"redirect_uri", returnAddress},
                                             {"scope", "openid email"},
                                             {"state", tried.state},
                                             {"nonce", tried.nonce},
                                             {"code_challenge", challengeOf(tried.verifier)},
                                             {"code_challenge_method", "S256"}});
}

Result<std::optional<VerifiedEmail>> OpenIdProvider::redeem(const std::string& code, const SignInTry& tried,
                                                            const std::string& returnAddress, std::int64_t now_s) {
  const auto known = metadata();
  if (!known) return tl::unexpected(known.error());
  const auto token = redeemedToken(**known, code, tried, returnAddress);
  if (!token) return tl::unexpected(token.error());
  const auto keys = keysFor(*token, (*known)->keys);
  if (!keys) return tl::unexpected(keys.error());
  return IdToken::check(
      *token, *keys, {.issuer = options_.issuer, .clientId = options_.clientId, .nonce = tried.nonce, .now_s = now_s});
}

std::string OpenIdProvider::signOutAddress() const {
  const std::lock_guard lock(mutex_);
  if (!metadata_ || metadata_->signOut.empty()) return {};
  return withQuery(metadata_->signOut, {{"client_id", options_.clientId}});
}

Result<std::shared_ptr<const ProviderMetadata>> OpenIdProvider::metadata() {
  {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (metadata_ && now - metadataRead_ < kept_) return metadata_;
    // Many users who wait would otherwise occupy the workers with requests that fail.
    if (failure_ && now - failed_ < kPauseAfterFailure) return latestMetadata();
  }
  auto read = readMetadata();
  const std::lock_guard lock(mutex_);
  const auto now = Clock::now();
  if (read) {
    metadata_ = std::make_shared<const ProviderMetadata>(std::move(*read));
    metadataRead_ = now;
    failure_.reset();
  } else {
    failure_ = read.error();
    failed_ = now;
  }
  return latestMetadata();
}

/// A provider rarely changes its addresses: old metadata are better than none.
Result<std::shared_ptr<const ProviderMetadata>> OpenIdProvider::latestMetadata() const {
  if (metadata_) return metadata_;
  return tl::unexpected(*failure_);
}

Result<ProviderMetadata> OpenIdProvider::readMetadata() const {
  std::string base = options_.issuer;
  while (base.ends_with('/')) base.pop_back();
  const auto body =
      bodyOf({.url = base + "/.well-known/openid-configuration", .authority = options_.authority}, limits_);
  if (!body) return tl::unexpected(body.error());
  return metadataOf(*body, options_.issuer);
}

/// A provider signs with a new key from time to time. Tokens with invented keys must not cause requests without end.
Result<SigningKeys> OpenIdProvider::keysFor(const std::string& token, const std::string& keyAddress) {
  {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (keys_ && now - keysRead_ < kept_) {
      if (keys_->haveKeyFor(token)) return *keys_;
      if (readForUnknownKey_ && now - *readForUnknownKey_ < kPauseOfUnknownKeys) return *keys_;
      readForUnknownKey_ = now;
    }
  }
  return readKeys(keyAddress);
}

Result<SigningKeys> OpenIdProvider::readKeys(const std::string& keyAddress) {
  const auto body = bodyOf({.url = keyAddress, .authority = options_.authority}, limits_);
  if (!body) return tl::unexpected(body.error());
  auto keys = SigningKeys::parse(*body);
  if (!keys) return keys;
  const std::lock_guard lock(mutex_);
  keys_ = *keys;
  keysRead_ = Clock::now();
  return keys;
}

Result<std::string> OpenIdProvider::redeemedToken(const ProviderMetadata& from, const std::string& code,
                                                  const SignInTry& tried, const std::string& returnAddress) const {
  std::vector<std::pair<std::string, std::string>> form{{"grant_type", "authorization_code"},
                                                        {"code", code},
                                                        {"redirect_uri", returnAddress},
                                                        {"code_verifier", tried.verifier}};
  FetchRequest request{.url = from.token, .authority = options_.authority};
  if (from.takesBasic) {
    // RFC 6749, 2.3.1: name and secret are encoded first.
    request.user = encoded(options_.clientId);
    request.password = encoded(options_.secret);
  } else {
    form.emplace_back("client_id", options_.clientId);
    form.emplace_back("client_secret", options_.secret);
  }
  request.form = formOf(form);
  const auto fetched = fetch(request, limits_);
  if (!fetched) return tl::unexpected(fetched.error());
  if (fetched->status != kOk)
    return fail("The provider refused the code with status " + std::to_string(fetched->status) +
                reasonIn(fetched->body) + ". Check openid-client and openid-secret-file if this continues.");
  const auto answer = nlohmann::json::parse(fetched->body, nullptr, false);
  const std::string token = answer.is_object() ? jsonText(answer, "id_token") : std::string();
  if (token.empty()) return fail("The provider sent no ID token. Allow the scope \"openid\" for this server there.");
  return token;
}

}  // namespace insonate::web
