#pragma once

#include "store/Core.h"

#include <insonate/core/Result.h>
#include <insonate/curriculum/Person.h>

#include <cstdint>
#include <string>

namespace insonate::store {

/// A person whose password was verified.
struct Known {
  Person person{};
  std::string hashed{};
  std::int64_t passwordVersion = 0;
  bool mustChange = false;
};

/// As CurriculumStore::signIn(): counted before the password is looked at, logged, and after the same time whether the
/// name is known or not.
Result<Known> provePassword(Core& core, const std::string& name, const std::string& password);

}  // namespace insonate::store
