#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>
#include <insonate/curriculum/Standings.h>

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace insonate {

/// A member of a cohort (class), with a summary of the member's progress.
struct Member {
  Person person{};
  /// true: an instructor of this cohort, whose fields about attempts stay empty; false: a learner
  bool teaches = false;
  int attempts = 0;  ///< number of the member's attempts that count (Judgement.h), including free practice
  /// Counter that increases with each attempt of the member that is ended or voided. If the counter differs from
  /// Standing::changes, the standing is outdated.
  std::int64_t changes = 0;
  std::optional<std::int64_t> lastAttempt_us{};  ///< time at which the newest attempt was begun
  std::string lastLevel{};                       ///< level of the newest attempt (AttemptFacts::level)
  /// Stored progress of the member; empty: never computed, or computed for another curriculum version than the
  /// cohort's.
  std::optional<Standing> standing{};
  bool standingIsCurrent = false;  ///< true: computing `standing` now would give the same
};

/// Membership of a person in a cohort.
struct Membership {
  Cohort cohort{};
  bool teaches = false;  ///< true: as an instructor of the cohort; false: as a learner
};

/// Access to cohorts (classes) and their members, with the permissions of a signed-in user. Instructors see their own
/// cohorts, administrators see all; trainees see their own cohorts without the other members. If the workstation
/// belongs to a server, cohorts can be changed on the server only.
class CohortStore {
 public:
  explicit CohortStore(SignedIn by) : by_(std::move(by)) {}

  /// Returns the cohorts that the signed-in user may see, sorted by name; archived cohorts come last.
  Result<std::vector<Cohort>> cohorts() const;
  /// Returns the members of a cohort: instructors, then learners, each sorted by full name, or by sign-in name if there
  /// is no full name.
  Result<std::vector<Member>> members(const std::string& cohort) const;
  /// Returns those cohorts of a person that the signed-in user may see, sorted by name. Fails if the user may not see
  /// the person.
  Result<std::vector<Membership>> listByPerson(const std::string& person) const;

  /// Adds a cohort. The name has 1 to 200 characters and is unique, ignoring case. Administrators only.
  Result<Cohort> add(const std::string& name) const;
  Result<void> rename(const std::string& cohort, const std::string& name) const;
  /// Archives a cohort, or restores it. An archived cohort keeps its members, attempts and results, and its instructors
  /// still see them; it takes neither new members nor another curriculum nor openings of tests. Openings of its tests
  /// are closed. Administrators only.
  Result<void> archive(const std::string& cohort, bool archived) const;
  /// Deletes a cohort and its memberships, and closes openings of its tests; accounts, attempts and the audit log stay.
  /// Fails if `name` is not the cohort's name, so that no other cohort is deleted by mistake. Administrators only.
  Result<void> remove(const std::string& cohort, const std::string& name) const;
  /// Adds a person to a cohort as instructor (`teaches` is true) or learner (false). The role of an existing member is
  /// changed accordingly. Administrators only, since membership opens a person's attempts to the cohort's instructors.
  /// Trainees cannot be instructors.
  Result<void> join(const std::string& cohort, const std::string& person, bool teaches) const;
  /// Removes a person from a cohort. Administrators may remove anyone, the cohort's instructors only learners.
  Result<void> leave(const std::string& cohort, const std::string& person) const;

  /// Sets the published curriculum version by which the cohort is taught. For the cohort's instructors and for
  /// administrators.
  Result<void> setCurriculum(const std::string& cohort, const std::string& curriculum, int version) const;

  /// Returns the progress (Standing) of those of `people` who are learners of the cohort, in the cohort's curriculum,
  /// by Person::id. A stored standing is used if it is current. A standing that is missing (as that of a new member) or
  /// outdated is computed from all attempts of the person and stored. A standing becomes outdated by new attempts, by
  /// the passage of days, and by a change of the curriculum. Each call makes one entry in the audit log, which names
  /// `people`.
  Result<std::map<std::string, Standing>> standings(const std::string& cohort,
                                                    std::span<const std::string> people) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
