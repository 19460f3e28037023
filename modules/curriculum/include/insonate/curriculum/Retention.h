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

/// Data that a rule concerns now.
struct RetentionDue {
  struct Trainee {
    Person person{};
    std::int64_t last_us = 0;  ///< time of the last activity
  };
  std::vector<Trainee> trainees{};  ///< to be erased, the longest inactive first
  std::vector<std::string>
      attempts{};  ///< ids of attempts whose recordings in this database's folder are to be deleted
};

/// Retention of personal data, for administrators. Workstations follow the rule of their server.
class Retention {
 public:
  explicit Retention(SignedIn by) : by_(std::move(by)) {}

  Result<RetentionRule> rule() const;
  /// Sets the rule. A server applies it a day later at the earliest.
  Result<void> setRule(const RetentionRule& rule) const;
  /// Returns what a rule would delete now.
  Result<RetentionDue> preview(const RetentionRule& rule) const;
  /// Applies the stored rule now, and returns what was deleted. Videos are deleted by the servers.
  Result<RetentionDue> apply() const;

 private:
  SignedIn by_;
};

/// Applies the rule for a server, without a user. Owned by one thread.
class RetentionSchedule {
 public:
  explicit RetentionSchedule(CurriculumStore store) : store_(std::move(store)) {}

  /// Applies the rule if it has waited for a day; several servers agree by the database which of them does. A rule that
  /// has waited for more than a week, perhaps since a clock jumped, waits for another day. After the rule was applied
  /// by any program, deletes the recordings in this database's folder that are due, and returns the attempts whose
  /// videos must be deleted; otherwise empty. Fails only if the database fails.
  Result<FilesToDelete> applyDaily();

 private:
  Result<void> applyIfDue();

  CurriculumStore store_;
  std::int64_t removed_us_ = 0;  ///< time of the application after which files were last deleted
};

}  // namespace insonate
