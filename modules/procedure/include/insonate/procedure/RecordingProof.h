#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace insonate {

/// Secret key with which the blocks of a recording are authenticated. The curriculum store issues it
/// (curriculum/AttemptSeal.h); it is never stored in the file.
using RecordKey = std::array<std::uint8_t, 32>;

enum class ProofState {
  Proven,  ///< the key confirms that every block up to the end is as it was recorded
  /// origin unknown: the recording has an earlier format, there is no key, or the end of the recording is missing
  Unproven,
  Demonstration,  ///< a script moved probe and needle
  Broken,         ///< the recording was changed or damaged after it was made
};

/// Result of checking whether a recording is unchanged and of known origin.
struct RecordingProof {
  ProofState state = ProofState::Unproven;
  std::string why{};  ///< reason for the state: a sentence with file and place; "" if proven
};

/// Opens a recording and checks whether it is unchanged, as AttemptRecording::proof() does with the same `key`. Returns
/// ProofState::Broken if the recording cannot be opened.
RecordingProof proofOf(const std::filesystem::path& file, const std::optional<RecordKey>& key);

}  // namespace insonate
