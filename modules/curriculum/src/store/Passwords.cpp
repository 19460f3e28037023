#include "store/Passwords.h"

#include "store/Texts.h"

#include <sodium.h>

#include <array>

namespace insonate::store {

Result<std::string> hashedPassword(const std::string& password, PasswordCost cost) {
  const bool usual = cost == PasswordCost::Default;
  std::array<char, crypto_pwhash_STRBYTES> hashed{};
  const int failed = crypto_pwhash_str_alg(hashed.data(), password.data(), password.size(),
                                           usual ? crypto_pwhash_OPSLIMIT_INTERACTIVE : crypto_pwhash_OPSLIMIT_MIN,
                                           usual ? crypto_pwhash_MEMLIMIT_INTERACTIVE : crypto_pwhash_MEMLIMIT_MIN,
                                           crypto_pwhash_ALG_ARGON2ID13);
  if (failed)
    return fail(
        "The password cannot be stored, since there are less than 64 MB of free memory. Close another program and try "
        "again.");
  return std::string(hashed.data());
}

Result<std::string> checkedAndHashed(const std::string& password, PasswordCost cost) {
  if (auto ok = checkPassword(password); !ok) return tl::unexpected(ok.error());
  return hashedPassword(password, cost);
}

bool fitsPassword(const std::string& password, const std::string& hashed) {
  return crypto_pwhash_str_verify(hashed.c_str(), password.data(), password.size()) == 0;
}

std::string randomToken() {
  if (sodium_init() < 0) return {};
  std::array<unsigned char, 32> random{};
  randombytes_buf(random.data(), random.size());
  std::array<char, 2 * random.size() + 1> digits{};
  return sodium_bin2hex(digits.data(), digits.size(), random.data(), random.size());
}

const std::string& hashOfNobody(PasswordCost cost) {
  const auto made = [](PasswordCost of) {
    std::array<char, 32> random{};
    randombytes_buf(random.data(), random.size());
    return hashedPassword(std::string(random.data(), random.size()), of).value_or("");
  };
  static const std::string usual = made(PasswordCost::Default), least = made(PasswordCost::Minimum);
  return cost == PasswordCost::Default ? usual : least;
}

}  // namespace insonate::store
