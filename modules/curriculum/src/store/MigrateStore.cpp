#include "store/AdministratorProof.h"

#include <insonate/curriculum/StoreUpkeep.h>

namespace insonate {

Result<void> migrateStore(const std::string& address, const std::string& administrator, const std::string& password,
                          const StoreServices& services) {
  const auto core = store::Core::reach(address, services);
  if (!core) return tl::unexpected(core.error());
  if (auto some = store::hasPeople(**core); !some) return tl::unexpected(some.error());
  if (auto known = store::proveAdministrator(**core, administrator, password); !known)
    return fail((*core)->place() + " was not migrated: " + known.error().message);
  return (*core)->bringUpToDate();
}

}  // namespace insonate
