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

/// A row of a cohort's list.
struct Member {
  Person person{};
  bool teaches = false;  ///< an instructor of this cohort; for instructors, the fields on attempts stay empty
  int attempts = 0;      ///< number of attempts that count (Judgement.h), including free practice
  /// Number that grows with each attempt that is ended or voided, to detect an outdated Standing.
  std::int64_t changes = 0;
  std::optional<std::int64_t> lastAttempt_us{};  ///< time at which the newest attempt was begun
  std::string lastLevel{};                       ///< AttemptFacts::level of the newest attempt
  /// Empty: never computed, or computed for another curriculum version than the cohort's.
  std::optional<Standing> standing{};
  bool standingIsCurrent = false;  ///< computing the standing now would give the same
};

/// Cohorts and their members. Visible to their instructors and to administrators; a trainee sees the trainee's own
/// cohorts without their members. On a workstation that belongs to a server, cohorts are changed on the server.
class CohortStore {
 public:
  explicit CohortStore(SignedIn by) : by_(std::move(by)) {}

  /// Returns the cohorts that the user may see, by name.
  Result<std::vector<Cohort>> cohorts() const;
  /// Returns the instructors first; within each group by full name, or by name if there is no full name.
  Result<std::vector<Member>> members(const std::string& cohort) const;

  /// Adds a cohort. The name has 1..200 characters and is unique, ignoring case. Administrators only.
  Result<Cohort> add(const std::string& name) const;
  Result<void> rename(const std::string& cohort, const std::string& name) const;
  /// Adds a person as learner or teacher; an existing member is changed to the given kind. Administrators only, since
  /// membership opens a person's attempts to the cohort's instructors. Trainees do not teach.
  Result<void> join(const std::string& cohort, const std::string& person, bool teaches) const;
  /// Removes a person. For administrators, and for the cohort's instructors if the person learns in it.
  Result<void> leave(const std::string& cohort, const std::string& person) const;

  /// Sets the published curriculum version by which the cohort is taught. For the cohort's instructors and for
  /// administrators.
  Result<void> setCurriculum(const std::string& cohort, const std::string& curriculum, int version) const;

  /// Returns the standings of a cohort's learners under its curriculum, by Person::id. A stored standing is used if it
  /// is current; otherwise it is computed from all attempts of the person and stored. Ending or voiding an attempt
  /// updates the standing at once; this function also takes into account the passage of days, a changed curriculum and
  /// new members. People who left the cohort are not included. The call counts as one access and makes one entry in the
  /// log, which names all people.
  Result<std::map<std::string, Standing>> standings(const std::string& cohort,
                                                    std::span<const std::string> people) const;

 private:
  SignedIn by_;
};

}  // namespace insonate
