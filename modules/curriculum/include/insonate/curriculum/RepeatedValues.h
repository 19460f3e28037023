#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <set>
#include <string>

namespace insonate {

/// Returns the ids of a person's attempts whose metrics are exactly equal to those of an earlier attempt of any person
/// (Implausible::SameValues). Attempts in which the needle did not reach the skin are ignored. The function does not
/// disclose who made the earlier attempt. Allowed to users who may call AttemptStore::history() for the person.
Result<std::set<std::string>> repeatedValues(const SignedIn& by, const std::string& person);

}  // namespace insonate
