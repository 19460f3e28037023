#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/AttemptStore.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A stored value that does not follow from its source: a recording, the attempts, or the audit log.
struct StoreDifference {
  std::string attempt{};  ///< AttemptFacts::id; "": of a standing
  std::string person{};   ///< Person::id
  std::string field{};    ///< for people: "points", "metric needle_path_mm", "standing in central_line 5: level"
  std::string stored{};
  std::string expected{};  ///< what follows

  bool operator==(const StoreDifference&) const = default;
};

/// Looks for rows that were written past the program. Administrators only; each look is in the audit log.
class StoreCheck {
 public:
  explicit StoreCheck(SignedIn by) : by_(std::move(by)) {}

  /// Everyone's, in the order of arrival: at most `count` (1..1000) that came after arrival `after`.
  Result<std::vector<KeptAttempt>> attempts(std::int64_t after, int count) const;
  /// Attempts whose person, level, end or recording is not the one of their entries in the audit log, those without an
  /// entry, and entries whose attempt is gone. Programs before schema 3 made no entries: in a store of theirs attempts
  /// before the first one with an entry are left out.
  Result<std::vector<StoreDifference>> againstLog() const;
  /// Standings that would be shown now and are not what the attempts give.
  Result<std::vector<StoreDifference>> standings() const;

 private:
  SignedIn by_;
};

}  // namespace insonate
