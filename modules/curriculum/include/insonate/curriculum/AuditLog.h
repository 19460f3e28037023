#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// One entry of the audit log: an access to another person's data, a change, or a refused request.
struct AuditEntry {
  std::int64_t number = 0;  ///< number of the entry, consecutive, from 1
  std::int64_t time_us = 0;
  std::string actor{};  ///< user who acted (Person::id); "": no user was signed in
  std::string workstation{};
  std::string act{};     ///< kind of access: "see attempts", "void attempt", "sign in", ...
  std::string person{};  ///< person whose data the entry concerns; "": no particular person
  std::string detail{};
  bool allowed = true;
  std::string hash{};  ///< SHA-256 of this entry and the previous entry's hash

  bool operator==(const AuditEntry&) const = default;
};

/// Number and hash of the last entry of the audit log at some time. If a copy is kept elsewhere, verify() can later
/// detect whether the log was shortened or rewritten.
struct AuditAnchor {
  std::int64_t number = 0;
  std::string hash{};

  bool operator==(const AuditAnchor&) const = default;
};

/// Reads the audit log of all accesses to others' data and all changes. For administrators only.
class AuditLog {
 public:
  explicit AuditLog(SignedIn by) : by_(std::move(by)) {}

  /// Returns log entries, newest first: at most `count` (1 to 1000) entries whose number is below `before`; `before` 0:
  /// no limit. `person`: only entries by or about this person, including accesses to several people among whom the
  /// person is; "": all entries.
  Result<std::vector<AuditEntry>> page(int count, std::int64_t before = 0, const std::string& person = "") const;
  /// Returns the number and hash of the last entry, to be kept outside of the database.
  Result<AuditAnchor> anchor() const;
  /// Checks the log. Fails with a sentence about the first inconsistent entry if an entry was changed, deleted or
  /// moved, if the end of the log is missing, or if the log differs from one of `anchors`. A person who can write the
  /// database and knows how the hashes are made can rewrite the log; only an anchor kept elsewhere (AuditAnchors)
  /// reveals that, and only for entries up to its number.
  Result<void> verify(const std::vector<AuditAnchor>& anchors = {}) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
