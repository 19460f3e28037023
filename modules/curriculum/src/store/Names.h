#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Person.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// Name in the tables.
std::string_view nameOf(Role role);
Role roleNamed(std::string_view name);
/// Names a state. Voided is not among them: an attempt is voided besides being ended.
std::string_view nameOf(AttemptState state);
AttemptState stateNamed(std::string_view name);

}  // namespace insonate::store
