#include "record/Chain.h"

#include <insonate/procedure/AttemptRecording.h>

#include <sodium/utils.h>

#include <algorithm>

namespace insonate {

RecordingProof AttemptRecording::proof(const std::optional<RecordKey>& key) const {
  using enum ProofState;
  if (!fault_.empty()) return {Broken, fault_};
  if (!isWhole()) return {Broken, errors_.back()};
  if (header_.isScripted) return {Demonstration, name_ + " was recorded from a script: it is a demonstration."};
  if (!isChained_)
    return {Unproven,
            name_ + " was recorded by an earlier version of the program, which wrote no proof into the recording: " +
                header_.software + "."};
  if (header_.recordedFor.nonce.empty())
    return {Unproven, name_ + " was recorded without a store of attempts, so the person is not proven."};
  if (!key) return {Unproven, name_ + " was recorded for another store of attempts."};
  const auto isKeyed = [&](const Link& link) {
    if (!link.code) return false;
    const record::Digest code = record::codeOf(link.digest, *key);
    return sodium_memcmp(code.data(), link.code->data(), code.size()) == 0;
  };
  if (!std::ranges::all_of(links_, isKeyed))
    return {Broken, name_ + " was changed after it was recorded: its codes are not those of the store that it names. " +
                        "Look for an unchanged copy."};
  if (status_ == AttemptStatus::CutShort)
    return {Unproven, name_ + " stopped early: the end of the attempt is not proven."};
  return {Proven, ""};
}

RecordingProof proofOf(const std::filesystem::path& file, const std::optional<RecordKey>& key) {
  const auto recording = AttemptRecording::open(file);
  if (!recording) return {ProofState::Broken, recording.error().message};
  return recording->proof(key);
}

}  // namespace insonate
