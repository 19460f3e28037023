#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A stored value that does not agree with its source: a recording, the attempts, or the audit log.
struct StoreDifference {
  std::string attempt{};  ///< AttemptFacts::id; "": the difference is in a standing
  std::string person{};   ///< Person::id
  /// Readable description: "points", "metric needle_path_mm", "standing in central_line 5: level".
  std::string field{};
  std::string stored{};
  std::string expected{};  ///< value that follows from the source

  bool operator==(const StoreDifference&) const = default;
};

/// Finds rows that were not written by the program. Administrators only; each check is in the audit log.
class StoreCheck {
 public:
  explicit StoreCheck(SignedIn by) : by_(std::move(by)) {}

  /// Returns attempts of all people, in the order of arrival: at most `count` (1..1000) that arrived after number
  /// `after`.
  Result<std::vector<KeptAttempt>> attempts(std::int64_t after, int count) const;
  /// Returns attempts whose person, level, end or recording differs from their entries in the audit log, attempts
  /// without an entry, and entries without an attempt. Programs before schema 3 made no entries: in a store that such a
  /// program used, attempts before the first attempt with an entry are left out.
  Result<std::vector<StoreDifference>> againstLog() const;
  /// Returns standings that would be shown now but do not follow from the attempts.
  Result<std::vector<StoreDifference>> standings() const;

 private:
  SignedIn by_;
};

}  // namespace insonate
