#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace insonate {

/// The secret with which the store of an attempt keys its recording (curriculum/AttemptSeal.h); never in the file.
using RecordKey = std::array<std::uint8_t, 32>;

enum class ProofState {
  Proven,         ///< each block is as the recorder wrote it with this key, to the end of the attempt
  Unproven,       ///< no proof is possible: an earlier format, no key, or the end is missing
  Demonstration,  ///< a script moved the hands
  Broken,         ///< changed or damaged after it was recorded
};

/// Proof that a recording gives by itself.
struct RecordingProof {
  ProofState state = ProofState::Unproven;
  std::string why{};  ///< a sentence, with the file and the place; "" where it is proven
};

/// AttemptRecording::proof() of a file; Broken where it cannot be opened. `key` is the one that the recording's nonce
/// was given with; none: not known, or the recording has no nonce.
RecordingProof proofOf(const std::filesystem::path& file, const std::optional<RecordKey>& key);

}  // namespace insonate
