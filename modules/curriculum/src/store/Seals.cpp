#include "store/Seals.h"

#include <sodium.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace insonate::store {
namespace {

constexpr std::size_t kRandom = 16, kTag = 16, kCode = 32, kNonce = kRandom + kTag + kCode;
using Bytes = std::vector<std::uint8_t>;
using Hash = std::array<std::uint8_t, 32>;

std::string hex(std::span<const std::uint8_t> bytes) {
  std::string digits(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(digits.data(), digits.size(), bytes.data(), bytes.size());
  digits.pop_back();
  return digits;
}

/// None if the text is not this number of bytes in hexadecimal digits.
std::optional<Bytes> bytesOf(const std::string& digits, std::size_t size) {
  Bytes bytes(size);
  std::size_t found = 0;
  if (digits.size() != 2 * size ||
      sodium_hex2bin(bytes.data(), size, digits.data(), digits.size(), nullptr, &found, nullptr) != 0 || found != size)
    return std::nullopt;
  return bytes;
}

/// H of AttemptSeal.h.
class KeyedHash {
 public:
  explicit KeyedHash(const Bytes& key) {
    crypto_generichash_blake2b_init(&state_, key.data(), key.size(), Hash().size());
  }
  KeyedHash& add(std::span<const std::uint8_t> text) {
    std::array<std::uint8_t, 8> length;
    for (std::size_t i = 0; i < length.size(); ++i) length[i] = static_cast<std::uint8_t>(text.size() >> (8 * i));
    crypto_generichash_blake2b_update(&state_, length.data(), length.size());
    crypto_generichash_blake2b_update(&state_, text.data(), text.size());
    return *this;
  }
  KeyedHash& add(std::string_view text) {
    return add(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
  }
  Hash hash() {
    Hash hash;
    crypto_generichash_blake2b_final(&state_, hash.data(), hash.size());
    return hash;
  }

 private:
  crypto_generichash_blake2b_state state_;
};

Result<Bytes> secretOf(Transaction& transaction) {
  const auto row = transaction.row("SELECT secret FROM store_secret");
  auto secret = row ? bytesOf(row->text(0), 32) : std::nullopt;
  if (!secret) return fail(transaction.place() + " has lost the secret that proves recordings. Restore a backup.");
  return std::move(*secret);
}

Hash tagOf(const Bytes& secret) {
  return KeyedHash(secret).add("store").hash();
}

Hash codeOf(const Bytes& secret, std::span<const std::uint8_t> random, const AttemptFacts& facts) {
  return KeyedHash(secret)
      .add("nonce")
      .add(random)
      .add(facts.id)
      .add(facts.person)
      .add(facts.curriculum)
      .add(std::to_string(facts.curriculumVersion))
      .add(facts.level)
      .hash();
}

AttemptKey keyOf(const Bytes& secret, const Bytes& nonce) {
  return KeyedHash(secret).add("key").add(nonce).hash();
}

}  // namespace

Result<void> storeSecret(Core& core) {
  const auto known = inTransaction(core, Way::Read, [](Transaction& transaction) -> Result<bool> {
    return transaction.row("SELECT one FROM store_secret").has_value();
  });
  if (!known) return tl::unexpected(known.error());
  if (*known) return {};
  return inTransaction(core, Way::Write, [](Transaction& transaction) -> Result<void> {
    if (transaction.row("SELECT one FROM store_secret")) return {};  // another program has made it first
    Bytes secret(32);
    randombytes_buf(secret.data(), secret.size());
    transaction.run("INSERT INTO store_secret VALUES (1, ?)", hex(secret));
    return {};
  });
}

Result<AttemptSeal> freshSeal(Transaction& transaction, const AttemptFacts& facts) {
  const auto secret = secretOf(transaction);
  if (!secret) return tl::unexpected(secret.error());
  Bytes nonce(kRandom);
  randombytes_buf(nonce.data(), nonce.size());
  const Hash tag = tagOf(*secret), code = codeOf(*secret, nonce, facts);
  nonce.insert(nonce.end(), tag.begin(), tag.begin() + kTag);
  nonce.insert(nonce.end(), code.begin(), code.end());
  return AttemptSeal{hex(nonce), keyOf(*secret, nonce)};
}

Result<std::string> secretText(Transaction& transaction) {
  const auto secret = secretOf(transaction);
  return secret ? Result<std::string>(hex(*secret)) : tl::unexpected(secret.error());
}

Result<NonceOrigin> originOfNonce(Transaction& transaction, const AttemptFacts& facts, const std::string& digits) {
  const auto secret = secretText(transaction);
  return secret ? Result<NonceOrigin>(originBySecret(*secret, facts, digits)) : tl::unexpected(secret.error());
}

NonceOrigin originBySecret(const std::string& secretDigits, const AttemptFacts& facts, const std::string& digits) {
  using enum NonceOrigin::Kind;
  const auto secret = bytesOf(secretDigits, 32);
  if (!secret) return NonceOrigin{Elsewhere, {}};
  const auto nonce = bytesOf(digits, kNonce);
  if (!nonce) return NonceOrigin{Elsewhere, {}};
  const Hash tag = tagOf(*secret);
  if (sodium_memcmp(tag.data(), nonce->data() + kRandom, kTag) != 0) return NonceOrigin{Elsewhere, {}};
  const Hash code = codeOf(*secret, std::span(*nonce).first(kRandom), facts);
  if (sodium_memcmp(code.data(), nonce->data() + kRandom + kTag, kCode) != 0) return NonceOrigin{Forged, {}};
  return NonceOrigin{Given, keyOf(*secret, *nonce)};
}

}  // namespace insonate::store
