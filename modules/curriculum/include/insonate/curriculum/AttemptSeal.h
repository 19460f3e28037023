#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace insonate {

/// Secret key with which the blocks of a recording are authenticated (procedure/RecordingProof.h). Only the recorder
/// may have the key.
using AttemptKey = std::array<std::uint8_t, 32>;

/// Nonce and key that the curriculum store (database) issues at the beginning of an attempt, so that the recording can
/// prove to which attempt it belongs. With s: secret of the store; r: 16 random bytes; H(k, ...): BLAKE2b-256 with key
/// k of the texts, each preceded by its length:
///   tag = the first 16 bytes of H(s, "store"), code = H(s, "nonce", r, id, person, curriculum, version, level),
///   nonce = r tag code, key = H(s, "key", nonce).
/// The store keeps only s: it computes code and key again from the nonce.
struct AttemptSeal {
  std::string nonce{};  ///< nonce for the recording's header, 128 hexadecimal digits
  AttemptKey key{};
};

/// Result of checking whether a curriculum store (database) has issued the nonce of a recording.
struct NonceOrigin {
  enum class Kind {
    Given,      ///< this store issued the nonce to this attempt; NonceOrigin::key is set
    Elsewhere,  ///< another store issued the nonce
    /// Forged nonce: it has this store's tag, but was not issued to this attempt of this person and level.
    Forged,
  };
  Kind kind = Kind::Elsewhere;
  AttemptKey key{};  ///< key of the recording; set only if `kind` is Given
};

}  // namespace insonate
