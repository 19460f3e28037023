#pragma once

#include <insonate/curriculum/AttemptFacts.h>
#include <insonate/curriculum/Person.h>

#include <string>
#include <string_view>

namespace insonate::store {

/// Returns the name of a role in the database tables.
std::string_view nameOf(Role role);
Role roleNamed(std::string_view name);
/// Returns the name of an attempt's state in the database tables. Voided has no name, since the database stores
/// separately how the attempt ended and that it was voided.
std::string_view nameOf(AttemptState state);
AttemptState stateNamed(std::string_view name);

}  // namespace insonate::store
