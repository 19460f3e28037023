#pragma once

#include "store/Core.h"

#include <insonate/curriculum/Person.h>

#include <string>

namespace insonate::store {

/// Tells whether a database, of any schema, has an account. Fails on a file that is no curriculum database.
Result<bool> hasPeople(Core& core);

/// Verifies name and password of an administrator like provePassword(), on a database of any schema. Fails for a
/// password that the administrator must still change.
Result<Person> proveAdministrator(Core& core, const std::string& name, const std::string& password);

}  // namespace insonate::store
