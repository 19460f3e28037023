#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace insonate {

/// 64-bit FNV-1a hash (Fowler, Noll, Vo) of numbers and texts, for detecting that two inputs differ. Each added number
/// or character is one step of the hash. The hash is not cryptographic.
class Fingerprint {
 public:
  void add(std::uint64_t value) { hash_ = (hash_ ^ value) * 0x100000001b3U; }
  void add(std::string_view text) {
    for (const char letter : text) add(std::uint64_t{static_cast<unsigned char>(letter)});
  }
  /// Returns the hash as 16 hexadecimal digits.
  std::string text() const {
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_));
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325U;
};

}  // namespace insonate
