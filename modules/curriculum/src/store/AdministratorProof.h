#pragma once

#include "store/Core.h"

#include <insonate/curriculum/Person.h>

#include <string>

namespace insonate::store {

/// Tells whether the store, of any schema, has an account. Fails on a file that is not a store.
Result<bool> hasPeople(Core& core);

/// Like provePassword(), for an administrator with a password of their own choice. Works on a store of any schema.
Result<Person> proveAdministrator(Core& core, const std::string& name, const std::string& password);

}  // namespace insonate::store
