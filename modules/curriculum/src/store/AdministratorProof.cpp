#include "store/AdministratorProof.h"

#include "store/PasswordProof.h"

namespace insonate::store {

Result<bool> hasPeople(Core& core) {
  const auto connection = core.connection();
  if (!connection) return tl::unexpected(connection.error());
  const auto rows = (*connection)->rows("SELECT id FROM people LIMIT 1", {});
  if (!rows) return fail(core.place() + " contains no users yet. Make a store with 'insonate-cli curriculum setup'.");
  return !rows->empty();
}

Result<Person> proveAdministrator(Core& core, const std::string& name, const std::string& password) {
  const auto known = provePassword(core, name, password);
  if (!known) return tl::unexpected(known.error());
  if (known->person.role != Role::Administrator)
    return fail(name + " is not an administrator of " + core.place() + "; ask one of its administrators.");
  if (known->mustChange)
    return fail("Another user has set the password of " + name + ". This person must first choose a new password.");
  return known->person;
}

}  // namespace insonate::store
