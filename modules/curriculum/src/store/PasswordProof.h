#pragma once

#include "store/Core.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/Person.h>

#include <cstdint>
#include <string>

namespace insonate::store {

/// A person whose password was verified, with the stored password data.
struct Known {
  Person person{};
  std::string hashed{};
  std::int64_t passwordVersion = 0;
  bool mustChange = false;
};

/// Verifies name and password for CurriculumStore::signIn(). Each try is logged, and failures are counted. Tries with
/// one name wait for each other. The verification takes the same time for known and unknown names. `address`: network
/// address of the browser, or "".
Result<Known> provePassword(Core& core, const std::string& name, const std::string& password,
                            const std::string& address = {});

}  // namespace insonate::store
