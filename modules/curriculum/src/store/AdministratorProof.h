#pragma once

#include "store/Core.h"

#include <insonate/curriculum/Person.h>

#include <string>

namespace insonate::store {

/// Whether there is an account in the store, whatever its schema. Fails where it is no store.
Result<bool> hasPeople(Core& core);

/// As provePassword(), by an administrator who has chosen their password. Works on a store of any schema.
Result<Person> proveAdministrator(Core& core, const std::string& name, const std::string& password);

}  // namespace insonate::store
