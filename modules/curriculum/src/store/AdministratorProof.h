#pragma once

#include "store/Core.h"

#include <insonate/curriculum/Person.h>

#include <string>

namespace insonate::store {

/// Tells whether the store, of any schema, has an account. Fails on a file that is not a store.
Result<bool> hasPeople(Core& core);

/// Verifies a password as provePassword() does, for an administrator who has chosen the password. Works on a store of
/// any schema.
Result<Person> proveAdministrator(Core& core, const std::string& name, const std::string& password);

}  // namespace insonate::store
