#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/Person.h>
#include <insonate/curriculum/SignedIn.h>

#include <string>
#include <vector>

namespace insonate {

/// Returns the people of CohortStore::members(), sorted by id, for a page whose content another user has read. Checks
/// the permissions of CohortStore::members() and of AttemptStore::recentOfCohort(), and makes the entries of both in
/// the audit log. `isRefresh`: a page asks without its user; one entry an hour then stands for all such requests.
Result<std::vector<Person>> seeClass(const SignedIn& by, const std::string& cohort, bool isRefresh);

}  // namespace insonate
