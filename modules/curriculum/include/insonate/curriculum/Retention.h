#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/FilesToDelete.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// Rule by which old data are deleted. Months are calendar months, 1 to 1200; empty: never.
struct RetentionRule {
  /// A trainee is erased (PersonData::erase()) this long after the last activity: sign-in, other use of the database,
  /// or attempt. Before a first activity, the time counts from the day on which the rule was set.
  std::optional<int> erase_months{};
  std::optional<int> recording_months{};  ///< a recording and its video are deleted this long after the attempt began

  bool operator==(const RetentionRule&) const = default;
};

/// Data that a retention rule deletes, or would delete now.
struct RetentionDue {
  struct Trainee {
    Person person{};
    std::int64_t last_us = 0;  ///< time of the last activity
  };
  std::vector<Trainee> trainees{};  ///< trainees to be erased, the longest inactive first
  /// ids of attempts whose recordings in this database's folder of recordings are to be deleted
  std::vector<std::string> attempts{};
};

/// Retention of personal data, for administrators. Workstations follow the rule of their server.
class Retention {
 public:
  explicit Retention(SignedIn by) : by_(std::move(by)) {}

  Result<RetentionRule> rule() const;
  /// Sets the rule. RetentionSchedule applies the new rule after a day at the earliest, so that a mistake can be
  /// corrected.
  Result<void> setRule(const RetentionRule& rule) const;
  /// Returns the data that a rule would delete if it were applied now. Deletes nothing.
  Result<RetentionDue> preview(const RetentionRule& rule) const;
  /// Applies the stored rule now, and returns the deleted data. Videos of the attempts are deleted later, by the
  /// servers (RetentionSchedule).
  Result<RetentionDue> deleteExpired() const;

 private:
  SignedIn by_;
};

/// Applies the stored retention rule once a day in a server, without a signed-in user. The object must be used on one
/// thread only.
class RetentionSchedule {
 public:
  explicit RetentionSchedule(CurriculumStore store) : store_(std::move(store)) {}

  /// Applies the rule if a day has passed since the rule was set or last applied. If several servers share the
  /// database, only one of them applies the rule. If more than a week has passed, the clock may be wrong; the rule is
  /// then applied one day later. If this or another program has applied the rule since the last call, the function
  /// deletes the recordings that the rule concerns from this database's folder of recordings, and returns their
  /// attempts, whose videos the server must delete. Otherwise it returns no attempts. Fails only if the database cannot
  /// be read or written.
  Result<FilesToDelete> applyDaily();

 private:
  Result<void> applyIfDue();

  CurriculumStore store_;
  std::int64_t removed_us_ = 0;  ///< time of the application after which files were last deleted
};

}  // namespace insonate
