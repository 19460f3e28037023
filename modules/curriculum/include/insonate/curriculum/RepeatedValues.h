#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/SignedIn.h>

#include <set>
#include <string>

namespace insonate {

/// The ids of someone's attempts whose metrics are those of an earlier attempt of whomever, to the last digit
/// (Implausible::SameValues); attempts without a pass of the needle tell too little. Whose the earlier one is, is not
/// told. For whom AttemptStore::history() answers.
Result<std::set<std::string>> repeatedValues(const SignedIn& by, const std::string& person);

}  // namespace insonate
