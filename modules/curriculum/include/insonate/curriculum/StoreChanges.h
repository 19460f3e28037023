#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <set>
#include <string>

namespace insonate {

/// Detects changes of people, classes, attempts, forms, tests and comments in the database, made by any program, so
/// that windows and pages can update themselves. Reads the new entries of the audit log, which is cheap enough to be
/// done every few seconds. Needs no permission, since ids alone disclose nothing. For one thread at a time.
class StoreChanges {
 public:
  /// `after`: number of an entry of the audit log; only later changes are reported. -1: only changes after the first
  /// call of readChanges() are reported.
  explicit StoreChanges(SignedIn by, std::int64_t after = -1) : by_(std::move(by)), lastEntry_(after) {}

  /// Returns the ids of the people whose data have changed since the previous call (Person::id); "" among them stands
  /// for a change that concerns no particular person, such as a new class. Sign-ins and views of data are no changes.
  Result<std::set<std::string>> readChanges();
  /// Returns the number of the newest entry of the audit log at the last call of readChanges(); -1: no call yet.
  std::int64_t number() const { return lastEntry_; }

 private:
  SignedIn by_;
  std::int64_t lastEntry_;
};

}  // namespace insonate
