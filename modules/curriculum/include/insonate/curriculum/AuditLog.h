#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// One access to others' data, one change, or one refusal.
struct AuditEntry {
  std::int64_t number = 0;  ///< 1, 2, 3, ...
  std::int64_t time_us = 0;
  std::string actor{};  ///< Person::id; "": nobody was signed in
  std::string workstation{};
  std::string act{};     ///< "see attempts", "void attempt", "sign in", ...
  std::string person{};  ///< whose data; "": no one's in particular
  std::string detail{};
  bool allowed = true;
  std::string hash{};  ///< SHA-256 of this entry and the hash of the one before

  bool operator==(const AuditEntry&) const = default;
};

/// The end of a log at one time. Kept elsewhere, it shows later whether the log was shortened or rewritten.
struct AuditAnchor {
  std::int64_t number = 0;
  std::string hash{};

  bool operator==(const AuditAnchor&) const = default;
};

/// The log of all that was done to others' data. Administrators only.
class AuditLog {
 public:
  explicit AuditLog(SignedIn by) : by_(std::move(by)) {}

  /// Newest first, at most `count` (1..1000) before number `before`; 0: the newest. `person`: those by or about them,
  /// and looks at several people that name them; "": all.
  Result<std::vector<AuditEntry>> page(int count, std::int64_t before = 0, const std::string& person = "") const;
  Result<AuditAnchor> anchor() const;
  /// Fails with the first inconsistent entry: changed, deleted or moved, the end cut off, or different from the
  /// anchor. A person who can write the database and knows how the hashes are made can rewrite the log; only an anchor
  /// kept elsewhere reveals that, and only up to its number.
  Result<void> verify(const AuditAnchor& anchor = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
