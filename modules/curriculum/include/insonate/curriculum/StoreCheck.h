#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A value in the database that does not agree with the data from which the value was computed: a recording, the
/// attempts, or the audit log.
struct StoreDifference {
  /// attempt concerned (AttemptFacts::id); "": the difference is in a standing (progress of a trainee)
  std::string attempt{};
  std::string person{};  ///< person concerned: Person::id
  /// Name of the value, e.g. "points" or "metric needle_path_mm". For a standing in version 5 of the curriculum
  /// central_line: "standing in central_line 5: level".
  std::string field{};
  std::string stored{};
  std::string expected{};  ///< value computed from the recording, the attempts or the audit log

  bool operator==(const StoreDifference&) const = default;
};

/// Finds data in the database that were changed by other means than this program. For administrators only; each check
/// makes an entry in the audit log.
class StoreCheck {
 public:
  explicit StoreCheck(SignedIn by) : by_(std::move(by)) {}

  /// Returns attempts of all people, in the order of StoredAttempt::arrival: at most `count` (1 to 1000) with an
  /// arrival above `after`.
  Result<std::vector<StoredAttempt>> attempts(std::int64_t after, int count) const;
  /// Returns attempts whose person, level, end or recording differs from their entries in the audit log, attempts
  /// without an entry, and entries without an attempt. Programs before schema 3 made no entries: in a database from
  /// such a program, attempts before the first one with an entry are left out.
  Result<std::vector<StoreDifference>> againstLog() const;
  /// Compares the stored current standings (progress of trainees) with standings computed from the attempts, and
  /// returns the differences.
  Result<std::vector<StoreDifference>> standings() const;

 private:
  SignedIn by_;
};

}  // namespace insonate
