#pragma once

#include "store/Core.h"
#include "store/sql/Transaction.h"

#include <insonate/curriculum/CurriculumStore.h>
#include <insonate/curriculum/Person.h>

#include <optional>
#include <string>

namespace insonate::store {

/// Columns of people that personOf() reads.
#define INSONATE_PERSON_COLUMNS "people.id, people.name, people.full_name, people.email, people.role, people.disabled"

Person personOf(const Row& row, std::size_t first = 0);
std::optional<Person> findPerson(Transaction& transaction, const std::string& id);

Result<void> checkPerson(const Person& person);
/// Fails if another person has the name.
Result<void> checkNameIsFree(Transaction& transaction, const Person& person);
/// Inserts a person with an already hashed password; checks both names.
Result<Person> insertPerson(Transaction& transaction, const NewPerson& person, const std::string& hashed,
                            bool mustChange);

/// Adds a person to a cohort as a learner or teacher; an existing member is changed to the given kind. Trainees do not
/// teach.
Result<void> putIntoCohort(Transaction& transaction, const std::string& cohort, const Person& person, bool teaches);

/// Sets a new password, which ends sessions of the old password.
void setPassword(Transaction& transaction, const std::string& person, const std::string& hashed, bool mustChange);

}  // namespace insonate::store
