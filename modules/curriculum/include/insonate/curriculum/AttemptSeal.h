#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace insonate {

/// The secret with which the links of a recording are keyed (procedure/RecordingProof.h); for the recorder alone.
using AttemptKey = std::array<std::uint8_t, 32>;

/// Nonce and key that a store gives to an attempt as it begins, so that its recording can prove whose it is. With s the
/// store's secret
/// and H(k, ...) BLAKE2b-256 keyed with k over texts that each have their length before them:
///   tag = the first 16 bytes of H(s, "store"), code = H(s, "nonce", r, id, person, curriculum, version, level),
///   nonce = r tag code with r 16 random bytes, key = H(s, "key", nonce).
/// The store keeps none of it: it makes code and key again from the nonce.
struct AttemptSeal {
  std::string nonce{};  ///< for the recording's header, 128 hexadecimal digits
  AttemptKey key{};
};

/// A store's answer about the nonce of a recording.
struct NonceOrigin {
  enum class Kind {
    Given,      ///< to this attempt, with `key`
    Elsewhere,  ///< by another store
    Forged,     ///< by nobody: it bears this store's tag, and was not given to this attempt of this person and level
  };
  Kind kind = Kind::Elsewhere;
  AttemptKey key{};  ///< of Kind::Given
};

}  // namespace insonate
