#include "openid/SigningKeys.h"

#include "openid/JsonFields.h"

#include <cjose/header.h>
#include <cjose/jwk.h>
#include <cjose/jws.h>
#include <cjose/util.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace insonate::web {
namespace {

struct JwkReleaser {
  void operator()(cjose_jwk_t* key) const { cjose_jwk_release(key); }
};
struct JwsReleaser {
  void operator()(cjose_jws_t* signedText) const { cjose_jws_release(signedText); }
};
using Jwk = std::unique_ptr<cjose_jwk_t, JwkReleaser>;
using Jws = std::unique_ptr<cjose_jws_t, JwsReleaser>;

}  // namespace

struct SigningKey {
  std::string id{};         ///< "kid"; may be empty
  std::string algorithm{};  ///< only algorithm of the key; empty: each that fits its type
  Jwk key{};
};

namespace {

constexpr std::size_t kMostKeys = 50, kSmallestRsa_bits = 2048, kLargestRsa_bits = 8192;

bool isUsable(const cjose_jwk_t* key) {
  cjose_err error{};
  switch (cjose_jwk_get_kty(key, &error)) {
    case CJOSE_JWK_KTY_RSA: {
      const std::size_t size_bits = cjose_jwk_get_keysize(key, &error);
      return size_bits >= kSmallestRsa_bits && size_bits <= kLargestRsa_bits;
    }
    case CJOSE_JWK_KTY_EC:
      return cjose_jwk_EC_get_curve(key, &error) == CJOSE_JWK_EC_P_256;
    default:
      return false;
  }
}

std::shared_ptr<const SigningKey> keyOf(const nlohmann::json& entry) {
  if (!entry.is_object()) return nullptr;
  if (const std::string use = jsonText(entry, "use"); !use.empty() && use != "sig") return nullptr;
  // Only the fields of public keys, which also keeps deeply nested entries from the library.
  nlohmann::json fields;
  for (const char* name : {"kty", "n", "e", "crv", "x", "y"})
    if (const std::string value = jsonText(entry, name); !value.empty()) fields[name] = value;
  const std::string text = fields.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  cjose_err error{};
  Jwk key(cjose_jwk_import(text.data(), text.size(), &error));
  if (!key || !isUsable(key.get())) return nullptr;
  return std::make_shared<SigningKey>(
      SigningKey{.id = jsonText(entry, "kid"), .algorithm = jsonText(entry, "alg"), .key = std::move(key)});
}

Jws importedToken(const std::string& token) {
  if (token.size() > SigningKeys::kLongestToken_bytes) return nullptr;
  cjose_err error{};
  return Jws(cjose_jws_import(token.data(), token.size(), &error));
}

struct TokenHeader {
  std::string algorithm{}, key{};
};

/// Reads the header by the library that verifies the signature, so that both read the same. The header is empty if it
/// has extensions that must be understood ("crit").
TokenHeader headerOf(cjose_jws_t* token) {
  cjose_header_t* header = cjose_jws_get_protected(token);
  cjose_err error{};
  if (char* critical = cjose_header_get_raw(header, "crit", &error)) {
    cjose_get_dealloc()(critical);
    return {};
  }
  const auto field = [&](const char* name) {
    const char* text = cjose_header_get(header, name, &error);
    return std::string(text ? text : "");
  };
  return {.algorithm = field(CJOSE_HDR_ALG), .key = field(CJOSE_HDR_KID)};
}

bool mayHaveSigned(const SigningKey& key, const TokenHeader& header) {
  if (!header.key.empty() && key.id != header.key) return false;
  if (!key.algorithm.empty() && key.algorithm != header.algorithm) return false;
  cjose_err error{};
  return cjose_jwk_get_kty(key.key.get(), &error) == CJOSE_JWK_KTY_RSA
             ? header.algorithm == "RS256" || header.algorithm == "PS256"
             : header.algorithm == "ES256";
}

bool isAccepted(const std::string& algorithm) {
  return algorithm == "RS256" || algorithm == "PS256" || algorithm == "ES256";
}

}  // namespace

Result<SigningKeys> SigningKeys::parse(const std::string& text) {
  const auto set = nlohmann::json::parse(text, nullptr, false);
  const auto entries = set.is_object() ? set.find("keys") : set.end();
  if (!set.is_object() || entries == set.end() || !entries->is_array())
    return fail("The provider's keys cannot be read: the answer is no set of JSON web keys.");
  SigningKeys keys;
  for (const auto& entry : *entries)
    if (auto key = keyOf(entry); key && keys.keys_.size() < kMostKeys) keys.keys_.push_back(std::move(key));
  return keys;
}

bool SigningKeys::haveKeyFor(const std::string& token) const {
  const Jws imported = importedToken(token);
  if (!imported) return false;
  const TokenHeader header = headerOf(imported.get());
  return std::ranges::any_of(keys_, [&](const auto& key) { return mayHaveSigned(*key, header); });
}

Result<std::string> SigningKeys::contentOf(const std::string& token) const {
  const Jws first = importedToken(token);
  if (!first) return fail("The ID token is damaged, unsigned or too long.");
  const TokenHeader header = headerOf(first.get());
  if (!isAccepted(header.algorithm))
    return fail(
        "The ID token is not signed with RS256, PS256 or ES256. Choose one of them in the provider's settings.");
  cjose_err error{};
  for (const auto& key : keys_) {
    if (!mayHaveSigned(*key, header)) continue;
    // The library keeps parts of a failed verification in the token.
    const Jws imported = importedToken(token);
    std::uint8_t* content = nullptr;
    std::size_t size_bytes = 0;
    if (imported && cjose_jws_verify(imported.get(), key->key.get(), &error) &&
        cjose_jws_get_plaintext(imported.get(), &content, &size_bytes, &error))
      return std::string(reinterpret_cast<const char*>(content), size_bytes);
  }
  return fail("The ID token is not signed by a key of the provider.");
}

}  // namespace insonate::web
