#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/AttemptSeal.h>
#include <insonate/curriculum/Curriculum.h>
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
/// takeNext() assigns an attempt to one server. If that server does not call storeResult() within two minutes, the
/// attempt can be assigned again. May be used on any thread.
class VerificationQueue {
 public:
  explicit VerificationQueue(CurriculumStore server) : server_(std::move(server)) {}

  /// Assigns an attempt to the calling server and returns it: the attempt whose recording has waited longest. Attempts
  /// that were assigned before without a result come last. Empty if no attempt waits.
  Result<std::optional<WaitingAttempt>> takeNext() const;
  /// Tells whether this workstation issued `nonce` to the attempt with the id, person and level of `facts`.
  Result<NonceOrigin> originOf(const std::string& workstation, const AttemptFacts& facts,
                               const std::string& nonce) const;
  /// Returns the level at which an attempt was made; empty for free practice, and if its curriculum is not on this
  /// server.
  Result<std::optional<Level>> levelOf(const AttemptFacts& facts) const;
  /// Stores the result of a verification in the attempt (Proven, or Unproven with the reason) and in the audit log.
  Result<void> storeResult(const std::string& attempt, bool isVerified, const std::string& why) const;
  /// Returns the number of attempts that wait for verification, including those whose recording has not arrived yet.
  Result<std::int64_t> waiting() const;

 private:
  CurriculumStore server_;
};

}  // namespace insonate
