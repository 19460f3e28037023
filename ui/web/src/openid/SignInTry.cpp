#include "openid/SignInTry.h"

#include "http/Messages.h"

#include <sodium.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <string_view>

namespace insonate::web {
namespace {

constexpr std::int64_t kClockDifference_s = 60;  // between servers with one database
constexpr std::size_t kRandom_bytes = 32, kRandomLetters = 43, kLongestNext = 1000;

template <std::size_t kSize>
std::string base64Url(const std::array<unsigned char, kSize>& bytes) {
  constexpr int kVariant = sodium_base64_VARIANT_URLSAFE_NO_PADDING;
  std::array<char, sodium_base64_ENCODED_LEN(kSize, kVariant)> text{};
  return sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), kVariant);
}

std::string randomLetters() {
  std::array<unsigned char, kRandom_bytes> bytes{};
  randombytes_buf(bytes.data(), bytes.size());
  return base64Url(bytes);
}

std::string_view takeField(std::string_view& text) {
  const std::string_view field = text.substr(0, text.find('.'));
  text.remove_prefix(std::min(text.size(), field.size() + 1));
  return field;
}

}  // namespace

Result<SignInTry> beginTry(const std::string& next, std::int64_t now_s) {
  if (sodium_init() < 0) return fail("There are no random numbers for a sign-in; restart the server.");
  // A browser refuses a cookie of 4 KB.
  return SignInTry{.state = randomLetters(),
                   .nonce = randomLetters(),
                   .verifier = randomLetters(),
                   .begun_s = now_s,
                   .next = encoded(next).size() <= kLongestNext ? next : "/"};
}

std::string cookieValueOf(const SignInTry& tried) {
  return tried.state + "." + tried.nonce + "." + tried.verifier + "." + std::to_string(tried.begun_s) + "." +
         encoded(tried.next);
}

std::optional<SignInTry> readTry(const std::string& cookieValue, std::int64_t now_s) {
  std::string_view rest = cookieValue;
  SignInTry read;
  for (std::string* field : {&read.state, &read.nonce, &read.verifier})
    if (*field = takeField(rest); field->size() != kRandomLetters) return std::nullopt;
  const std::string_view begun = takeField(rest);
  const auto [end, error] = std::from_chars(begun.data(), begun.data() + begun.size(), read.begun_s);
  if (error != std::errc() || end != begun.data() + begun.size()) return std::nullopt;
  if (read.begun_s > now_s + kClockDifference_s || now_s - read.begun_s > SignInTry::kLongest_s) return std::nullopt;
  read.next = decoded(rest, false);
  return read;
}

std::string challengeOf(const std::string& verifier) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(hash.data(), reinterpret_cast<const unsigned char*>(verifier.data()), verifier.size());
  return base64Url(hash);
}

}  // namespace insonate::web
