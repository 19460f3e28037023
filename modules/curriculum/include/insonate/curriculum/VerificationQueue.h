#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>
#include <insonate/curriculum/CurriculumStore.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace insonate {

/// An attempt of a workstation whose recording has arrived.
struct WaitingAttempt {
  AttemptFacts facts{};
  std::filesystem::path recording{};
};

/// Attempts that wait for the server to compute them again from their recordings. Several servers may share a database.
/// One server takes an attempt; any server can take the attempt again if the first one has not concluded it within two
/// minutes. May be used on any thread.
class VerificationQueue {
 public:
  explicit VerificationQueue(CurriculumStore server) : server_(std::move(server)) {}

  /// Takes the attempt whose recording has waited longest; empty if none waits.
  Result<std::optional<WaitingAttempt>> takeNext() const;
  /// Tells whether this workstation issued `nonce` to the attempt with the id, person and level of `facts`.
  Result<NonceOrigin> originOf(const std::string& workstation, const AttemptFacts& facts,
                               const std::string& nonce) const;
  /// Stores the result of a verification in the attempt (Proven, or Unproven with the reason) and in the audit log.
  Result<void> storeResult(const std::string& attempt, bool isVerified, const std::string& why) const;
  /// Returns the number of attempts that wait, with or without their recordings.
  Result<std::int64_t> waiting() const;

 private:
  CurriculumStore server_;
};

}  // namespace insonate
