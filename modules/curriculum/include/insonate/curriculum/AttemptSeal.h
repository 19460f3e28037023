#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace insonate {

/// Secret key of the links of a recording (procedure/RecordingProof.h); only the recorder may have it.
using AttemptKey = std::array<std::uint8_t, 32>;

/// Nonce and key that a store issues to an attempt at its beginning, so that the recording can prove to which attempt
/// it belongs. s is the store's secret, r are 16 random bytes, and H(k, ...) is BLAKE2b-256 with key k over texts, each
/// preceded by its length:
///   tag = the first 16 bytes of H(s, "store"), code = H(s, "nonce", r, id, person, curriculum, version, level),
///   nonce = r tag code, key = H(s, "key", nonce).
/// The store keeps none of these values: it computes code and key again from the nonce.
struct AttemptSeal {
  std::string nonce{};  ///< for the recording's header, 128 hexadecimal digits
  AttemptKey key{};
};

/// A store's answer about the nonce of a recording.
struct NonceOrigin {
  enum class Kind {
    Given,      ///< issued by this store to this attempt, with `key`
    Elsewhere,  ///< issued by another store
    Forged,  ///< issued by no store: the nonce has this store's tag, but was not issued to this attempt of this person
             ///< and level
  };
  Kind kind = Kind::Elsewhere;
  AttemptKey key{};  ///< if kind is Given
};

}  // namespace insonate
