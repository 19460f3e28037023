#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace insonate {

/// Secret key with which the store of an attempt keys its recording (curriculum/AttemptSeal.h); never stored in the
/// file.
using RecordKey = std::array<std::uint8_t, 32>;

enum class ProofState {
  Proven,         ///< each block up to the end of the attempt is as the recorder wrote it with this key
  Unproven,       ///< no proof is possible: an earlier format, no key, or the end is missing
  Demonstration,  ///< a script moved the hands
  Broken,         ///< changed or damaged after it was recorded
};

/// Result of checking a recording.
struct RecordingProof {
  ProofState state = ProofState::Unproven;
  std::string why{};  ///< a sentence with file and place; "" if proven
};

/// AttemptRecording::proof() of a file; Broken if the file cannot be opened. `key` is the key issued with the
/// recording's nonce; empty: unknown, or the recording has no nonce.
RecordingProof proofOf(const std::filesystem::path& file, const std::optional<RecordKey>& key);

}  // namespace insonate
