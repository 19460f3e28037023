#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Person.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// Name of a role in the tables.
std::string_view nameOf(Role role);
Role roleNamed(std::string_view name);
/// Name of a state in the tables. Voided has no name: being voided is stored in addition to how the attempt ended.
std::string_view nameOf(AttemptState state);
AttemptState stateNamed(std::string_view name);

}  // namespace insonate::store
