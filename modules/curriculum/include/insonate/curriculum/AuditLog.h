#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// One logged access to others' data, change or refusal.
struct AuditEntry {
  std::int64_t number = 0;  ///< 1, 2, 3, ...
  std::int64_t time_us = 0;
  std::string actor{};  ///< Person::id; "": no user was signed in
  std::string workstation{};
  std::string act{};     ///< "see attempts", "void attempt", "sign in", ...
  std::string person{};  ///< person whose data it concerns; "": no particular person
  std::string detail{};
  bool allowed = true;
  std::string hash{};  ///< SHA-256 of this entry and the previous entry's hash

  bool operator==(const AuditEntry&) const = default;
};

/// The end of a log at one time. A copy stored elsewhere shows later whether the log was shortened or rewritten.
struct AuditAnchor {
  std::int64_t number = 0;
  std::string hash{};

  bool operator==(const AuditAnchor&) const = default;
};

/// Log of all accesses to others' data and changes of it. Administrators only.
class AuditLog {
 public:
  explicit AuditLog(SignedIn by) : by_(std::move(by)) {}

  /// Returns the newest entries first: at most `count` (1..1000) with numbers below `before`; 0: the newest of all.
  /// `person`: only entries by or about this person, including accesses to several people that name the person; "":
  /// all.
  Result<std::vector<AuditEntry>> page(int count, std::int64_t before = 0, const std::string& person = "") const;
  Result<AuditAnchor> anchor() const;
  /// Fails with the first inconsistent entry: an entry was changed, deleted or moved, the end is cut off, or the log
  /// differs from the anchor. A person who can write the database and knows how the hashes are made can rewrite the
  /// log; only an anchor kept elsewhere reveals that, and only up to its number.
  Result<void> verify(const AuditAnchor& anchor = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
